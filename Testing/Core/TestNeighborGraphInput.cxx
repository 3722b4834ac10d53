#include "Error.h"
#include "NeighborGraph.h"
#include "Queries.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::nearest;
using Truth::randomPlane;
using Truth::randomTorus;
using Truth::Torus;
using Truth::within;

Execution threads(int threadCount)
{
  return { threadCount, {} };
}

bool equal(const NeighborGraph& a, const NeighborGraph& b)
{
  if (a.pointCount() != b.pointCount() || a.points() != b.points())
  {
    return false;
  }
  for (Index i = 0; i < a.pointCount(); ++i)
  {
    const Neighbors left = a.neighbors(i);
    const Neighbors right = b.neighbors(i);
    if (!std::equal(left.begin(), left.end(), right.begin(), right.end()) ||
      a.inputOfPoint(i) != b.inputOfPoint(i) || a.samplingStep(i) != b.samplingStep(i))
    {
      return false;
    }
  }
  return a.medianSamplingStep() == b.medianSamplingStep();
}

// Exact duplicates are one point: the graph of a multiset is that of its set, and values are
// averaged.
TEST(NeighborGraphInput, mergesDuplicates)
{
  const Points distinct = randomTorus(400, Torus::Closed, 7);
  Points repeated(3, 1200);
  repeated << distinct, distinct.rowwise().reverse(), distinct;
  const NeighborGraph graph(repeated, nearest(8));
  const NeighborGraph expected(distinct, nearest(8));
  EXPECT_TRUE(equal(graph, expected));
  EXPECT_EQ(graph.inputCount(), 1200u);

  Values values(1200);
  std::iota(values.begin(), values.end(), 0.0);
  const Values means = graph.average(values);
  for (Eigen::Index i = 0; i < 400; ++i)
  {
    const Index point = graph.pointOfInput(static_cast<std::size_t>(i));
    EXPECT_EQ(graph.pointOfInput(static_cast<std::size_t>(799 - i)), point);
    EXPECT_EQ(graph.pointOfInput(static_cast<std::size_t>(800 + i)), point);
    EXPECT_EQ(graph.inputOfPoint(point), static_cast<std::size_t>(i)); // the first
    EXPECT_NEAR(means[point], (i + (799.0 - i) + (800.0 + i)) / 3.0, 1e-9);
  }
}

// Duplicates are found even where the Morton cells are too coarse to tell their neighbors apart.
TEST(NeighborGraphInput, mergesDuplicatesInACrowdedCell)
{
  Points input(3, 301);
  for (int i = 0; i < 300; ++i)
  {
    input.col(i) = 1e-3 * Vector3d(i % 10, (i / 10) % 10, 0.0); // each place three times
  }
  input.col(300) = Vector3d(1e9, 1e9, 1e9);
  const NeighborGraph graph(input, nearest(4));
  EXPECT_EQ(graph.pointCount(), 101u);
}

// No point is its own neighbor, not even where distinct points fall together by rounding.
TEST(NeighborGraphInput, noPointIsItsOwnNeighbor)
{
  Points input = randomPlane(200, 8);
  for (int i = 0; i < 50; ++i)
  {
    input.col(i) =
      Vector3d(1e-25 * i, 1e-30 * i * i, 0.0); // distinct until the center is subtracted
  }
  for (const NeighborQuery& query : { nearest(8), within(0.3) })
  {
    const NeighborGraph graph(input, query);
    for (Index i = 0; i < graph.pointCount(); ++i)
    {
      EXPECT_FALSE(graph.isEdge(i, i));
      EXPECT_GT(graph.samplingStep(i), 0.0);
    }
  }
}

// The graph does not depend on the number of threads, bit for bit.
TEST(NeighborGraphInput, isTheSameForAnyNumberOfThreads)
{
  const Points input = randomTorus(20000, Torus::Closed, 10);
  for (const NeighborQuery& query : { nearest(16), within(0.06) })
  {
    const NeighborGraph one(input, query, threads(1));
    EXPECT_TRUE(equal(one, NeighborGraph(input, query, threads(2))));
    EXPECT_TRUE(equal(one, NeighborGraph(input, query, threads(3))));
  }
}

// A translation that rounds no coordinate changes nothing but the origin: map coordinates lose no
// accuracy.
TEST(NeighborGraphInput, doesNotDependOnTheOffset)
{
  Points input = randomTorus(5000, Torus::Closed, 11);
  for (double& coordinate : input.reshaped())
  {
    coordinate = std::ldexp(std::round(std::ldexp(coordinate, 20)), -20);
  }
  const Vector3d offset(4e6, -4e6, 4e6);
  const NeighborGraph graph(input, nearest(16));
  const NeighborGraph moved(input.colwise() + offset, nearest(16));
  EXPECT_TRUE(equal(graph, moved));
  EXPECT_EQ(moved.origin(), graph.origin() + offset);
}

// Scaling by a power of two scales every length by it and changes nothing else.
TEST(NeighborGraphInput, doesNotDependOnTheUnit)
{
  const Points input = randomTorus(5000, Torus::Closed, 12);
  const NeighborGraph graph(input, nearest(16));
  for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 30) })
  {
    const NeighborGraph scaled(scale * input, nearest(16));
    ASSERT_EQ(scaled.pointCount(), graph.pointCount());
    EXPECT_EQ(scaled.medianSamplingStep(), scale * graph.medianSamplingStep());
    for (Index i = 0; i < graph.pointCount(); ++i)
    {
      ASSERT_TRUE(std::equal(graph.neighbors(i).begin(), graph.neighbors(i).end(),
        scaled.neighbors(i).begin(), scaled.neighbors(i).end()));
    }
  }
}

// Fewer points than asked for: every point has all others as neighbors.
TEST(NeighborGraphInput, fewPointsAreAllNeighbors)
{
  const NeighborGraph graph(randomPlane(5, 13), nearest(16));
  for (Index i = 0; i < 5; ++i)
  {
    EXPECT_EQ(graph.neighbors(i).size(), 4u);
  }
}

// What cannot be a point set is refused, saying what was found; two distinct points suffice.
TEST(NeighborGraphInput, refusesUnusableInput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(NeighborGraph(Points(3, 0), nearest(16)), InvalidInput);
  EXPECT_THROW(NeighborGraph(Points::Zero(3, 1), nearest(16)), InvalidInput);
  EXPECT_THROW(NeighborGraph(Points::Ones(3, 10), nearest(16)), InvalidInput);
  for (const double bad : { nan, infinity, -infinity })
  {
    Points input = randomPlane(50, 14);
    input(1, 20) = bad;
    EXPECT_THROW(NeighborGraph(input, nearest(16)), InvalidInput);
  }
  Points two = Points::Zero(3, 2);
  two(0, 1) = 1.0;
  EXPECT_EQ(NeighborGraph(two, nearest(16)).pointCount(), 2u);
  try
  {
    NeighborGraph(Points::Ones(3, 10), nearest(16));
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("10 points"), std::string::npos) << error.what();
  }
}

// Collinear and coplanar points are fine; so are coordinates near the ends of the number range.
TEST(NeighborGraphInput, acceptsDegenerateSets)
{
  Points line = Points::Zero(3, 100);
  line.row(0).setLinSpaced(100, 0.0, 99.0);
  const NeighborGraph graph(line, nearest(2));
  EXPECT_TRUE(graph.isEdge(graph.pointOfInput(50), graph.pointOfInput(49)));
  EXPECT_TRUE(graph.isEdge(graph.pointOfInput(50), graph.pointOfInput(51)));
  EXPECT_EQ(NeighborGraph(1e-150 * line, nearest(2)).pointCount(), 100u);
  EXPECT_EQ(NeighborGraph(1e150 * line, nearest(2)).pointCount(), 100u);
}

// Progress never falls and ends at 1; refusing it stops the construction.
TEST(NeighborGraphInput, reportsProgressAndAborts)
{
  const Points input = randomTorus(20000, Torus::Closed, 15);
  std::vector<double> reported;
  const Execution watched{ 2,
    [&](double fraction)
    {
      reported.push_back(fraction);
      return true;
    } };
  const NeighborGraph graph(input, nearest(16), watched);
  ASSERT_GT(reported.size(), 5u);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1.0);
  for (const double limit : { 0.0, 0.1, 0.5, 0.99 })
  {
    const Execution stopped{ 2, [=](double fraction) { return fraction <= limit; } };
    EXPECT_THROW(NeighborGraph(input, nearest(16), stopped), Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars
