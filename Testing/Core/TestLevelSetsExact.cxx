#include "CriticalPoints.h"
#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <map>

namespace SurfaceScalars::Truth
{
namespace
{

// On a plane, polynomials of the fit's degree are reproduced: every point of every curve lies on {f
// = alpha, z = 0} up to rounding.
TEST(LevelSetsExact, reproducesPolynomialsOnAPlane)
{
  const Points points = randomPlane(4000, 1);
  const auto linear = [](const Vector3d& p) { return 3.0 * p.x() - p.y() + 0.25; };
  const auto quadratic = [](const Vector3d& p)
  { return p.x() * p.x() + 0.5 * p.y() * p.y() + 0.3 * p.x() * p.y() + p.x(); };
  const auto cubic = [=](const Vector3d& p) { return quadratic(p) + 0.2 * p.x() * p.x() * p.y(); };
  const std::map<int, std::function<double(const Vector3d&)>> ofDegree{ { 1, linear },
    { 2, quadratic }, { 3, cubic }, { 4, cubic } };
  for (const auto& [degree, function] : ofDegree)
  {
    ContourParameters parameters = at({ -0.1, 0.2, 0.5, 1.1 });
    parameters.polynomialDegree = degree;
    parameters.tolerance = 1e-12;
    const Traced traced = trace(points, valuesOf(function, points), parameters);
    ASSERT_GE(traced.levelSets.curves.size(), 4u) << degree;
    const double rounding = degree <= 2 ? 1e-12 : 1e-10; // more unknowns, worse conditioned
    for (const LevelSetCurve& curve : traced.levelSets.curves)
    {
      const double isoValue = traced.levelSets.isoValues[curve.level];
      for (const LevelSetPoint& point : curve.points)
      {
        EXPECT_NEAR(function(point.position), isoValue, rounding) << "degree " << degree;
        EXPECT_NEAR(point.position.z(), 0.0, 1e-13);
        EXPECT_NEAR(std::abs(point.normal.z()), 1.0, 1e-12);
      }
    }
  }
}

// The length of a curve is the sum of its segments, and circles f = |p|^2 on a plane have
// circumference 2 pi sqrt(alpha).
TEST(LevelSetsExact, measuresLengths)
{
  const Points points = randomPlane(20000, 2);
  const auto squaredRadius = [](const Vector3d& p) { return p.squaredNorm(); };
  const Traced traced = trace(points, valuesOf(squaredRadius, points), at({ 0.09, 0.25, 0.49 }));
  ASSERT_EQ(traced.levelSets.curves.size(), 3u);
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    ASSERT_TRUE(curve.closed);
    double sum = 0.0;
    const std::size_t count = curve.points.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      sum += (curve.points[(i + 1) % count].position - curve.points[i].position).norm();
    }
    EXPECT_NEAR(curve.length, sum, 1e-12);
    const double circumference = 2.0 * Pi * std::sqrt(traced.levelSets.isoValues[curve.level]);
    EXPECT_NEAR(curve.length, circumference, 0.002 * circumference);
  }
}

// Curves run with the larger values on their left, seen against the normals: <grad f, n x t> > 0 on
// every segment.
TEST(LevelSetsExact, largerValuesLieToTheLeft)
{
  for (const SpaceFunction& function : { tiltedHeight(), saddleWithLogarithm() })
  {
    const Points points = randomTorus(10000, Torus::Cut, 3);
    const auto critical = criticalValues(function, Torus::Cut);
    const Traced traced =
      trace(points, valuesOf(function, points), at(regularIsoValues(critical, 10, 0.01)));
    for (const LevelSetCurve& curve : traced.levelSets.curves)
    {
      const std::size_t count = curve.points.size();
      for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
      {
        const LevelSetPoint& from = curve.points[i];
        const LevelSetPoint& to = curve.points[(i + 1) % count];
        const Vector3d left = from.normal.cross(to.position - from.position);
        const Vector3d middle = 0.5 * (from.position + to.position);
        EXPECT_GT(function.gradient(middle).dot(left), 0.0) << function.name;
        EXPECT_GT(from.normal.dot(to.normal), 0.5) << "normals of a curve agree";
        EXPECT_NEAR(from.normal.norm(), 1.0, 1e-12);
      }
    }
  }
}

// A closed curve does not repeat its first point; neighboring points are apart, about a step, on
// every curve.
TEST(LevelSetsExact, curvesAreCleanPolylines)
{
  const SpaceFunction function = saddleWithLogarithm();
  const Points points = randomTorus(20000, Torus::Cut, 4);
  const auto critical = criticalValues(function, Torus::Cut);
  const Traced traced =
    trace(points, valuesOf(function, points), at(regularIsoValues(critical, 20, 0.01)));
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    const std::size_t count = curve.points.size();
    ASSERT_GE(count, curve.closed ? 3u : 2u);
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
    {
      const double distance =
        (curve.points[(i + 1) % count].position - curve.points[i].position).norm();
      EXPECT_GT(distance, 0.01 * traced.step());
      EXPECT_LT(distance, 3.0 * traced.step());
    }
  }
}

// With F a given function, {F = alpha} is met to the tolerance of 1e-7 steps, though no sample
// carries F: (14) with F exact.
TEST(LevelSetsExact, volumeFunctionIsMetExactly)
{
  const SpaceFunction function = saddleWithLogarithm();
  const Points points = randomTorus(20000, Torus::Closed, 5);
  const auto critical = criticalValues(function, Torus::Closed);
  ContourParameters parameters = at(regularIsoValues(critical, 10, 0.01));
  parameters.volumeFunction = [&](const Vector3d& place, Vector3d* gradient)
  {
    if (gradient)
    {
      *gradient = function.gradient(place);
    }
    return function.value(place);
  };
  const Traced traced = trace(points, valuesOf(function, points), parameters);
  const LevelSets& levelSets = traced.levelSets;
  ASSERT_GE(levelSets.curves.size(), 10u);
  const double step = traced.step();
  for (const LevelSetCurve& curve : levelSets.curves)
  {
    for (const LevelSetPoint& point : curve.points)
    {
      const double defect = function.value(point.position) - levelSets.isoValues[curve.level];
      const double distance = std::abs(defect) / function.gradient(point.position).norm();
      EXPECT_LE(distance, 1e-7 * step);
      EXPECT_LE(point.residual, 1e-6 * step);
      EXPECT_NEAR(torusDistance(point.position), 0.0, 0.05 * step);
    }
  }
}

// A given function may have edges: a prism cuts a sphere in two closed curves with four corners
// each.
TEST(LevelSetsExact, curvesGoRoundTheEdgesOfAGivenFunction)
{
  const Points points = randomSphere(20000, 4);
  ContourParameters parameters = at({ 0.0 });
  parameters.volumeFunction = [](const Vector3d& place, Vector3d* gradient)
  {
    const Vector2d beyond(std::abs(place.x()) - 0.8, std::abs(place.y()) - 0.5);
    const int axis = beyond.x() > beyond.y() ? 0 : 1;
    if (gradient)
    {
      *gradient = Vector3d::Zero();
      (*gradient)[axis] = place[axis] < 0.0 ? -1.0 : 1.0;
    }
    return beyond[axis];
  };
  const NeighborGraph graph(points, NeighborQuery());
  Values values(graph.pointCount());
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    values[i] = parameters.volumeFunction(graph.points().col(i) + graph.origin(), nullptr);
  }
  const LevelSets levelSets = traceLevelSets(graph, values, parameters);
  ASSERT_EQ(levelSets.componentCounts, std::vector<int>{ 2 });
  for (const LevelSetCurve& curve : levelSets.curves)
  {
    EXPECT_TRUE(curve.closed);
    for (const Vector2d& corner :
      { Vector2d(0.8, 0.5), Vector2d(-0.8, 0.5), Vector2d(0.8, -0.5), Vector2d(-0.8, -0.5) })
    {
      const bool passed = std::any_of(curve.points.begin(), curve.points.end(),
        [&](const LevelSetPoint& point)
        { return (point.position.head<2>() - corner).norm() < 0.2 * graph.medianSamplingStep(); });
      EXPECT_TRUE(passed) << corner.transpose();
    }
  }
}

// Samples lie on the level set as well as curves do, and close to every curve there is one.
TEST(LevelSetsExact, samplesLieOnTheLevelSets)
{
  const SpaceFunction function = tiltedHeight();
  const Points points = randomTorus(20000, Torus::Closed, 6);
  const Traced traced = trace(points, valuesOf(function, points), at({ -0.31, 0.1, 0.62 }));
  std::vector<int> perLevel(3, 0);
  std::size_t converged = 0;
  for (const LevelSetSample& sample : traced.levelSets.samples)
  {
    ++perLevel[sample.level];
    if (sample.point.converged)
    {
      ++converged;
      const Vector3d place = sample.point.position;
      EXPECT_NEAR(
        function.value(place), traced.levelSets.isoValues[sample.level], 0.1 * traced.step());
      EXPECT_NEAR(torusDistance(place), 0.0, 0.1 * traced.step());
      EXPECT_LE(sample.point.residual, 1e-6 * traced.step());
    }
  }
  EXPECT_GE(converged, traced.levelSets.samples.size() * 99 / 100);
  for (std::size_t level = 0; level < 3; ++level)
  {
    EXPECT_GT(perLevel[level], 50);
  }
  EXPECT_TRUE(std::is_sorted(traced.levelSets.samples.begin(), traced.levelSets.samples.end(),
    [](const LevelSetSample& a, const LevelSetSample& b) { return a.level < b.level; }));
}

} // namespace
} // namespace SurfaceScalars::Truth
