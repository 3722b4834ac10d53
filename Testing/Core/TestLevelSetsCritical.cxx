#include "Error.h"
#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

using Function = std::function<double(const Vector3d&)>;

/// Random samples, and a grid that has a sample exactly at the critical point.
std::vector<Points> planes()
{
  Points grid = squareGrid(81, 1.0 / 40.0);
  grid.topRows(2).array() -= 1.0;
  return { randomPlane(6000, 1), randomPlane(6000, 2), grid };
}

bool isFinite(const LevelSets& levelSets)
{
  const auto finite = [](const LevelSetPoint& point) {
    return point.position.allFinite() && point.normal.allFinite() && std::isfinite(point.residual);
  };
  return std::all_of(levelSets.curves.begin(), levelSets.curves.end(),
           [=](const LevelSetCurve& curve)
           {
             return std::isfinite(curve.length) &&
               std::all_of(curve.points.begin(), curve.points.end(), finite);
           }) &&
    std::all_of(levelSets.samples.begin(), levelSets.samples.end(),
      [=](const LevelSetSample& sample) { return finite(sample.point); });
}

/// Which of the sectors between the zeros of a function of the polar angle a place lies in; -1 near
/// the center.
int sector(const Vector3d& place, int sectorCount, double firstAngle, double nearCenter)
{
  if (place.head<2>().norm() < nearCenter)
  {
    return -1;
  }
  const double angle = std::atan2(place.y(), place.x()) - firstAngle + 4.0 * Pi;
  return static_cast<int>(std::floor(angle / (2.0 * Pi / sectorCount))) % sectorCount;
}

/// Four arcs end at the saddle at the origin, one in each of the sectors around its branches.
void expectFourArcs(const Traced& traced, double firstAngle)
{
  std::vector<int> arcs(4, 0);
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    EXPECT_FALSE(curve.closed);
    const double first = curve.points.front().position.norm();
    const double last = curve.points.back().position.norm();
    EXPECT_LT(std::min(first, last), 0.1 * traced.step()) << "one end is the saddle";
    EXPECT_GT(std::max(first, last), 0.8) << "the other is at the boundary";

    const int expected = sector(
      (first > last ? curve.points.front() : curve.points.back()).position, 4, firstAngle, 0.0);
    ++arcs[static_cast<std::size_t>(expected)];
    for (const LevelSetPoint& point : curve.points)
    {
      const int actual = sector(point.position, 4, firstAngle, 0.2 * traced.step());
      EXPECT_TRUE(actual == -1 || actual == expected) << "crosses the saddle";
    }
  }
  EXPECT_EQ(arcs, std::vector<int>(4, 1));
}

// At a saddle's value the level set is a cross, not a curve: four arcs end at the saddle and none
// passes through it.
TEST(LevelSetsCritical, arcsEndAtASaddle)
{
  const Function hyperbolic = [](const Vector3d& p) { return p.x() * p.x() - p.y() * p.y(); };
  const Function product = [](const Vector3d& p) { return p.x() * p.y(); };
  for (const Points& points : planes())
  {
    expectFourArcs(trace(points, valuesOf(hyperbolic, points), at({ 0.0 })), 0.0);
    expectFourArcs(trace(points, valuesOf(product, points), at({ 0.0 })), Pi / 4.0);
  }
}

// Within 1e-6 of the range an iso-value counts as the saddle's; further away the level set is a
// hyperbola with two branches.
TEST(LevelSetsCritical, toleranceIsAMillionthOfTheRange)
{
  const Function hyperbolic = [](const Vector3d& p) { return p.x() * p.x() - p.y() * p.y(); };
  const double range = 2.0;
  for (const Points& points : planes())
  {
    const Values values = valuesOf(hyperbolic, points);
    for (const double offset : { -5e-7, 5e-7 })
    {
      expectFourArcs(trace(points, values, at({ offset * range })), 0.0);
    }
    for (const double offset : { -0.01, 0.01 })
    {
      const Traced traced = trace(points, values, at({ offset * range }));
      EXPECT_EQ(traced.levelSets.componentCounts, std::vector<int>{ 2 }) << offset;
    }
  }
}

// Degenerate critical points have no such theorem: whatever comes out is finite, and nothing hangs
// or crashes.
TEST(LevelSetsCritical, degenerateCriticalPointsAreSurvived)
{
  const std::vector<Function> functions{
    [](const Vector3d& p)
    { return std::pow(p.x(), 3) - 3.0 * p.x() * p.y() * p.y(); }, // monkey saddle
    [](const Vector3d& p) { return std::pow(p.squaredNorm(), 2); },
    [](const Vector3d& p) { return p.x() * p.x(); }, // a line of minima
    [](const Vector3d& p) { return std::pow(p.x(), 3); },
    [](const Vector3d& p) { return p.squaredNorm(); }, // an isolated minimum
    [](const Vector3d& p) { return std::abs(p.x()); },
    [](const Vector3d& p) { return p.norm(); },
    [](const Vector3d& p) { return p.x() > 0.0 ? std::exp(-1.0 / p.x()) : 0.0; },
  };
  for (const Points& points : planes())
  {
    for (const Function& function : functions)
    {
      for (const int degree : { 1, 2, 3, 4 })
      {
        ContourParameters parameters = at({ 0.0, 1e-12, 1e-9, 1e-3 });
        parameters.polynomialDegree = degree;
        EXPECT_TRUE(isFinite(trace(points, valuesOf(function, points), parameters).levelSets));
      }
    }
  }
}

// A constant function has no level curves: not at its value, nor elsewhere.
TEST(LevelSetsCritical, constantFunctionsHaveNone)
{
  for (const double constant : { 0.0, 0.1, -3e8 })
  {
    const Points points = randomTorus(3000, Torus::Closed, 3);
    const Values values = Values::Constant(3000, constant);
    const Traced traced = trace(points, values, at({ constant - 1.0, constant, constant + 1.0 }));
    EXPECT_TRUE(traced.levelSets.curves.empty());
    EXPECT_EQ(traced.levelSets.componentCounts, std::vector<int>(3, 0));
  }
}

// A plateau at an iso-value is on the upper side: curves run along its lower border, not across it,
// and none along its upper one.
TEST(LevelSetsCritical, plateausAreOnTheUpperSide)
{
  const Function terrace = [](const Vector3d& p)
  { return p.x() < -0.3 ? p.x() + 0.3 : std::max(0.0, p.x() - 0.3); };
  for (const Points& points : planes())
  {
    const Traced traced = trace(points, valuesOf(terrace, points), at({ 0.0 }));
    EXPECT_TRUE(isFinite(traced.levelSets));
    for (const LevelSetCurve& curve : traced.levelSets.curves)
    {
      for (const LevelSetPoint& point : curve.points)
      {
        EXPECT_NEAR(point.position.x(), -0.3, 4.0 * traced.step());
      }
    }
  }
}

// A function that jumps has its level sets at the jump, as near as the samples tell.
TEST(LevelSetsCritical, jumpsAreFollowed)
{
  const Function jump = [](const Vector3d& p) { return p.x() < 0.25 ? 0.0 : 1.0; };
  for (const Points& points : planes())
  {
    const Traced traced = trace(points, valuesOf(jump, points), at({ 0.5, 1.0 }));
    EXPECT_TRUE(isFinite(traced.levelSets));
    EXPECT_GE(traced.levelSets.componentCounts[0], 1);
    for (const LevelSetCurve& curve : traced.levelSets.curves)
    {
      for (const LevelSetPoint& point : curve.points)
      {
        EXPECT_NEAR(point.position.x(), 0.25, 6.0 * traced.step());
      }
    }
  }
}

// Where samples lie on a line there is no surface, which is said; where they repeat or fill space,
// nothing breaks.
TEST(LevelSetsCritical, degenerateSetsAreSurvived)
{
  const Function height = [](const Vector3d& p) { return p.x() + 0.5 * p.y(); };
  Points line = Points::Zero(3, 500);
  line.row(0).setLinSpaced(500, -1.0, 1.0);
  Points almostLine = randomPlane(500, 4);
  almostLine.row(1) *= 1e-12;
  Points clusters = randomPlane(2000, 5);
  clusters = (10.0 * clusters).array().round().matrix() / 10.0 + 1e-9 * clusters;
  Points volume(3, 2000);
  Random random(6);
  for (double& coordinate : volume.reshaped())
  {
    coordinate = random.uniform(-1.0, 1.0);
  }
  for (const Points& points : { line, almostLine })
  {
    EXPECT_THROW(trace(points, valuesOf(height, points), at({ 0.0 })), InvalidInput);
  }
  for (const Points& points : { clusters, volume })
  {
    EXPECT_TRUE(
      isFinite(trace(points, valuesOf(height, points), at({ -0.4, 0.0, 0.3 })).levelSets));
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
