#include "FilterRun.h"

#include "Error.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <new>
#include <thread>
#include <utility>

namespace SurfaceScalars
{
namespace
{

int threadsTheUserAllows()
{
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const vtkSMPTools::Config chosen(vtk::detail::smp::vtkSMPToolsAPI::GetInstance());
  if (chosen.MaxNumberOfThreads > 0)
  {
    return std::min(chosen.MaxNumberOfThreads, cores);
  }
  if (chosen.Backend != "Sequential" || std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    return std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
  }
  const char* limit = std::getenv("VTK_SMP_MAX_THREADS");
  const int most = limit ? std::atoi(limit) : 0;
  return most > 0 ? std::min(most, cores) : cores;
}

// Where VTK has CheckAbort() (9.1 has not), it also asks upstream and marks the output as aborted.
template <typename Algorithm>
auto shouldAbort(Algorithm& filter, int) -> decltype(filter.CheckAbort())
{
  return filter.CheckAbort();
}

template <typename Algorithm>
bool shouldAbort(Algorithm& filter, long)
{
  return filter.GetAbortExecute() != 0;
}

void empty(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputs, port))
    {
      output->Initialize();
    }
  }
}

} // namespace

FilterRun::FilterRun(vtkAlgorithm& filter, std::string speaker)
  : filter_(filter)
  , speaker_(std::move(speaker))
  , execution_{ threadsTheUserAllows(),
    [this](double fraction) { return this->proceed(fraction); } }
{
}

// Progress is shown in steps worth an event, and four times a second where it rests: it is in the
// event that users abort. What they do is seen at every call.
bool FilterRun::proceed(double fraction)
{
  constexpr double step = 0.01;
  constexpr std::chrono::milliseconds pause(250);
  const auto now = std::chrono::steady_clock::now();
  if (fraction >= this->shown_ + step || now >= this->shownAt_ + pause)
  {
    this->shown_ = std::max(this->shown_, fraction);
    this->shownAt_ = now;
    this->filter_.UpdateProgress(this->shown_);
  }
  return !shouldAbort(this->filter_, 0);
}

void FilterRun::warn(const std::string& sentence) const
{
  vtkWarningWithObjectMacro(&this->filter_, << this->speaker_ << ": " << sentence);
}

void FilterRun::note(const std::string& sentence)
{
  this->note_ += (this->note_.empty() ? "" : " ") + sentence;
}

int runFilter(vtkAlgorithm& filter, const std::string& speaker, vtkInformationVector* outputs,
  const std::function<void(FilterRun&)>& work)
{
  FilterRun run(filter, speaker);
  std::string failure;
  try
  {
    work(run);
    if (!run.note_.empty())
    {
      run.warn(run.note_);
    }
    return 1;
  }
  catch (const Aborted&)
  {
    empty(outputs);
    return 1;
  }
  catch (const Error& error)
  {
    failure = error.what();
  }
  catch (const std::bad_alloc&)
  {
    failure = "needs more memory than there is. Reduce the input or use a larger machine.";
  }
  catch (const std::exception& error)
  {
    failure = std::string("stopped for an unforeseen reason: ") + error.what();
  }
  empty(outputs);
  if (!run.note_.empty())
  {
    failure += " " + run.note_;
  }
  vtkErrorWithObjectMacro(&filter, << speaker << ": " << failure);
  return 0;
}

} // namespace SurfaceScalars
