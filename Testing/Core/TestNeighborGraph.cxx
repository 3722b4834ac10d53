#include "Error.h"
#include "NeighborGraph.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace SurfaceScalars
{
namespace
{

using Truth::randomPlane;
using Truth::randomTorus;
using Truth::squareGrid;
using Truth::Torus;

NeighborQuery count(int k)
{
  return { k, 0.0 };
}

NeighborQuery radius(double sigma)
{
  return { 16, sigma };
}

Execution threads(int threadCount)
{
  return { threadCount, {} };
}

/// Distances of all other points to a place, ascending.
std::vector<double> sortedDistances(const PointsRef& points, const Vector3d& place)
{
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    distances.push_back((points.col(i) - place).norm());
  }
  std::sort(distances.begin(), distances.end());
  return distances;
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

// The stored neighbours of a point are its k nearest other points, nearest first.
TEST(NeighborGraph, findsTheNearestPoints)
{
  const Points input = randomTorus(700, Torus::Closed, 1);
  const NeighborGraph graph(input, count(11));
  ASSERT_EQ(graph.pointCount(), 700u);
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    const auto expected = sortedDistances(graph.points(), graph.points().col(i));
    const Neighbors neighbors = graph.neighbors(i);
    ASSERT_EQ(neighbors.size(), 11u);
    for (std::size_t j = 0; j < neighbors.size(); ++j)
    {
      EXPECT_NE(neighbors.begin()[j], i);
      const Vector3d difference = graph.points().col(neighbors.begin()[j]) - graph.points().col(i);
      EXPECT_NEAR(difference.norm(), expected[j + 1], 1e-14);
    }
  }
}

// With a radius, the neighbours are exactly the other points within it, nearest first.
TEST(NeighborGraph, findsAllPointsWithinTheRadius)
{
  const double sigma = 0.25;
  const NeighborGraph graph(randomTorus(700, Torus::Closed, 2), radius(sigma));
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    const auto expected = sortedDistances(graph.points(), graph.points().col(i));
    const Neighbors neighbors = graph.neighbors(i);
    const auto inside = std::count_if(
      expected.begin(), expected.end(), [=](double distance) { return distance < sigma; });
    ASSERT_EQ(neighbors.size(), static_cast<std::size_t>(inside - 1));
    for (std::size_t j = 0; j < neighbors.size(); ++j)
    {
      const Vector3d difference = graph.points().col(neighbors.begin()[j]) - graph.points().col(i);
      EXPECT_NEAR(difference.norm(), expected[j + 1], 1e-14);
    }
  }
}

// Searches around any place agree with brute force; asking for more points than there are gives
// all.
TEST(NeighborGraph, searchesAroundPlaces)
{
  const NeighborGraph graph(randomTorus(500, Torus::Closed, 3), count(8));
  Truth::Random random(4);
  Neighborhood found;
  for (int i = 0; i < 50; ++i)
  {
    const Vector3d place(
      random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), random.uniform(-1.0, 1.0));
    const auto expected = sortedDistances(graph.points(), place);

    graph.nearest(place, 13, found);
    ASSERT_EQ(found.indices.size(), 13u);
    ASSERT_EQ(found.squaredDistances.size(), 13u);
    for (std::size_t j = 0; j < 13; ++j)
    {
      EXPECT_NEAR(std::sqrt(found.squaredDistances[j]), expected[j], 1e-14);
      EXPECT_EQ(
        (graph.points().col(found.indices[j]) - place).squaredNorm(), found.squaredDistances[j]);
    }

    graph.within(place, 0.8, found);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(found.indices.size()),
      std::count_if(expected.begin(), expected.end(), [](double d) { return d < 0.8; }));
    EXPECT_TRUE(std::is_sorted(found.squaredDistances.begin(), found.squaredDistances.end()));
  }
  graph.nearest(Vector3d::Zero(), 1000, found);
  EXPECT_EQ(found.indices.size(), 500u);
}

// pointOfInput and inputOfPoint are inverse permutations, and points() are the input about the
// centre of its box.
TEST(NeighborGraph, permutationLeadsThereAndBack)
{
  const Points input = randomTorus(3000, Torus::Cut, 5);
  const NeighborGraph graph(input, count(6));
  ASSERT_EQ(graph.inputCount(), 3000u);
  const Vector3d centre = 0.5 * (input.rowwise().minCoeff() + input.rowwise().maxCoeff());
  EXPECT_LT((graph.origin() - centre).norm(), 1e-15);
  for (std::size_t i = 0; i < graph.inputCount(); ++i)
  {
    const Index point = graph.pointOfInput(i);
    EXPECT_EQ(graph.inputOfPoint(point), i);
    EXPECT_LT(
      (graph.points().col(point) + graph.origin() - input.col(static_cast<Eigen::Index>(i))).norm(),
      1e-15);
  }
}

// An edge exists where either end stores the other: isEdge tells which.
TEST(NeighborGraph, edgesAreTheStoredNeighbours)
{
  const NeighborGraph graph(randomTorus(300, Torus::Closed, 6), count(5));
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    const Neighbors neighbors = graph.neighbors(i);
    const std::set<Index> stored(neighbors.begin(), neighbors.end());
    for (Index j = 0; j < graph.pointCount(); ++j)
    {
      EXPECT_EQ(graph.isEdge(i, j), stored.count(j) == 1);
    }
  }
}

// Exact duplicates are one point: the graph of a multiset is that of its set, and values are
// averaged.
TEST(NeighborGraph, mergesDuplicates)
{
  const Points distinct = randomTorus(400, Torus::Closed, 7);
  Points repeated(3, 1200);
  repeated << distinct, distinct.rowwise().reverse(), distinct;
  const NeighborGraph graph(repeated, count(8));
  const NeighborGraph expected(distinct, count(8));
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

// Duplicates are found even where the Morton cells are too coarse to tell their neighbours apart.
TEST(NeighborGraph, mergesDuplicatesInACrowdedCell)
{
  Points input(3, 301);
  for (int i = 0; i < 300; ++i)
  {
    input.col(i) = 1e-3 * Vector3d(i % 10, (i / 10) % 10, 0.0); // each place three times
  }
  input.col(300) = Vector3d(1e9, 1e9, 1e9);
  const NeighborGraph graph(input, count(4));
  EXPECT_EQ(graph.pointCount(), 101u);
}

// No point is its own neighbour, not even where distinct points fall together by rounding.
TEST(NeighborGraph, noPointIsItsOwnNeighbour)
{
  Points input = randomPlane(200, 8);
  for (int i = 0; i < 50; ++i)
  {
    input.col(i) =
      Vector3d(1e-25 * i, 1e-30 * i * i, 0.0); // distinct until the centre is subtracted
  }
  for (const NeighborQuery& query : { count(8), radius(0.3) })
  {
    const NeighborGraph graph(input, query);
    for (Index i = 0; i < graph.pointCount(); ++i)
    {
      EXPECT_FALSE(graph.isEdge(i, i));
      EXPECT_GT(graph.samplingStep(i), 0.0);
    }
  }
}

// On a square grid of spacing h the 8th neighbour is at h sqrt(2): density 8 / (2 pi h^2), step h
// sqrt(pi / 4).
TEST(NeighborGraph, samplingStepOfAGrid)
{
  const double h = 0.3;
  const NeighborGraph graph(squareGrid(40, h), count(8));
  const double expected = 1.0 / std::sqrt(8.0 / (Pi * 2.0 * h * h));
  EXPECT_NEAR(graph.medianSamplingStep(), expected, 1e-12);
  EXPECT_NEAR(graph.samplingStep(graph.pointOfInput(20 * 40 + 20)), expected, 1e-12);
  EXPECT_GT(graph.samplingStep(graph.pointOfInput(0)), 1.3 * expected); // a corner
}

// On random samples the median step is 1 / sqrt(number per area), to some percent.
TEST(NeighborGraph, samplingStepIsTheInverseRootOfTheDensity)
{
  const double area = 4.0 * Pi * Pi * Truth::MajorRadius * Truth::MinorRadius;
  const NeighborGraph graph(randomTorus(20000, Torus::Closed, 9), count(16));
  EXPECT_NEAR(graph.medianSamplingStep(), std::sqrt(area / 20000), 0.05 * std::sqrt(area / 20000));
}

// The graph does not depend on the number of threads, bit for bit.
TEST(NeighborGraph, isTheSameForAnyNumberOfThreads)
{
  const Points input = randomTorus(20000, Torus::Closed, 10);
  for (const NeighborQuery& query : { count(16), radius(0.06) })
  {
    const NeighborGraph one(input, query, threads(1));
    EXPECT_TRUE(equal(one, NeighborGraph(input, query, threads(2))));
    EXPECT_TRUE(equal(one, NeighborGraph(input, query, threads(3))));
  }
}

// A translation that rounds no coordinate changes nothing but the origin: map coordinates lose no
// accuracy.
TEST(NeighborGraph, doesNotDependOnTheOffset)
{
  Points input = randomTorus(5000, Torus::Closed, 11);
  for (double& coordinate : input.reshaped())
  {
    coordinate = std::ldexp(std::round(std::ldexp(coordinate, 20)), -20);
  }
  const Vector3d offset(4e6, -4e6, 4e6);
  const NeighborGraph graph(input, count(16));
  const NeighborGraph moved(input.colwise() + offset, count(16));
  EXPECT_TRUE(equal(graph, moved));
  EXPECT_EQ(moved.origin(), graph.origin() + offset);
}

// Scaling by a power of two scales every length by it and changes nothing else.
TEST(NeighborGraph, doesNotDependOnTheUnit)
{
  const Points input = randomTorus(5000, Torus::Closed, 12);
  const NeighborGraph graph(input, count(16));
  for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 30) })
  {
    const NeighborGraph scaled(scale * input, count(16));
    ASSERT_EQ(scaled.pointCount(), graph.pointCount());
    EXPECT_EQ(scaled.medianSamplingStep(), scale * graph.medianSamplingStep());
    for (Index i = 0; i < graph.pointCount(); ++i)
    {
      ASSERT_TRUE(std::equal(graph.neighbors(i).begin(), graph.neighbors(i).end(),
        scaled.neighbors(i).begin(), scaled.neighbors(i).end()));
    }
  }
}

// Fewer points than asked for: every point has all others as neighbours.
TEST(NeighborGraph, fewPointsAreAllNeighbours)
{
  const NeighborGraph graph(randomPlane(5, 13), count(16));
  for (Index i = 0; i < 5; ++i)
  {
    EXPECT_EQ(graph.neighbors(i).size(), 4u);
  }
}

// What cannot be a point set is refused, saying what was found; two distinct points suffice.
TEST(NeighborGraph, refusesUnusableInput)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(NeighborGraph(Points(3, 0), count(16)), InvalidInput);
  EXPECT_THROW(NeighborGraph(Points::Zero(3, 1), count(16)), InvalidInput);
  EXPECT_THROW(NeighborGraph(Points::Ones(3, 10), count(16)), InvalidInput);
  for (const double bad : { nan, infinity, -infinity })
  {
    Points input = randomPlane(50, 14);
    input(1, 20) = bad;
    EXPECT_THROW(NeighborGraph(input, count(16)), InvalidInput);
  }
  Points two = Points::Zero(3, 2);
  two(0, 1) = 1.0;
  EXPECT_EQ(NeighborGraph(two, count(16)).pointCount(), 2u);
  try
  {
    NeighborGraph(Points::Ones(3, 10), count(16));
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("10 points"), std::string::npos) << error.what();
  }
}

// Collinear and coplanar points are fine; so are coordinates near the ends of the number range.
TEST(NeighborGraph, acceptsDegenerateSets)
{
  Points line = Points::Zero(3, 100);
  line.row(0).setLinSpaced(100, 0.0, 99.0);
  const NeighborGraph graph(line, count(2));
  EXPECT_TRUE(graph.isEdge(graph.pointOfInput(50), graph.pointOfInput(49)));
  EXPECT_TRUE(graph.isEdge(graph.pointOfInput(50), graph.pointOfInput(51)));
  EXPECT_EQ(NeighborGraph(1e-150 * line, count(2)).pointCount(), 100u);
  EXPECT_EQ(NeighborGraph(1e150 * line, count(2)).pointCount(), 100u);
}

// Progress never falls and ends at 1; refusing it stops the construction.
TEST(NeighborGraph, reportsProgressAndAborts)
{
  const Points input = randomTorus(20000, Torus::Closed, 15);
  std::vector<double> reported;
  const Execution watched{ 2,
    [&](double fraction)
    {
      reported.push_back(fraction);
      return true;
    } };
  const NeighborGraph graph(input, count(16), watched);
  ASSERT_GT(reported.size(), 5u);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1.0);
  for (const double limit : { 0.0, 0.1, 0.5, 0.99 })
  {
    const Execution stopped{ 2, [=](double fraction) { return fraction <= limit; } };
    EXPECT_THROW(NeighborGraph(input, count(16), stopped), Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars
