#include "CriticalPoints.h"
#include "CurveScore.h"
#include "ExactLevelSet.h"
#include "Sampling.h"
#include "Torus.h"
#include "TruthRun.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <numeric>

namespace SurfaceScalars::Truth
{
namespace
{

std::vector<SpaceFunction> bothFunctions()
{
  return { tiltedHeight(), saddleWithLogarithm() };
}

// Points have distance 0 from their surface, the normal is the distance's gradient, the tangents
// are orthogonal to it.
TEST(Truth, torusIsConsistent)
{
  Random random(3);
  for (int i = 0; i < 100; ++i)
  {
    const Vector2d angles(random.uniform(0.0, 2.0 * Pi), random.uniform(-Pi, Pi));
    const Vector3d point = torusPoint(angles);
    const Vector3d normal = torusNormal(angles);
    EXPECT_NEAR(torusDistance(point + 0.1 * normal), 0.1, 1e-14);
    EXPECT_LT((torusAngles(point + 0.1 * normal) - angles).norm(), 1e-13);
    EXPECT_LT((torusTangents(angles).transpose() * normal).norm(), 1e-14);
  }
}

// Gradients equal central differences.
TEST(Truth, gradientsAreDerivatives)
{
  const Vector3d place(0.7, -0.9, 0.3);
  for (const SpaceFunction& function :
    { tiltedHeight(), saddleWithLogarithm(), cosinesOfAngles(), planarSaddle(3) })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3d shift = 1e-5 * Vector3d::Unit(axis);
      const double difference = function.value(place + shift) - function.value(place - shift);
      EXPECT_NEAR(function.gradient(place)[axis], difference / 2e-5, 1e-8) << function.name;
    }
  }
}

// Poincare and Hopf: the indices of all critical points sum to the Euler characteristic. None is
// missed.
TEST(Truth, criticalIndicesSumToTheEulerCharacteristic)
{
  for (const ClosedSurface& surface : { unitSphere(), closedTorus(), doubleTorus() })
  {
    for (const SpaceFunction& function : bothFunctions())
    {
      const auto points = criticalPoints(surface, function);
      EXPECT_GE(points.size(), 2u) << function.name;
      int sum = 0;
      for (const CriticalPoint& point : points)
      {
        sum += indexOf(point);
        const Vector3d normal = surface.implicit.gradient(point.position).normalized();
        EXPECT_LT(function.gradient(point.position).cross(normal).norm(), 1e-9) << function.name;
        EXPECT_NEAR(surface.implicit.value(point.position), 0.0, 1e-12);
      }
      EXPECT_EQ(sum, surface.eulerCharacteristic) << function.name << " on the " << surface.name;
    }
  }
}

// cos 3u cos 2v: extrema where both cosines are 1 or -1, saddles where both vanish.
TEST(Truth, cosinesOfAnglesHave48CriticalPoints)
{
  const auto points = criticalPoints(closedTorus(), cosinesOfAngles());
  ASSERT_EQ(points.size(), 48u);
  for (const CriticalPoint& point : points)
  {
    const Vector2d halves(point.type == CriticalType::Saddle ? Vector2d(0.5, 0.5) : Vector2d(0, 0));
    const Vector2d angles = torusAngles(point.position);
    const Vector2d counts = Vector2d(angles.x() * 3.0 / Pi, angles.y() * 2.0 / Pi) - halves;
    EXPECT_LT((counts - counts.array().round().matrix()).norm(), 1e-9);
    const double expected = point.type == CriticalType::Saddle ? 0.0
      : point.type == CriticalType::Maximum                    ? 1.0
                                                               : -1.0;
    EXPECT_NEAR(point.value, expected, 1e-12);
  }
}

// Where random lines meet a torus is uniform by area: the outer half has (pi R + 2 r) / (2 pi R) of
// it.
TEST(Truth, crossingsOfRandomLinesAreUniform)
{
  const int count = 20000;
  const Points points = randomCrossings(closedTorus().implicit, 1.5, count, 5);
  const Points outer = select(points, [](const Vector3d& p) { return p.head<2>().norm() > 1.0; });
  const double share = (Pi * MajorRadius + 2.0 * MinorRadius) / (2.0 * Pi * MajorRadius);
  EXPECT_NEAR(static_cast<double>(outer.cols()) / count, share, 3.0 * std::sqrt(0.25 / count));
  for (int i = 0; i < count; ++i)
  {
    EXPECT_NEAR(torusDistance(points.col(i)), 0.0, 1e-12);
  }
}

// The critical values bound f, and iso-values chosen from them are distinct and keep their
// distance.
TEST(Truth, isoValuesKeepAwayFromCriticalValues)
{
  for (const TruthCase& truthCase : truthCases())
  {
    const auto critical = criticalValues(truthCase.function, truthCase.torus);
    const Values values = valuesOf(truthCase.function, randomTorus(20000, truthCase.torus, 1));
    EXPECT_LE(critical.front(), values.minCoeff());
    EXPECT_GE(critical.back(), values.maxCoeff());
    EXPECT_LT(critical.back() - values.maxCoeff(), 0.01 * truthCase.range);

    ASSERT_EQ(truthCase.isoValues.size(), 20u);
    for (std::size_t i = 0; i < 20; ++i)
    {
      EXPECT_TRUE(i == 0 || truthCase.isoValues[i] > truthCase.isoValues[i - 1]);
      for (const double value : critical)
      {
        EXPECT_GE(std::abs(truthCase.isoValues[i] - value), 0.01 * truthCase.range);
      }
    }
  }
}

// Morse theory: passing an extremum changes the number of closed curves by one, so does a saddle;
// all are closed without boundary.
TEST(Truth, curveCountsChangeByOneAtSimpleCriticalPoints)
{
  const SpaceFunction function = tiltedHeight();
  const auto critical = criticalValues(function, Torus::Closed);
  const LevelSetFamily family(function, Torus::Closed);
  ASSERT_EQ(critical.size(), 4u);
  const std::vector<int> expected{ 1, 2, 1 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const ExactLevelSet levelSet = family.at(0.5 * (critical[i] + critical[i + 1]));
    EXPECT_EQ(levelSet.closedCount, expected[i]);
    EXPECT_EQ(levelSet.openCount, 0);
  }
}

// Contouring is converged: twice the resolution finds the same curves.
TEST(Truth, curveCountsDoNotDependOnTheGrid)
{
  for (const TruthCase& truthCase : truthCases())
  {
    const LevelSetFamily coarse(truthCase.function, truthCase.torus, 500);
    for (const ExactLevelSet& exact : truthCase.exact)
    {
      const ExactLevelSet other = coarse.at(exact.isoValue);
      EXPECT_EQ(other.closedCount, exact.closedCount) << truthCase.function.name;
      EXPECT_EQ(other.openCount, exact.openCount) << truthCase.function.name;
    }
  }
}

// The points of a level set solve f = alpha on the torus, and projection leaves them where they
// are.
TEST(Truth, pointsOfLevelSetsAreExact)
{
  for (const TruthCase& truthCase : truthCases())
  {
    const ExactLevelSet& exact = truthCase.exact[9];
    ASSERT_GT(exact.points.size(), 500u);
    for (std::size_t i = 0; i < exact.points.size(); i += 17)
    {
      EXPECT_NEAR(truthCase.function.value(exact.points[i]), exact.isoValue, 1e-12);
      EXPECT_NEAR(torusDistance(exact.points[i]), 0.0, 1e-12);
      Vector3d place = exact.points[i];
      ASSERT_TRUE(projectOntoLevelSet(truthCase.function, exact.isoValue, place));
      EXPECT_LT((place - exact.points[i]).norm(), 1e-10);
    }
  }
}

// A place moved away from a curve along a direction normal to it is as far away as it was moved.
TEST(Truth, projectionFindsTheClosestPoint)
{
  const TruthCase& truthCase = truthCases()[2];
  const ExactLevelSet& exact = truthCase.exact[9];
  for (std::size_t i = 0; i < exact.points.size(); i += 23)
  {
    const Vector3d normal = torusNormal(torusAngles(exact.points[i]));
    const Vector3d gradient = truthCase.function.gradient(exact.points[i]);
    const Vector3d tangent = gradient.cross(normal).normalized();
    const Vector3d away = (normal + 0.7 * normal.cross(tangent)).normalized();
    Vector3d foot = exact.points[i] + 0.05 * away;
    ASSERT_TRUE(projectOntoLevelSet(truthCase.function, exact.isoValue, foot));
    EXPECT_LT((foot - exact.points[i]).norm(), 1e-9);
  }
}

// A polygon inscribed in the unit circle lies within its sagitta.
TEST(Truth, polylineDistanceIsTheSagitta)
{
  const int corners = 12;
  LevelSetCurve polygon{ 0, 0, true, 0.0, {} };
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * i / corners;
    polygon.points.push_back(
      { Vector3d(std::cos(angle), std::sin(angle), 0.0), Vector3d::UnitZ(), 0.0, true });
  }
  std::vector<Vector3d> circle;
  for (int i = 0; i < 60 * corners; ++i)
  {
    const double angle = 2.0 * Pi * i / (60.0 * corners);
    circle.push_back({ std::cos(angle), std::sin(angle), 0.0 });
  }
  const double sagitta = 1.0 - std::cos(Pi / corners);
  EXPECT_NEAR(largestDistance(circle, { &polygon }), sagitta, 1e-12);

  polygon.closed = false;
  EXPECT_GT(largestDistance(circle, { &polygon }), 0.2);
}

} // namespace
} // namespace SurfaceScalars::Truth
