#include "Error.h"
#include "Functions.h"
#include "MeshExamples.h"
#include "ParameterCurve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::addNoise;
using Truth::Mesh;
using Truth::sphereMesh;
using Truth::squareMesh;
using Truth::torusMesh;

TikhonovSmoother smootherOf(const Mesh& mesh, SmoothingEnergy energy = SmoothingEnergy::Biharmonic,
  DataMetric metric = DataMetric::Identity)
{
  const auto laplacian = std::make_shared<Laplacian>(
    meshLaplacian(mesh.vertices, mesh.triangles, LaplacianWeights::Cotangent));
  return { laplacian, metricMatrix(metric, *laplacian, mesh.vertices, mesh.triangles), energy };
}

Values smoothFunction(const Mesh& mesh)
{
  return Truth::valuesOf(
    [](const Vector3d& p)
    {
      return 0.9 * p.x() + 0.31 * p.y() + 0.17 * p.z() +
        0.15 * std::sin(4 * p.y() + 1) * std::cos(3 * p.x());
    },
    mesh.vertices);
}

/// @param noise of the range
Values noisy(Values values, double noise)
{
  addNoise(values, noise * (values.maxCoeff() - values.minCoeff()), 1);
  return values;
}

// The function smoothed with the epsilon of cross-validation, which does not know the clean one, is
// nearly as close to that as with the best epsilon.
TEST(ParameterCurve, findsNearlyTheBestEpsilon)
{
  for (const Mesh& mesh : { sphereMesh(4), torusMesh(60, false), torusMesh(60, true) })
  {
    const TikhonovSmoother smoother = smootherOf(mesh);
    const Values clean = smoothFunction(mesh);
    for (const double noise : { 0.01, 0.05, 0.1 })
    {
      const Values f = noisy(clean, noise);
      const ParameterCurve curve = parameterCurve(smoother, f);
      double least = std::numeric_limits<double>::infinity();
      for (double epsilon = 1e2; epsilon < 1e10; epsilon *= 3.0)
      {
        const Values x = smoother.smooth(f, epsilon, {}, 1e-4);
        least = std::min(least, smoother.distance(x, clean));
      }
      const Values chosen = smoother.smooth(f, chooseEpsilon(curve, EpsilonChoice::GCV));
      EXPECT_LE(smoother.distance(chosen, clean), 1.25 * least) << mesh.vertices.cols() << noise;
    }
  }
}

// Noise of vertices is recognized in any metric, also where triangles differ in area by 1 to 25.
TEST(ParameterCurve, countsVerticesAlikeInAnyMetric)
{
  const Mesh mesh = torusMesh(60, true);
  const Values clean = smoothFunction(mesh);
  const Values f = noisy(clean, 0.05);
  for (const DataMetric metric : { DataMetric::MassMatrix, DataMetric::LumpedMass })
  {
    const TikhonovSmoother smoother = smootherOf(mesh, SmoothingEnergy::Biharmonic, metric);
    double least = std::numeric_limits<double>::infinity();
    for (double epsilon = 1e2; epsilon < 1e10; epsilon *= 3.0)
    {
      least = std::min(least, (smoother.smooth(f, epsilon, {}, 1e-4) - clean).norm());
    }
    const double epsilon = chooseEpsilon(parameterCurve(smoother, f), EpsilonChoice::GCV);
    EXPECT_LE((smoother.smooth(f, epsilon) - clean).norm(), 1.25 * least);
  }
}

// With less smoothing the residual falls and the energy grows. The trace of f -> x is estimated:
// the exact one is the sum of gains. The curvature is that of the curve, by differences.
TEST(ParameterCurve, isThatOfDenseMatrices)
{
  const Mesh mesh = torusMesh(16, true);
  const Values f = noisy(smoothFunction(mesh), 0.1);
  for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    const TikhonovSmoother smoother = smootherOf(mesh, energy);
    const ParameterCurve curve = parameterCurve(smoother, f);
    for (Eigen::Index i = 0; i < curve.epsilons.size(); ++i)
    {
      const double epsilon = curve.epsilons[i];
      const double length = std::log(curve.epsilons.maxCoeff() / curve.epsilons.minCoeff());
      ASSERT_GT(length, 10.0);
      if (i > 0)
      {
        EXPECT_GT(epsilon, curve.epsilons[i - 1]);
        EXPECT_LT(curve.residuals[i], curve.residuals[i - 1]);
        EXPECT_GT(curve.seminorms[i], curve.seminorms[i - 1]);
      }
      double trace = 0.0;
      for (Eigen::Index k = 0; k < f.size(); ++k)
      {
        trace += smoother.smooth(Values::Unit(f.size(), k), epsilon)[k];
      }
      const double share = 1.0 - trace / static_cast<double>(f.size());
      const double meanSquare = (f - smoother.smooth(f, epsilon)).squaredNorm() / f.size();
      EXPECT_NEAR(std::sqrt(meanSquare / curve.gcv[i]), share, 0.1 * share);

      std::vector<Vector2d> places;
      for (const double factor : { 0.9, 1.0, 1.0 / 0.9 })
      {
        const Values x = smoother.smooth(f, factor * epsilon, {}, 1e-11);
        places.emplace_back(std::log(smoother.distance(x, f)), 0.5 * std::log(smoother.energy(x)));
      }
      const Vector2d first = places[1] - places[0];
      const Vector2d second = places[2] - places[1];
      const double turn = first.y() * second.x() - first.x() * second.y();
      const double expected = 2.0 * turn / (first.norm() * second.norm() * (first + second).norm());
      EXPECT_NEAR(curve.curvatures[i], expected, 0.02 * std::abs(expected) + 0.01) << epsilon;
    }
  }
}

// Where the L-curve has no corner, epsilon is that of cross-validation, and not at an end of the
// range.
TEST(ParameterCurve, takesCrossValidationWithoutACorner)
{
  ParameterCurve curve;
  curve.epsilons =
    Values::LinSpaced(5, 1.0, 5.0).unaryExpr([](double x) { return std::pow(10, x); });
  curve.gcv = (Values(5) << 4.0, 3.0, 1.0, 2.0, 5.0).finished();
  for (const Values& bent :
    { Values(-Values::Ones(5)), Values(Values::LinSpaced(5, -2.0, 2.0)), Values(Values::Zero(5)) })
  {
    curve.curvatures = bent;
    EXPECT_EQ(
      chooseEpsilon(curve, EpsilonChoice::LCurve), chooseEpsilon(curve, EpsilonChoice::GCV));
  }
  curve.curvatures = (Values(5) << 9.0, 0.0, -1.0, 1.0, 0.0).finished();
  EXPECT_NEAR(std::log10(chooseEpsilon(curve, EpsilonChoice::LCurve)), 4.0, 0.5);
}

// The unit of f, a constant added and the unit of length do not matter.
TEST(ParameterCurve, hasNoUnit)
{
  Mesh mesh = torusMesh(40, true);
  const Values f = noisy(smoothFunction(mesh), 0.05);
  const auto chosen = [&](const Values& values, EpsilonChoice choice) {
    return std::log10(chooseEpsilon(parameterCurve(smootherOf(mesh), values, {}, choice), choice));
  };
  const double expected = chosen(f, EpsilonChoice::GCV);
  const double corner = chosen(f, EpsilonChoice::LCurve);
  EXPECT_NEAR(
    chosen(1e3 * f + Values::Constant(f.size(), 9.0), EpsilonChoice::GCV), expected, 1e-3);
  mesh.vertices *= 1000.0;
  EXPECT_NEAR(chosen(f, EpsilonChoice::GCV), expected, 1e-3);
  EXPECT_NEAR(chosen(f, EpsilonChoice::LCurve), corner, 1e-2);
}

// Where there is nothing to smooth, or next to no mesh, some epsilon is chosen, and no harm is
// done.
TEST(ParameterCurve, survivesWhatIsDegenerate)
{
  Mesh tetrahedron = { Points(3, 4), Triangles(3, 4) };
  tetrahedron.vertices << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  tetrahedron.triangles << 0, 0, 0, 1, 2, 1, 3, 2, 1, 3, 2, 3;
  const Mesh torus = torusMesh(40, true);
  for (const Mesh& mesh : { tetrahedron, torus, squareMesh(1, 0.0) })
  {
    for (const Values& f : { Values(Values::Constant(mesh.vertices.cols(), 0.1)),
           smoothFunction(mesh), noisy(smoothFunction(mesh), 10.0) })
    {
      for (const EpsilonChoice choice : { EpsilonChoice::GCV, EpsilonChoice::LCurve })
      {
        const TikhonovSmoother smoother = smootherOf(mesh);
        const ParameterCurve curve = parameterCurve(smoother, f, {}, choice);
        EXPECT_TRUE(curve.gcv.allFinite() && curve.curvatures.allFinite());
        const double epsilon = chooseEpsilon(curve, choice);
        EXPECT_TRUE(epsilon > 0.0 && std::isfinite(epsilon)) << epsilon;
        EXPECT_TRUE(smoother.smooth(f, epsilon).allFinite());
      }
    }
  }
  const TikhonovSmoother smoother = smootherOf(torus); // without noise f remains
  const Values clean = smoothFunction(torus);
  const double epsilon = chooseEpsilon(parameterCurve(smoother, clean), EpsilonChoice::GCV);
  EXPECT_LT(smoother.distance(smoother.smooth(clean, epsilon), clean), 1e-3);
}

TEST(ParameterCurve, reportsProgressThatNeverFallsAndCanBeAborted)
{
  const Mesh mesh = torusMesh(40, false);
  const TikhonovSmoother smoother = smootherOf(mesh);
  const Values f = noisy(smoothFunction(mesh), 0.05);
  double last = 0.0;
  const Execution execution = { 0,
    [&last](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    } };
  parameterCurve(smoother, f, execution);
  EXPECT_EQ(last, 1.0);
  const Execution stopped = { 0, [](double fraction) { return fraction < 0.5; } };
  EXPECT_THROW(parameterCurve(smoother, f, stopped), Aborted);
}

} // namespace
} // namespace SurfaceScalars
