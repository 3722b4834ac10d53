// How vtkPointSetContour runs: progress, abort, threads.

#include "FilterTest.h"

#include "vtkPointSetContour.h"

#include "Sampling.h"
#include "Torus.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

double z(const Vector3d& p)
{
  return p.z();
}

vtkSmartPointer<vtkPolyData> torusCloud(int count)
{
  return makeCloud(Truth::randomTorus(count, Truth::Torus::Closed, 1), z);
}

void chooseTwentyValues(vtkPointSetContour* filter)
{
  for (int i = 0; i < 20; ++i)
  {
    filter->SetContourValues(i, -0.38 + 0.04 * i);
  }
}

} // namespace

// Progress never falls, comes in many steps and ends at 1.
TEST(ContourExecution, showsProgress)
{
  std::vector<double> shown;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&shown);
  observer->SetCallback([](vtkObject*, unsigned long, void* list, void* fraction)
    { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(fraction)); });
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud(100000));
  chooseTwentyValues(filter);
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  expectSilentSuccess(update(filter));

  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_GT(shown.size(), 20u);
  ASSERT_FALSE(shown.empty());
  EXPECT_EQ(shown.back(), 1.0);
  const auto inPart = [&](double from, double to)
  {
    return std::any_of(shown.begin(), shown.end(),
      [=](double fraction) { return fraction > from && fraction < to; });
  };
  EXPECT_TRUE(inPart(0.05, 0.5));
  EXPECT_TRUE(inPart(0.5, 1.0));
}

// Stopped anywhere, the filter leaves nothing and says nothing; run again, it does all its work.
TEST(ContourExecution, leavesNothingWhenStopped)
{
  const auto cloud = torusCloud(200000);
  for (const double fraction : { 0.01, 0.2, 0.45, 0.7, 0.9 })
  {
    SCOPED_TRACE(fraction);
    vtkNew<vtkPointSetContour> filter;
    filter->SetInputData(cloud);
    chooseTwentyValues(filter);
    expectNothingWhenStopped(filter, fraction);
    expectSilentSuccess(update(filter));
    EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(40));
  }
}

// The curves do not depend on the number of threads.
TEST(ContourExecution, isTheSameForEveryNumberOfThreads)
{
  const auto cloud = torusCloud(20000);
  std::vector<std::vector<Curve>> results;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkPointSetContour> filter;
    filter->SetInputData(cloud);
    chooseTwentyValues(filter);
    expectSilentSuccess(update(filter));
    results.push_back(curvesOf(filter));
  }
  vtkSMPTools::Initialize(0);
  ASSERT_EQ(results[0].size(), results[1].size());
  for (std::size_t i = 0; i < results[0].size(); ++i)
  {
    EXPECT_EQ(results[0][i].points, results[1][i].points);
    EXPECT_EQ(results[0][i].length, results[1][i].length);
  }
}
