#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"

#include <gtest/gtest.h>

namespace SurfaceScalars::Truth
{
namespace
{

double height(const Vector3d& p)
{
  return p.y();
}

/// A plane with a round hole around the origin; its diameter is given in sampling steps.
Points planeWithHole(double diameterInSteps, unsigned seed)
{
  const int count = 20000;
  const double step = 2.0 / std::sqrt(count);
  return select(randomPlane(count, seed),
    [=](const Vector3d& p) { return p.norm() > 0.5 * diameterInSteps * step; });
}

int curvesThroughHole(double diameterInSteps, double linkDistance, unsigned seed)
{
  const Points points = planeWithHole(diameterInSteps, seed);
  ContourParameters parameters = at({ 0.0 });
  parameters.linkDistance = linkDistance;
  const Traced traced = trace(points, valuesOf(height, points), parameters);
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    EXPECT_FALSE(curve.closed);
    for (const LevelSetPoint& point : curve.points)
    {
      EXPECT_NEAR(point.position.y(), 0.0, 0.1 * traced.step());
    }
  }
  return traced.levelSets.componentCounts[0];
}

// A line across a hole is one curve if LinkDistance is wider than the hole, and two if it is
// narrower.
TEST(LevelSetsHoles, linkDistanceIsTheWidestHoleBridged)
{
  for (const unsigned seed : { 1u, 2u, 3u, 4u })
  {
    for (const double diameter : { 8.0, 12.0, 20.0 })
    {
      EXPECT_EQ(curvesThroughHole(diameter, 1.4 * diameter, seed), 1) << diameter << ", " << seed;
      EXPECT_EQ(curvesThroughHole(diameter, 0.6 * diameter, seed), 2) << diameter << ", " << seed;
    }
  }
}

// Chosen automatically, it bridges the gaps of random sampling and nothing much wider.
TEST(LevelSetsHoles, automaticLinkDistanceBridgesRandomGapsOnly)
{
  for (const unsigned seed : { 1u, 2u, 3u, 4u })
  {
    EXPECT_EQ(curvesThroughHole(0.0, 0.0, seed), 1);
    EXPECT_EQ(curvesThroughHole(2.0, 0.0, seed), 1);
    EXPECT_EQ(curvesThroughHole(15.0, 0.0, seed), 2);
    EXPECT_EQ(curvesThroughHole(40.0, 0.0, seed), 2);
  }
}

// Only the curves that meet the hole change: all others are those of the plane without it.
TEST(LevelSetsHoles, otherCurvesAreNotTouched)
{
  const Points points = planeWithHole(20.0, 5);
  const Traced traced = trace(points, valuesOf(height, points), at({ -0.7, 0.0, 0.6 }));
  EXPECT_EQ(traced.levelSets.componentCounts, (std::vector<int>{ 1, 2, 1 }));
}

// A curve that goes round a hole stays closed; one that is cut by two holes becomes two open ones.
TEST(LevelSetsHoles, closedCurvesAreCutIntoOpenOnes)
{
  const auto squaredRadius = [](const Vector3d& p) { return p.squaredNorm(); };
  const double holeRadius = 0.15;
  const Points points = select(randomPlane(20000, 6),
    [=](const Vector3d& p)
    {
      return p.norm() > holeRadius && (p - Vector3d(0.6, 0.0, 0.0)).norm() > holeRadius &&
        (p + Vector3d(0.6, 0.0, 0.0)).norm() > holeRadius;
    });
  const Traced traced =
    trace(points, valuesOf(squaredRadius, points), at({ 0.3 * 0.3, 0.6 * 0.6, 0.85 * 0.85 }));
  EXPECT_EQ(traced.levelSets.componentCounts, (std::vector<int>{ 1, 2, 1 }));
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    EXPECT_EQ(curve.closed, curve.level != 1);
  }
}

// Sheets closer together than a hole is wide are not joined: curves stay on theirs.
TEST(LevelSetsHoles, parallelSheetsStayApart)
{
  const int count = 10000;
  Points points(3, 2 * count);
  points << randomPlane(count, 7), randomPlane(count, 8);
  points.row(2).tail(count).setConstant(0.16); // eight steps
  const Traced traced = trace(points, valuesOf(height, points), at({ -0.5, 0.0, 0.5 }));
  EXPECT_EQ(traced.levelSets.componentCounts, std::vector<int>(3, 2));
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    const double sheet = curve.points.front().position.z() < 0.08 ? 0.0 : 0.16;
    for (const LevelSetPoint& point : curve.points)
    {
      EXPECT_NEAR(point.position.z(), sheet, 1e-9);
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
