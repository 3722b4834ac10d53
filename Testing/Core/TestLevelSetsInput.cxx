#include "CriticalPoints.h"
#include "Error.h"
#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <limits>

namespace SurfaceScalars::Truth
{
namespace
{

struct Input
{
  Points points = randomTorus(8000, Torus::Closed, 1);
  Values values = valuesOf(tiltedHeight(), this->points);
};

// Iso-values come back ascending and distinct, whatever their order; each gives the curves it gives
// alone.
TEST(LevelSetsInput, isoValuesMayComeInAnyOrder)
{
  const Input input;
  const Traced sorted = trace(input.points, input.values, at({ -0.5, -0.1, 0.3, 0.7 }));
  const Traced shuffled =
    trace(input.points, input.values, at({ 0.3, -0.5, 0.7, 0.3, -0.1, -0.5, 0.3 }));
  EXPECT_EQ(shuffled.levelSets.isoValues, (std::vector<double>{ -0.5, -0.1, 0.3, 0.7 }));
  EXPECT_TRUE(identical(sorted.levelSets, shuffled.levelSets));

  const Traced alone = trace(input.points, input.values, at({ 0.3 }));
  std::size_t next = 0;
  for (const LevelSetCurve& curve : sorted.levelSets.curves)
  {
    if (curve.level == 2)
    {
      ASSERT_LT(next, alone.levelSets.curves.size());
      EXPECT_EQ(curve.length, alone.levelSets.curves[next++].length);
    }
  }
  EXPECT_EQ(next, alone.levelSets.curves.size());
}

// componentCounts are the numbers of curves per level; curves come by level and component, numbered
// from 0.
TEST(LevelSetsInput, countsComponents)
{
  const Input input;
  const Traced traced =
    trace(input.points, input.values, at({ -2.0, -0.9, -0.4, 0.0, 0.4, 0.9, 2.0 }));
  const LevelSets& levelSets = traced.levelSets;
  ASSERT_EQ(levelSets.componentCounts.size(), 7u);
  std::vector<int> counted(7, 0);
  for (const LevelSetCurve& curve : levelSets.curves)
  {
    EXPECT_EQ(curve.component, counted[curve.level]++);
  }
  EXPECT_EQ(levelSets.componentCounts, counted);
  EXPECT_EQ(counted.front(), 0); // below the minimum
  EXPECT_EQ(counted.back(), 0);  // above the maximum
  EXPECT_TRUE(std::is_sorted(levelSets.curves.begin(), levelSets.curves.end(),
    [](const LevelSetCurve& a, const LevelSetCurve& b) { return a.level < b.level; }));
}

// No iso-value, or none within the range: no curve and no sample, but no error.
TEST(LevelSetsInput, nothingToFindIsNoError)
{
  const Input input;
  for (const std::vector<double>& isoValues :
    { std::vector<double>{}, std::vector<double>{ -5.0 }, std::vector<double>{ 7.0, -5.0 } })
  {
    const Traced traced = trace(input.points, input.values, at(isoValues));
    EXPECT_EQ(traced.levelSets.isoValues.size(), isoValues.size());
    EXPECT_EQ(traced.levelSets.componentCounts, std::vector<int>(isoValues.size(), 0));
    EXPECT_TRUE(traced.levelSets.curves.empty());
    EXPECT_TRUE(traced.levelSets.samples.empty());
  }
}

// One thread and several give the same, bit for bit, with and without noise.
TEST(LevelSetsInput, isTheSameForAnyNumberOfThreads)
{
  Input input;
  const auto critical = criticalValues(tiltedHeight(), Torus::Closed);
  for (const double noise : { 0.0, 0.01 })
  {
    addNoise(input.values, noise, 2);
    const ContourParameters parameters = at(regularIsoValues(critical, 20, 0.01));
    const Traced one = trace(input.points, input.values, parameters, { 1, {} });
    for (const int threadCount : { 2, 3 })
    {
      const Traced more = trace(input.points, input.values, parameters, { threadCount, {} });
      EXPECT_TRUE(identical(one.levelSets, more.levelSets)) << noise << ", " << threadCount;
    }
  }
}

// The order of the samples does not matter: the same curves, point for point.
TEST(LevelSetsInput, isTheSameForAnyOrderOfTheSamples)
{
  const Input input;
  const Traced forwards = trace(input.points, input.values, at({ -0.3, 0.4 }));
  const Traced backwards =
    trace(input.points.rowwise().reverse(), input.values.reverse(), at({ -0.3, 0.4 }));
  EXPECT_TRUE(identical(forwards.levelSets, backwards.levelSets));
}

// Scaling space by a power of two scales the curves by it; scaling and shifting f with its
// iso-values keeps them.
TEST(LevelSetsInput, doesNotDependOnUnits)
{
  const Input input;
  const Traced traced = trace(input.points, input.values, at({ -0.3, 0.4 }));
  for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 20) })
  {
    const Traced scaled = trace(scale * input.points, input.values, at({ -0.3, 0.4 }));
    ASSERT_EQ(scaled.levelSets.curves.size(), traced.levelSets.curves.size());
    const Traced valued =
      trace(input.points, scale * input.values, at({ -0.3 * scale, 0.4 * scale }));
    ASSERT_EQ(valued.levelSets.curves.size(), traced.levelSets.curves.size());
    for (std::size_t i = 0; i < traced.levelSets.curves.size(); ++i)
    {
      const double length = traced.levelSets.curves[i].length;
      EXPECT_NEAR(scaled.levelSets.curves[i].length / scale, length, 1e-9 * length);
      EXPECT_NEAR(valued.levelSets.curves[i].length, length, 1e-9 * length);
    }
  }
}

// Map coordinates: moved by 4e6, where a double resolves 5e-10, the curves are the same to that.
TEST(LevelSetsInput, doesNotDependOnTheOffset)
{
  const Input input;
  const Vector3d offset(4e6, 4e6, -4e6);
  const Traced traced = trace(input.points, input.values, at({ -0.3, 0.4 }));
  const Traced moved = trace(input.points.colwise() + offset, input.values, at({ -0.3, 0.4 }));
  ASSERT_EQ(moved.levelSets.componentCounts, traced.levelSets.componentCounts);
  for (std::size_t i = 0; i < traced.levelSets.curves.size(); ++i)
  {
    EXPECT_EQ(moved.levelSets.curves[i].closed, traced.levelSets.curves[i].closed);
    EXPECT_NEAR(moved.levelSets.curves[i].length, traced.levelSets.curves[i].length, 1e-4);
  }
}

void expectRefused(const Input& input, const ContourParameters& parameters, const char* what)
{
  EXPECT_THROW(trace(input.points, input.values, parameters), InvalidInput) << what;
}

// Parameters that mean nothing are refused.
TEST(LevelSetsInput, refusesUnusableParameters)
{
  const Input input;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : { nan, infinity })
  {
    expectRefused(input, at({ 0.1, bad }), "iso-value");
  }
  for (const int degree : { 0, 5, -1 })
  {
    ContourParameters parameters = at({ 0.1 });
    parameters.polynomialDegree = degree;
    expectRefused(input, parameters, "polynomialDegree");
  }
  for (double ContourParameters::*field : { &ContourParameters::searchRadius,
         &ContourParameters::kernelWidth, &ContourParameters::linkDistance,
         &ContourParameters::tolerance, &ContourParameters::sampleSpacing })
  {
    for (const double bad : { -1.0, nan, infinity })
    {
      ContourParameters parameters = at({ 0.1 });
      parameters.*field = bad;
      expectRefused(input, parameters, "length");
    }
  }
  ContourParameters negativeCount = at({ 0.1 });
  negativeCount.neighborCount = -3;
  expectRefused(input, negativeCount, "neighborCount");
  ContourParameters noIterations = at({ 0.1 });
  noIterations.maximumIterations = 0;
  expectRefused(input, noIterations, "maximumIterations");
}

// Fewer samples than a fit needs, or values that are missing or not finite, are refused.
TEST(LevelSetsInput, refusesUnusableSamples)
{
  const Input input;
  for (const int count : { 2, 3, 4 })
  {
    EXPECT_THROW(
      trace(input.points.leftCols(count), input.values.head(count), at({ 0.1 })), InvalidInput)
      << count;
  }
  const NeighborGraph graph(input.points, NeighborQuery());
  EXPECT_THROW(traceLevelSets(graph, input.values.head(100), at({ 0.1 })), InvalidInput);
  Values bad = input.values;
  bad[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(traceLevelSets(graph, bad, at({ 0.1 })), InvalidInput);
}

// Progress never falls and ends at 1; refusing it at any time stops the tracing.
TEST(LevelSetsInput, reportsProgressAndAborts)
{
  const Input input;
  const NeighborGraph graph(input.points, NeighborQuery());
  const Values values = graph.average(input.values);
  std::vector<double> reported;
  const Execution watched{ 2,
    [&](double fraction)
    {
      reported.push_back(fraction);
      return true;
    } };
  traceLevelSets(graph, values, at({ -0.3, 0.1, 0.4 }), watched);
  ASSERT_GT(reported.size(), 5u);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1.0);
  for (const double limit : { 0.0, 0.3, 0.6, 0.99 })
  {
    const Execution stopped{ 2, [=](double fraction) { return fraction <= limit; } };
    EXPECT_THROW(traceLevelSets(graph, values, at({ -0.3, 0.1, 0.4 }), stopped), Aborted) << limit;
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
