#include "CriticalCases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

const Vector3d Center(0.013, -0.007, 0.0);

/// Re (x + iy)^power about the center: a saddle of multiplicity power - 1.
Values multipleSaddle(const PointsRef& points, int power)
{
  return valuesAt(points,
    [=](const Vector3d& place)
    {
      const Vector3d offset = place - Center;
      return std::pow(std::complex<double>(offset.x(), offset.y()), power).real();
    });
}

std::size_t countOf(const FoundPoints& found, CriticalType type)
{
  return static_cast<std::size_t>(std::count_if(found.critical.points.begin(),
    found.critical.points.end(), [=](const CriticalPoint& point) { return point.type == type; }));
}

bool isFinite(const FoundPoints& found)
{
  const SampleCriticality& samples = found.critical.samples;
  return samples.probability.allFinite() && samples.gradient.allFinite() &&
    samples.normal.allFinite();
}

} // namespace

// Saddles of multiplicity 2 to 4, whose Hessian is zero, are one point each, with its multiplicity.
TEST(DegenerateCriticalPoints, areMultipleSaddles)
{
  for (const int power : { 3, 4, 5 })
  {
    for (const unsigned seed : { 1u, 2u })
    {
      const Points points = randomPlane(10000, seed);
      const FoundPoints found = findAmong(points, multipleSaddle(points, power));
      ASSERT_EQ(found.critical.points.size(), 1u) << power;
      EXPECT_EQ(found.critical.points[0].type, CriticalType::Saddle);
      EXPECT_EQ(found.critical.points[0].multiplicity, power - 1);
      EXPECT_LT((found.critical.points[0].position - Center).norm(),
        0.2 * found.graph.medianSamplingStep());
    }
  }
}

// A monkey saddle shows through noise.
TEST(DegenerateCriticalPoints, areMultipleSaddlesInNoise)
{
  const Points points = randomPlane(20000, 3);
  Values values = multipleSaddle(points, 3);
  addNoise(values, 0.01 * (values.maxCoeff() - values.minCoeff()), 4);
  const FoundPoints found = findAmong(points, values);
  EXPECT_EQ(found.critical.indexSum, -2);
  ASSERT_EQ(found.critical.points.size(), 1u);
  EXPECT_EQ(found.critical.points[0].multiplicity, 2);
}

// x^4 + y^4 has a minimum that its Hessian does not show.
TEST(DegenerateCriticalPoints, areFlatMinima)
{
  const Points points = randomPlane(10000, 5);
  const FoundPoints found = findAmong(points,
    valuesAt(points, [](const Vector3d& p) { return std::pow(p.x(), 4) + std::pow(p.y(), 4); }));
  ASSERT_EQ(found.critical.points.size(), 1u);
  EXPECT_EQ(found.critical.points[0].type, CriticalType::Minimum);
}

// Along a line of minima, or a circle of maxima, no type is guessed.
TEST(DegenerateCriticalPoints, areUncertainAlongRidges)
{
  const Points plane = randomPlane(10000, 6);
  const Points torus = randomTorus(10000, Torus::Closed, 6);
  for (const FoundPoints& found :
    { findAmong(plane, valuesAt(plane, [](const Vector3d& p) { return p.x() * p.x(); })),
      findAmong(torus, valuesAt(torus, [](const Vector3d& p) { return p.z(); })) })
  {
    EXPECT_GT(found.critical.points.size(), 0u);
    EXPECT_EQ(found.critical.points.size(), countOf(found, CriticalType::Uncertain));
  }
}

// A constant has no critical points, no gradient, and nothing is probable; nor has a linear
// function on a plane.
TEST(DegenerateCriticalPoints, areNoneOfConstants)
{
  const Points points = randomPlane(3000, 7);
  const FoundPoints constant = findAmong(points, Values::Constant(3000, 3.0));
  EXPECT_TRUE(constant.critical.points.empty());
  EXPECT_TRUE(constant.critical.samples.probability.isZero(0.0));
  EXPECT_TRUE(constant.critical.samples.gradient.isZero(0.0));
  EXPECT_TRUE(isFinite(constant));

  const FoundPoints linear =
    findAmong(points, valuesAt(points, [](const Vector3d& p) { return p.x() + 2.0 * p.y(); }));
  EXPECT_TRUE(linear.critical.points.empty());
}

// Where f is constant on a region, neither the region nor its edge is critical.
TEST(DegenerateCriticalPoints, areNoneOfPlateaus)
{
  const Points points = randomPlane(10000, 8);
  const FoundPoints found = findAmong(points,
    valuesAt(points, [](const Vector3d& p) { return std::max(0.0, 0.5 - p.squaredNorm()); }));
  ASSERT_EQ(found.critical.points.size(), 1u);
  EXPECT_EQ(found.critical.points[0].type, CriticalType::Maximum);
  EXPECT_TRUE(isFinite(found));
}

// A paraboloid has its minimum where its vertex is on the sampled square, and no critical point
// where it is beyond the boundary, whose extrema do not count.
TEST(CriticalPointsAtBoundaries, areNotThoseOfTheBoundary)
{
  const Points points = randomPlane(10000, 9);
  for (const double vertex : { 0.0, 0.9, 1.03, 1.1, 1.5 })
  {
    const FoundPoints found = findAmong(points,
      valuesAt(points,
        [=](const Vector3d& p) { return std::pow(p.x() - vertex, 2) + 0.5 * p.y() * p.y(); }));
    EXPECT_EQ(found.critical.points.size(), vertex < 1.0 ? 1u : 0u) << vertex;
  }
}

// The height of a torus with a piece cut out keeps the critical points that are left.
TEST(CriticalPointsAtBoundaries, areThoseOfTheRest)
{
  const CriticalCase truth = tiltedTorus();
  const Points points = randomTorus(20000, Torus::Cut, 10);
  const FoundPoints found = findAmong(points, valuesAt(points, truth.value));
  std::size_t left = 0;
  for (const ExactPoint& exact : truth.exact)
  {
    left += distanceFromCut(exact.position) > 0.0 ? 1 : 0;
  }
  EXPECT_EQ(found.critical.points.size(), left);
}
