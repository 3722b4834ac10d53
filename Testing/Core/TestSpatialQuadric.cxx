#include "Sampling.h"
#include "SpatialQuadric.h"

#include <gtest/gtest.h>

#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

double aQuadric(const Vector3d& p)
{
  return 1.0 - 2.0 * p.x() + 0.5 * p.z() + p.x() * p.y() - 3.0 * p.z() * p.z();
}

QuadricMoments momentsOf(const PointsRef& places, const ValuesRef& values)
{
  QuadricMoments moments;
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    moments.add(places.col(i), values[i]);
  }
  return moments;
}

Values quadricsAt(const PointsRef& places)
{
  Values values(places.cols());
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    values[i] = aQuadric(places.col(i));
  }
  return values;
}

// Values of a quadric are reproduced elsewhere on the surface, also on a plane and a sphere, on
// which other quadrics have them too; nothing is left of them.
TEST(SpatialQuadric, reproducesQuadrics)
{
  for (const Points& places : { randomTorus(60, {}, 1), randomSphere(60, 2), randomPlane(60, 3) })
  {
    const SpatialQuadric quadric =
      momentsOf(places.leftCols(40), quadricsAt(places.leftCols(40))).solve();
    for (Eigen::Index i = 40; i < 60; ++i)
    {
      EXPECT_NEAR(
        quadric.coefficients.dot(quadricTerms(places.col(i))), aQuadric(places.col(i)), 1e-7);
    }
    EXPECT_LT(quadric.variance, 1e-12);
  }
}

// Noise makes differences of values vary as stated, and is found again in the residuals.
TEST(SpatialQuadric, tellsTheVarianceOfDifferences)
{
  const int repetitions = 2000;
  const Points places = randomSphere(80, 4);
  const QuadricVector difference = quadricTerms(places.col(0)) - quadricTerms(places.col(1));
  double found = 0.0;
  double stated = 0.0;
  double variance = 0.0;
  for (unsigned seed = 0; seed < repetitions; ++seed)
  {
    Values values = Values::Zero(places.cols());
    addNoise(values, 0.1, 100 + seed);
    const SpatialQuadric quadric = momentsOf(places, values).solve();
    found += std::pow(quadric.coefficients.dot(difference), 2) / repetitions;
    stated += quadric.ofDifference(difference) / repetitions;
    variance += quadric.variance / repetitions;
  }
  EXPECT_NEAR(found, stated, 0.1 * stated);
  EXPECT_NEAR(variance, 0.01, 1e-4);
}

// Fits to some and to all of the values of a quadric with noise are alike but for one of two
// hundred; those to a cubic of ten times the noise are not.
TEST(SpatialQuadric, isComparedAsNoiseAllows)
{
  const int repetitions = 500;
  const Points places = randomPlane(400, 5);
  const Points inner = select(places, [](const Vector3d& p) { return p.norm() < 0.5; });
  const Points core = select(inner, [](const Vector3d& p) { return p.norm() < 0.25; });
  const QuadricMatrix spread = momentsOf(core, Values::Zero(core.cols())).spread();
  for (const double cubic : { 0.0, 1.0 })
  {
    int alike = 0;
    for (unsigned seed = 0; seed < repetitions; ++seed)
    {
      Values values = quadricsAt(places);
      values +=
        cubic * places.row(0).transpose().cwiseProduct(places.row(0).transpose().cwiseAbs2());
      addNoise(values, 0.1, 1000 + seed);
      QuadricMoments some;
      for (Eigen::Index i = 0; i < places.cols(); ++i)
      {
        if (places.col(i).norm() < 0.5)
        {
          some.add(places.col(i), values[i]);
        }
      }
      alike += areAlike(some.solve(), momentsOf(places, values).solve(), spread) ? 1 : 0;
    }
    if (cubic == 0.0)
    {
      EXPECT_GT(alike, 0.995 * repetitions);
    }
    else
    {
      EXPECT_LT(alike, 0.1 * repetitions);
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
