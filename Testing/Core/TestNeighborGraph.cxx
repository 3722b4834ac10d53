#include "NeighborGraph.h"
#include "Queries.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::nearest;
using Truth::randomTorus;
using Truth::squareGrid;
using Truth::Torus;
using Truth::within;

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

// The stored neighbors of a point are its k nearest other points, nearest first.
TEST(NeighborGraph, findsTheNearestPoints)
{
  const Points input = randomTorus(700, Torus::Closed, 1);
  const NeighborGraph graph(input, nearest(11));
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

// With a radius, the neighbors are exactly the other points within it, nearest first.
TEST(NeighborGraph, findsAllPointsWithinTheRadius)
{
  const double sigma = 0.25;
  const NeighborGraph graph(randomTorus(700, Torus::Closed, 2), within(sigma));
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
  const NeighborGraph graph(randomTorus(500, Torus::Closed, 3), nearest(8));
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
// center of its box.
TEST(NeighborGraph, permutationLeadsThereAndBack)
{
  const Points input = randomTorus(3000, Torus::Cut, 5);
  const NeighborGraph graph(input, nearest(6));
  ASSERT_EQ(graph.inputCount(), 3000u);
  const Vector3d center = 0.5 * (input.rowwise().minCoeff() + input.rowwise().maxCoeff());
  EXPECT_LT((graph.origin() - center).norm(), 1e-15);
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
TEST(NeighborGraph, edgesAreTheStoredNeighbors)
{
  const NeighborGraph graph(randomTorus(300, Torus::Closed, 6), nearest(5));
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

// On a square grid of spacing h the 8th neighbor is at h sqrt(2): density 8 / (2 pi h^2), step h
// sqrt(pi / 4).
TEST(NeighborGraph, samplingStepOfAGrid)
{
  const double h = 0.3;
  const NeighborGraph graph(squareGrid(40, h), nearest(8));
  const double expected = 1.0 / std::sqrt(8.0 / (Pi * 2.0 * h * h));
  EXPECT_NEAR(graph.medianSamplingStep(), expected, 1e-12);
  EXPECT_NEAR(graph.samplingStep(graph.pointOfInput(20 * 40 + 20)), expected, 1e-12);
  EXPECT_GT(graph.samplingStep(graph.pointOfInput(0)), 1.3 * expected); // a corner
}

// On random samples the median step is 1 / sqrt(number per area), to some percent.
TEST(NeighborGraph, samplingStepIsTheInverseRootOfTheDensity)
{
  const double area = 4.0 * Pi * Pi * Truth::MajorRadius * Truth::MinorRadius;
  const NeighborGraph graph(randomTorus(20000, Torus::Closed, 9), nearest(16));
  EXPECT_NEAR(graph.medianSamplingStep(), std::sqrt(area / 20000), 0.05 * std::sqrt(area / 20000));
}

} // namespace
} // namespace SurfaceScalars
