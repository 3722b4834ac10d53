#include "CriticalPoints.h"
#include "Error.h"
#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

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

// At a saddle's value the level set is a cross, not a curve: where the surface ends, four arcs end
// at the saddle and none passes through it.
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

/// Re z^n, z = x + i y: n = m + 1 lines cross at the origin.
Function powerSaddle(int order)
{
  return [=](const Vector3d& p)
  { return std::pow(std::complex<double>(p.x(), p.y()), order).real(); };
}

// A saddle of multiplicity m has 2 + 2 m branches, which meet at exactly one position: on a plane
// all of them end at the boundary.
TEST(LevelSetsCritical, degenerateSaddlesHaveAllTheirBranches)
{
  for (const Points& points : planes())
  {
    for (const int order : { 3, 4, 5 })
    {
      const Traced traced = trace(points, valuesOf(powerSaddle(order), points), at({ 0.0 }));
      const auto count = 2 * static_cast<std::size_t>(order);
      EXPECT_EQ(traced.levelSets.curves.size(), count);
      std::vector<int> arcs(count, 0);
      const Vector3d saddle = [&]()
      {
        const LevelSetCurve& curve = traced.levelSets.curves.front();
        const Vector3d first = curve.points.front().position;
        const Vector3d last = curve.points.back().position;
        return first.norm() < last.norm() ? first : last;
      }();
      EXPECT_LT(saddle.norm(), 0.01 * traced.step());
      for (const LevelSetCurve& curve : traced.levelSets.curves)
      {
        EXPECT_FALSE(curve.closed);
        const bool begins = curve.points.front().position == saddle;
        EXPECT_TRUE(begins || curve.points.back().position == saddle);
        const Vector3d end = (begins ? curve.points.back() : curve.points.front()).position;
        EXPECT_GT(end.norm(), 0.9);
        ++arcs[static_cast<std::size_t>(sector(end, static_cast<int>(count), 0.0, 0.0))];
      }
      EXPECT_EQ(arcs, std::vector<int>(count, 1)) << "order " << order;
    }
  }
}

/// Larger values lie to the left of a curve, seen against its normals.
void expectLargerValuesLeft(
  const LevelSetCurve& curve, const Function& function, double level, double distance)
{
  const std::size_t count = curve.points.size();
  int larger = 0;
  int segments = 0;
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i, ++segments)
  {
    const LevelSetPoint& point = curve.points[i];
    const Vector3d next = curve.points[(i + 1) % count].position;
    const Vector3d left = point.normal.cross(next - point.position).normalized();
    larger += function(0.5 * (point.position + next) + distance * left) > level ? 1 : 0;
  }
  EXPECT_GE(larger, 9 * segments / 10);
}

// The contour of a tilted torus at each of its saddles is a figure of eight: two loops that begin
// at the saddle, exactly where it is, to the precision of the samples.
TEST(LevelSetsCritical, figuresOfEightAreTwoLoops)
{
  const SpaceFunction height = tiltedHeight();
  for (const int count : { 5000, 20000, 50000 })
  {
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      const Points points = randomTorus(count, Torus::Closed, seed);
      for (const CriticalPoint& critical : criticalPoints(closedTorus(), height))
      {
        if (indexOf(critical) > 0)
        {
          continue;
        }
        const Traced traced = trace(points, valuesOf(height, points), at({ critical.value }));
        ASSERT_EQ(traced.levelSets.curves.size(), 2u) << count << " " << seed;
        EXPECT_EQ(traced.levelSets.componentCounts, std::vector<int>{ 2 });
        const Vector3d saddle = traced.levelSets.curves[0].points[0].position;
        EXPECT_LT((saddle - critical.position).norm(), 0.05 * traced.step());
        for (const LevelSetCurve& curve : traced.levelSets.curves)
        {
          EXPECT_TRUE(curve.closed);
          EXPECT_EQ(curve.points[0].position, saddle);
          EXPECT_GT(curve.length, 4.0);
          expectLargerValuesLeft(curve, height.value, critical.value, traced.step());
        }
      }
    }
  }
}

// Re (x + i y)^n on the sphere has saddles of multiplicity n - 1 at both poles: its zero level set,
// n great circles, is n loops through both poles, each around a lune of larger values.
TEST(LevelSetsCritical, loopsPassThroughDegenerateSaddles)
{
  const Points points = randomSphere(20000, 1);
  for (const int order : { 3, 4, 5 })
  {
    const Function function = powerSaddle(order);
    for (const bool isChanged : { false, true })
    {
      ContourParameters parameters = at({ 0.0 });
      parameters.sampleSpacing = isChanged ? 0.03 : 0.0;
      parameters.scheme = isChanged ? Scheme::Linear : Scheme::ParameterizedMLS;
      const Traced traced = trace(points, valuesOf(function, points), parameters);
      ASSERT_EQ(traced.levelSets.curves.size(), static_cast<std::size_t>(order));
      const Vector3d pole = traced.levelSets.curves[0].points[0].position;
      EXPECT_LT((pole.cwiseAbs() - Vector3d::UnitZ()).norm(), 0.01 * traced.step());
      for (const LevelSetCurve& curve : traced.levelSets.curves)
      {
        EXPECT_TRUE(curve.closed);
        EXPECT_NEAR(curve.length, 2.0 * Pi, 0.05);
        EXPECT_EQ(curve.points[0].position, pole);
        EXPECT_EQ(
          std::count_if(curve.points.begin(), curve.points.end(),
            [](const LevelSetPoint& point) { return point.position.head<2>().norm() < 1e-3; }),
          2)
          << "both poles";
        expectLargerValuesLeft(curve, function, 0.0, traced.step());
      }
    }
  }
}

// cos 3u cos 2v has all its 24 saddles at one value: its level set there is 12 loops around the
// maxima, each through four saddles.
TEST(LevelSetsCritical, loopsGoRoundLargerValues)
{
  const Function waves = [](const Vector3d& p)
  {
    const Vector2d angles = torusAngles(p);
    return std::cos(3.0 * angles.x()) * std::cos(2.0 * angles.y());
  };
  const Points points = randomTorus(20000, Torus::Closed, 1);
  const Traced traced = trace(points, valuesOf(waves, points), at({ 0.0 }));
  EXPECT_EQ(traced.levelSets.curves.size(), 12u);
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    EXPECT_TRUE(curve.closed);
    EXPECT_LT(std::abs(waves(curve.points[0].position)), 1e-3);
    expectLargerValuesLeft(curve, waves, 0.0, traced.step());
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

// At whatever critical points, with whatever degree: what comes out is finite, and nothing hangs or
// crashes.
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
