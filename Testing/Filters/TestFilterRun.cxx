// What every filter promises when it succeeds, fails or is stopped, and how many threads it takes.

#include "FilterTest.h"

#include "Error.h"
#include "FilterRun.h"

#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSMPTools.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <new>
#include <stdexcept>
#include <thread>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

/// A filter that writes a point and then does what the test wants.
class WorkFilter : public vtkPolyDataAlgorithm
{
public:
  static WorkFilter* New();
  vtkTypeMacro(WorkFilter, vtkPolyDataAlgorithm);

  std::function<void(FilterRun&)> Work;

protected:
  WorkFilter() { this->SetNumberOfInputPorts(0); }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    return runFilter(*this, "Work Filter", outputs,
      [&](FilterRun& run)
      {
        vtkPolyData::GetData(outputs)->ShallowCopy(makeCloud(Points::Zero(3, 1)));
        this->Work(run);
      });
  }
};
vtkStandardNewMacro(WorkFilter);

/// The outcome of a filter that does this work.
struct Worker
{
  vtkNew<WorkFilter> filter;
  Outcome outcome;

  explicit Worker(std::function<void(FilterRun&)> work)
  {
    this->filter->Work = std::move(work);
    this->outcome = update(this->filter);
  }
};

/// The thread count of a filter that runs now.
int threadCount()
{
  int count = 0;
  const Worker worker([&](FilterRun& run) { count = run.execution().threadCount; });
  return count;
}

int coreCount()
{
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Sets an environment variable as long as it lives, and lets VTK's threads see it.
class Environment
{
public:
  Environment(const char* name, const char* value)
    : name_(name)
  {
    ::setenv(name, value, 1);
    vtkSMPTools::Initialize(0);
  }
  ~Environment()
  {
    ::unsetenv(this->name_);
    vtkSMPTools::Initialize(0);
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

private:
  const char* name_;
};

} // namespace

TEST(FilterRun, keepsTheOutputOfASuccess)
{
  const Worker worker([](FilterRun&) {});
  expectSilentSuccess(worker.outcome);
  EXPECT_EQ(worker.filter->GetOutput()->GetNumberOfPoints(), 1);
}

TEST(FilterRun, saysWhatTheCoreRefuses)
{
  const Worker worker([](FilterRun&) { throw InvalidInput("a fish", "a bird", "Go fishing."); });
  expectFailure(worker.filter, worker.outcome, "Work Filter",
    { "Work Filter: needs a fish, found a bird. Go fishing." });
}

TEST(FilterRun, turnsEveryExceptionIntoASentence)
{
  const Worker memory([](FilterRun&) { throw std::bad_alloc(); });
  expectFailure(
    memory.filter, memory.outcome, "Work Filter", { "needs more memory than there is" });
  const Worker other([](FilterRun&) { throw std::logic_error("the sky fell"); });
  expectFailure(other.filter, other.outcome, "Work Filter", { "the sky fell" });
}

TEST(FilterRun, notesWarnAfterSuccessAndEndTheError)
{
  const Worker success([](FilterRun& run) { run.note("Left out 2 of 5."); });
  expectWarning(success.outcome, { "Work Filter: Left out 2 of 5." });
  const Worker failure(
    [](FilterRun& run)
    {
      run.note("Left out 2 of 5.");
      throw InvalidInput("9 points", "3", "Get more.");
    });
  expectFailure(failure.filter, failure.outcome, "Work Filter",
    { "needs 9 points, found 3. Get more. Left out 2 of 5." });
}

TEST(FilterRun, isSilentAndEmptyAfterAnAbort)
{
  const Worker worker(
    [](FilterRun& run)
    {
      run.note("Left out 2 of 5.");
      run.filter().SetAbortExecute(1);
      run.execution().report(0.5);
      FAIL() << "went on after an abort";
    });
  EXPECT_THAT(worker.outcome.errors, ::testing::IsEmpty());
  EXPECT_THAT(worker.outcome.warnings, ::testing::IsEmpty());
  expectEmptyOutputs(worker.filter);
}

TEST(FilterRun, showsProgressThatNeverFalls)
{
  std::vector<double> shown;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&shown);
  observer->SetCallback([](vtkObject*, unsigned long, void* list, void* fraction)
    { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(fraction)); });
  vtkNew<WorkFilter> filter;
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Work = [](FilterRun& run)
  {
    for (const double fraction : { 0.1, 0.3, 0.2, 0.3001, 0.9 })
    {
      run.execution().report(fraction);
    }
  };
  expectSilentSuccess(update(filter));
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_THAT(shown, ::testing::IsSupersetOf({ 0.1, 0.3, 0.9 }));
}

// Users abort from within the event of progress: work that cannot say how far it is must let them.
TEST(FilterRun, canBeAbortedWhereProgressRests)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(
    [](vtkObject* running, unsigned long, void*, void* fraction)
    {
      if (*static_cast<double*>(fraction) == 0.5)
      {
        vtkAlgorithm::SafeDownCast(running)->SetAbortExecute(1);
      }
    });
  vtkNew<WorkFilter> filter;
  filter->Work = [&](FilterRun& run)
  {
    run.execution().report(0.5);
    filter->AddObserver(vtkCommand::ProgressEvent, observer);
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (std::chrono::steady_clock::now() < end)
    {
      run.execution().report(0.5);
    }
    FAIL() << "nobody was asked";
  };
  update(filter);
  expectEmptyOutputs(filter);
}

TEST(FilterRun, takesAllCoresByDefault)
{
  EXPECT_EQ(threadCount(), coreCount());
}

TEST(FilterRun, respectsTheEnvironment)
{
  const Environment limit("VTK_SMP_MAX_THREADS", "1");
  EXPECT_EQ(threadCount(), 1);
}

TEST(FilterRun, respectsInitialize)
{
  vtkSMPTools::Initialize(1);
  EXPECT_EQ(threadCount(), 1);
  vtkSMPTools::Initialize(1000000);
  EXPECT_EQ(threadCount(), coreCount());
  vtkSMPTools::Initialize(0);
}

TEST(FilterRun, respectsLocalScope)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 1 }, [] { EXPECT_EQ(threadCount(), 1); });
}

TEST(FilterRun, respectsABackendChosenByTheEnvironment)
{
  const Environment sequential("VTK_SMP_BACKEND_IN_USE", "Sequential");
  EXPECT_EQ(threadCount(), vtkSMPTools::GetEstimatedNumberOfThreads());
}
