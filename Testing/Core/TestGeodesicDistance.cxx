#include "Error.h"
#include "GeodesicDistance.h"
#include "Queries.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::nearest;
using Truth::randomPlane;
using Truth::randomSphere;
using Truth::select;

using Distance = std::function<double(const Vector3d&, const Vector3d&)>;

double straight(const Vector3d& from, const Vector3d& to)
{
  return (to - from).norm();
}

double onSphere(const Vector3d& from, const Vector3d& to)
{
  return 2.0 * std::asin(std::min(1.0, 0.5 * (to - from).norm()));
}

constexpr double HoleRadius = 0.4;

bool isOutsideHole(const Vector3d& place)
{
  return place.norm() >= HoleRadius;
}

/// The shortest way in the plane around a disk at the origin: straight, or two tangents and an arc.
double aroundHole(const Vector3d& from, const Vector3d& to)
{
  const auto angle = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
  const double lengths = from.norm() * to.norm();
  const double arc =
    angle(from.dot(to) / lengths) - angle(HoleRadius / from.norm()) - angle(HoleRadius / to.norm());
  if (arc <= 0.0)
  {
    return straight(from, to);
  }
  const auto tangent = [](const Vector3d& place)
  { return std::sqrt(place.squaredNorm() - HoleRadius * HoleRadius); };
  return tangent(from) + tangent(to) + HoleRadius * arc;
}

Index nearestTo(const NeighborGraph& graph, const Vector3d& place)
{
  Neighborhood found;
  graph.nearest(place - graph.origin(), 1, found);
  return found.indices.front();
}

struct Errors
{
  double mean;    ///< relative to the distance
  double largest; ///< in sampling steps
};

Errors errorsOf(const NeighborGraph& graph, Index source, const Distance& exact)
{
  const Values distances = geodesicDistance(graph, { source });
  const Points places = graph.points().colwise() + graph.origin();
  Errors errors{ 0.0, 0.0 };
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    if (i != source)
    {
      const double truth = exact(places.col(source), places.col(i));
      const double error = std::abs(distances[i] - truth);
      errors.mean += error / truth / graph.pointCount();
      errors.largest = std::max(errors.largest, error / graph.medianSamplingStep());
    }
  }
  return errors;
}

// On a plane the distances are straight, from the middle as from a corner of the square.
TEST(GeodesicDistance, isStraightOnAPlane)
{
  const NeighborGraph graph(randomPlane(20000, 1), nearest(16));
  for (const Vector3d& source : { Vector3d(0.1, 0.2, 0.0), Vector3d(-1.0, -1.0, 0.0) })
  {
    const Errors errors = errorsOf(graph, nearestTo(graph, source), straight);
    EXPECT_LT(errors.mean, 0.002);
    EXPECT_LT(errors.largest, 2.5);
  }
}

// On a sphere they are the arcs of great circles, and come closer to them as points come closer.
TEST(GeodesicDistance, tendsToGreatCirclesOnASphere)
{
  double bound = 0.01;
  for (const int count : { 5000, 20000, 80000 })
  {
    const NeighborGraph graph(randomSphere(count, 2), nearest(16));
    const Errors errors = errorsOf(graph, nearestTo(graph, { 0.3, 0.5, 0.8 }), onSphere);
    EXPECT_LT(errors.mean, bound);
    EXPECT_LT(errors.largest, 3.0);
    bound *= 0.6;
  }
}

// The shortest way around a hole follows its rim.
TEST(GeodesicDistance, leadsAroundAHole)
{
  const NeighborGraph graph(select(randomPlane(40000, 3), isOutsideHole), nearest(16));
  const Errors errors = errorsOf(graph, nearestTo(graph, { -0.8, 0.1, 0.0 }), aroundHole);
  EXPECT_LT(errors.mean, 0.003);
  EXPECT_LT(errors.largest, 3.5);
}

// On the points of a square grid every way is found: the distances are exact.
TEST(GeodesicDistance, isExactOnAGrid)
{
  const NeighborGraph graph(Truth::squareGrid(50, 1.0), nearest(16));
  const Index corner = nearestTo(graph, { 0.0, 0.0, 0.0 });
  const Values distances = geodesicDistance(graph, { corner });
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    EXPECT_NEAR(distances[i], straight(graph.points().col(corner), graph.points().col(i)), 1e-11);
  }
}

// A distance is symmetric and obeys the triangle inequality, up to the error.
TEST(GeodesicDistance, isAMetric)
{
  const NeighborGraph graph(randomSphere(5000, 4), nearest(16));
  const std::vector<Index> ends{ 0, 1700, 3100, 4999 };
  std::vector<Values> from;
  for (const Index end : ends)
  {
    from.push_back(geodesicDistance(graph, { end }));
    EXPECT_EQ(from.back()[end], 0.0);
  }
  for (std::size_t a = 0; a < ends.size(); ++a)
  {
    for (std::size_t b = 0; b < ends.size(); ++b)
    {
      EXPECT_NEAR(from[a][ends[b]], from[b][ends[a]], 0.02 * from[a][ends[b]]);
      EXPECT_GE((from[a] + from[b]).minCoeff(), 0.98 * from[a][ends[b]]);
    }
  }
}

// Away from the source its gradient has length 1: along every edge it changes by at most the
// length of the edge, and along the best by nearly as much.
TEST(GeodesicDistance, hasAGradientOfLengthOne)
{
  const NeighborGraph graph(randomSphere(20000, 5), nearest(16));
  const Values distances = geodesicDistance(graph, { 7 });
  double meanSteepest = 0.0;
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    double steepest = 0.0;
    for (const Index j : graph.neighbors(i))
    {
      const double length = (graph.points().col(j) - graph.points().col(i)).norm();
      EXPECT_LE(std::abs(distances[j] - distances[i]), length * (1.0 + 1e-12));
      steepest = std::max(steepest, std::abs(distances[j] - distances[i]) / length);
    }
    meanSteepest += steepest / graph.pointCount();
  }
  EXPECT_GT(meanSteepest, 0.98);
}

// From several sources it is the distance from the nearest.
TEST(GeodesicDistance, startsAtTheNearestSource)
{
  const NeighborGraph graph(randomSphere(5000, 6), nearest(16));
  const std::vector<Index> sources{ 3, 2000, 2000, 4000 };
  const Values together = geodesicDistance(graph, sources);
  Values alone = geodesicDistance(graph, { sources.front() });
  for (const Index source : sources)
  {
    alone = alone.cwiseMin(geodesicDistance(graph, { source }));
  }
  EXPECT_LT((together - alone).lpNorm<Eigen::Infinity>(), 0.03);
}

// Noise makes ways longer or shorter by little more than itself.
TEST(GeodesicDistance, withstandsNoise)
{
  Points points = randomSphere(5000, 7);
  const NeighborGraph exact(points, nearest(16));
  Truth::addNoise(points, 0.02, 8);
  const NeighborGraph graph(points, nearest(16));
  const Values distances = geodesicDistance(graph, { graph.pointOfInput(0) });
  double mean = 0.0;
  for (std::size_t i = 1; i < exact.inputCount(); ++i)
  {
    const Points& places = exact.points();
    const double truth =
      onSphere(places.col(exact.pointOfInput(0)), places.col(exact.pointOfInput(i)));
    mean += std::abs(distances[graph.pointOfInput(i)] / truth - 1.0) / 5000.0;
  }
  EXPECT_LT(mean, 0.04);
}

// A way may use an edge against the direction in which it is stored; where none leads the distance
// is infinite.
TEST(GeodesicDistance, usesEdgesInBothDirectionsAndNoOthers)
{
  Points points = Points::Zero(3, 7);
  points.row(0) << 0.0, 1.0, 1.5, 3.5, 100.0, 101.0, 102.0;
  const NeighborGraph graph(points, nearest(1));
  const Values distances = geodesicDistance(graph, { graph.pointOfInput(0) });
  const std::vector<double> expected{ 0.0, 1.0, 1.5, 3.5 };
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(distances[graph.pointOfInput(i)], expected[i], 1e-12);
  }
  for (const std::size_t i : { 4u, 5u, 6u })
  {
    EXPECT_EQ(distances[graph.pointOfInput(i)], INFINITY);
  }
}

// The unit of length does not matter, and nor do places that coincide but for rounding.
TEST(GeodesicDistance, doesNotDependOnTheUnit)
{
  Points points = randomPlane(2000, 9);
  points.col(1) = points.col(0) + Vector3d(1e-16, 0.0, 0.0);
  const Values distances = geodesicDistance(NeighborGraph(points, nearest(16)), { 0 });
  EXPECT_TRUE(distances.allFinite());
  for (const double scale : { std::ldexp(1.0, -300), std::ldexp(1.0, 300) })
  {
    const NeighborGraph scaled(scale * points, nearest(16));
    EXPECT_EQ(geodesicDistance(scaled, { 0 }), scale * distances);
  }
}

// What cannot be a source is refused, saying what was found.
TEST(GeodesicDistance, refusesUnusableSources)
{
  const NeighborGraph graph(randomPlane(50, 10), nearest(16));
  EXPECT_THROW(geodesicDistance(graph, {}), InvalidInput);
  try
  {
    geodesicDistance(graph, { 3, 50 });
    FAIL();
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("50 points"), std::string::npos) << error.what();
  }
}

// Progress never falls and ends at 1; refusing it stops the march. Threads change nothing.
TEST(GeodesicDistance, reportsProgressAndAborts)
{
  const NeighborGraph graph(randomSphere(30000, 11), nearest(16));
  std::vector<double> reported;
  const Execution watched{ 1,
    [&](double fraction)
    {
      reported.push_back(fraction);
      return true;
    } };
  const Values distances = geodesicDistance(graph, { 0 }, watched);
  ASSERT_GT(reported.size(), 5u);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_EQ(reported.back(), 1.0);
  EXPECT_EQ(distances, geodesicDistance(graph, { 0 }, { 3, {} }));
  for (const double limit : { 0.0, 0.05, 0.5, 0.99 })
  {
    const Execution stopped{ 2, [=](double fraction) { return fraction <= limit; } };
    EXPECT_THROW(geodesicDistance(graph, { 0 }, stopped), Aborted);
  }
}

// Where all points are neighbors of all, each takes millions of steps: it is reported what is done,
// not how many points are.
TEST(GeodesicDistance, reportsProgressOnDenseGraphs)
{
  const NeighborGraph graph(randomSphere(400, 12), nearest(399));
  int reports = 0;
  const Execution watched{ 1,
    [&](double fraction)
    {
      reports += fraction > 0.1 && fraction < 1.0;
      return true;
    } };
  EXPECT_TRUE(geodesicDistance(graph, { 0 }, watched).allFinite());
  EXPECT_GT(reports, 20);
}

} // namespace
} // namespace SurfaceScalars
