#include "Error.h"
#include "Functions.h"
#include "MeshExamples.h"
#include "Tikhonov.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <string>
#include <tuple>

namespace SurfaceScalars
{
namespace
{

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using testing::HasSubstr;
using Truth::addNoise;
using Truth::Mesh;
using Truth::sphereMesh;
using Truth::squareMesh;
using Truth::torusMesh;

struct Smoothing
{
  Smoothing(const Mesh& mesh, SmoothingEnergy energy, DataMetric metric,
    LaplacianWeights weights = LaplacianWeights::Cotangent)
    : laplacian(std::make_shared<Laplacian>(meshLaplacian(mesh.vertices, mesh.triangles, weights)))
    , metricMatrix(SurfaceScalars::metricMatrix(metric, *laplacian, mesh.vertices, mesh.triangles))
    , smoother(laplacian, metricMatrix, energy)
  {
  }

  std::shared_ptr<const Laplacian> laplacian;
  Eigen::SparseMatrix<double> metricMatrix;
  TikhonovSmoother smoother;
};

Values noisyHeight(const Mesh& mesh, double noise = 0.1)
{
  Values result = mesh.vertices.transpose() * Vector3d(0.5, 0.2, 0.84);
  addNoise(result, noise, 1);
  return result;
}

double largest(const Values& values)
{
  return values.lpNorm<Eigen::Infinity>();
}

class TikhonovSystem
  : public testing::TestWithParam<std::tuple<SmoothingEnergy, DataMetric, LaplacianWeights>>
{
};
INSTANTIATE_TEST_SUITE_P(All, TikhonovSystem,
  testing::Combine(testing::Values(SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic),
    testing::Values(DataMetric::Identity, DataMetric::MassMatrix, DataMetric::LumpedMass),
    testing::Values(LaplacianWeights::Cotangent, LaplacianWeights::NormalizedCotangent,
      LaplacianWeights::MeanValue)));

// (S^T A^-1 S + t W) x = t W f or (S + t W) x = t W f, solved by dense elimination with more
// digits, has the same solution, on an irregular mesh and for any epsilon.
TEST_P(TikhonovSystem, isSolved)
{
  const auto [energy, dataMetric, weights] = GetParam();
  const Mesh mesh = torusMesh(20, true);
  const Smoothing smoothing(mesh, energy, dataMetric, weights);
  const LongMatrix stiffness = Eigen::MatrixXd(smoothing.laplacian->stiffness).cast<long double>();
  const LongMatrix metric = Eigen::MatrixXd(smoothing.metricMatrix).cast<long double>();
  const LongVector mass = smoothing.laplacian->mass.cast<long double>();
  const bool isHarmonic = energy == SmoothingEnergy::Harmonic;
  const LongMatrix product = isHarmonic
    ? stiffness
    : LongMatrix(stiffness.transpose() * mass.asDiagonal().inverse() * stiffness);
  const Values f = noisyHeight(mesh);
  for (const double epsilon : { 1e-6, 1.0, 1e5, 1e14 })
  {
    const long double t = epsilon / (isHarmonic ? mass.sum() : mass.sum() * mass.sum());
    const LongMatrix matrix = product + t * metric;
    const LongVector expected = matrix.partialPivLu().solve(t * (metric * f.cast<long double>()));
    const Values found = smoothing.smoother.smooth(f, epsilon);
    EXPECT_LT(largest(found - expected.cast<double>()), 1e-7) << epsilon;
  }
}

// The energies of the symmetric operators are those of their matrices.
TEST(Tikhonov, tellsTheEnergy)
{
  const Mesh mesh = squareMesh(8, 0.3);
  const Values f = noisyHeight(mesh);
  for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    const Smoothing smoothing(mesh, energy, DataMetric::MassMatrix);
    const Values image = smoothing.laplacian->stiffness * f;
    const double expected = energy == SmoothingEnergy::Harmonic
      ? f.dot(image)
      : image.cwiseAbs2().cwiseQuotient(smoothing.laplacian->mass).sum();
    EXPECT_NEAR(smoothing.smoother.energy(f), expected, 1e-9 * expected);
    EXPECT_NEAR(std::pow(smoothing.smoother.distance(2.0 * f, f), 2),
      f.dot(smoothing.metricMatrix * f), 1e-12);
  }
}

// Half of a spherical harmonic of degree l = 6 is left if epsilon = (l (l + 1) area)^2, whatever
// the resolution and the unit of length.
TEST(Tikhonov, hasAGainThatDependsOnEpsilonAlone)
{
  for (const int times : { 5, 6 })
  {
    Mesh mesh = sphereMesh(times);
    Values harmonic(mesh.vertices.cols());
    for (Eigen::Index i = 0; i < harmonic.size(); ++i)
    {
      const std::complex<double> place(mesh.vertices(0, i), mesh.vertices(1, i));
      harmonic[i] = std::pow(place, 6).real();
    }
    std::array<double, 2> gains{};
    for (double& gain : gains)
    {
      const Smoothing smoothing(mesh, SmoothingEnergy::Biharmonic, DataMetric::LumpedMass);
      const Values result = smoothing.smoother.smooth(harmonic, 278600.0);
      const Values weighted = smoothing.laplacian->mass.cwiseProduct(harmonic);
      gain = weighted.dot(result) / weighted.dot(harmonic);
      mesh.vertices *= 1000.0;
    }
    EXPECT_NEAR(gains[0], 0.5, times == 5 ? 0.006 : 0.002);
    EXPECT_NEAR(gains[1], gains[0], 1e-8);
  }
}

// Nothing is prescribed at a boundary, and so cosines, whose derivative across it is 0, are
// eigenfunctions on a square.
TEST(Tikhonov, hasANaturalBoundaryCondition)
{
  const Mesh mesh = squareMesh(60, 0.0);
  const Values cosines = Truth::valuesOf([](const Vector3d& p)
    { return std::cos(Pi * p.x()) * std::cos(2 * Pi * p.y()); },
    mesh.vertices);
  const double eigenvalue = 5 * Pi * Pi;
  const Smoothing smoothing(mesh, SmoothingEnergy::Biharmonic, DataMetric::LumpedMass);
  const double epsilon = 3 * eigenvalue * eigenvalue;
  EXPECT_LT(largest(smoothing.smoother.smooth(cosines, epsilon) - 0.75 * cosines), 0.004);
  const double length = smoothing.smoother.smoothingLength(eigenvalue * eigenvalue);
  EXPECT_NEAR(length, 1.0 / std::sqrt(eigenvalue), 1e-12);
  EXPECT_NEAR(smoothing.smoother.epsilonOfLength(length), eigenvalue * eigenvalue, 1e-8);
}

// The metrics agree on the area of what is constant; the mass matrix is that of the paper.
TEST(Tikhonov, hasMetricsOfTheSameArea)
{
  const Mesh mesh = squareMesh(8, 0.3);
  const Laplacian laplacian =
    meshLaplacian(mesh.vertices, mesh.triangles, LaplacianWeights::Cotangent);
  const Values ones = Values::Ones(mesh.vertices.cols());
  for (const DataMetric metric :
    { DataMetric::Identity, DataMetric::MassMatrix, DataMetric::LumpedMass })
  {
    const Eigen::SparseMatrix<double> matrix =
      metricMatrix(metric, laplacian, mesh.vertices, mesh.triangles);
    EXPECT_NEAR(ones.dot(matrix * ones), 1.0, 1e-12);
    if (metric == DataMetric::MassMatrix) // of a linear function: the integral of x^2
    {
      const Values x = mesh.vertices.row(0);
      EXPECT_NEAR(x.dot(matrix * x), 1.0 / 3.0, 1e-12);
      EXPECT_LT(largest(matrix * ones - laplacian.mass), 1e-15);
    }
  }
}

// Constants remain, on each component another; a constant added to f, or a factor, is found again
// in the result; the mean of each component remains.
TEST(Tikhonov, isLinearAndKeepsConstants)
{
  Mesh mesh = torusMesh(30, true);
  const Eigen::Index count = mesh.vertices.cols();
  const Eigen::Index triangles = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, 2 * count + 1);
  mesh.vertices.middleCols(count, count) =
    mesh.vertices.leftCols(count).colwise() + Vector3d(9, 0, 0);
  mesh.vertices.col(2 * count).setZero(); // of no triangle
  mesh.triangles.conservativeResize(3, 2 * triangles);
  mesh.triangles.rightCols(triangles) =
    mesh.triangles.leftCols(triangles).array() + static_cast<Index>(count);
  Values constants = Values::Constant(mesh.vertices.cols(), 0.1);
  constants.head(count).setConstant(1e3);
  const Values f = noisyHeight(mesh);
  for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    const Smoothing smoothing(mesh, energy, DataMetric::Identity);
    EXPECT_EQ(smoothing.smoother.smooth(constants, 1e3), constants);
    const Values x = smoothing.smoother.smooth(f, 1e3);
    EXPECT_LT(largest(smoothing.smoother.smooth(f + constants, 1e3) - x - constants), 1e-8);
    EXPECT_LT(largest(smoothing.smoother.smooth(1e-300 * f, 1e3) * 1e300 - x), 1e-8);
    EXPECT_LT(largest(smoothing.smoother.smooth(1e300 * f, 1e3) / 1e300 - x), 1e-8);
    EXPECT_NEAR(x.head(count).mean(), f.head(count).mean(), 1e-8);
    EXPECT_NEAR(x[2 * count], f[2 * count], 1e-12);
  }
}

// With positive weights, also such that are not symmetric, the harmonic solution is between the
// least and the greatest f.
TEST(Tikhonov, obeysAMaximumPrinciple)
{
  const Mesh mesh = torusMesh(40, true);
  const Smoothing smoothing(
    mesh, SmoothingEnergy::Harmonic, DataMetric::LumpedMass, LaplacianWeights::MeanValue);
  const Values f = noisyHeight(mesh);
  for (const double epsilon : { 0.01, 1.0, 100.0, 1e4, 1e6 })
  {
    const Values x = smoothing.smoother.smooth(f, epsilon);
    EXPECT_GE(x.minCoeff(), f.minCoeff() - 1e-7);
    EXPECT_LE(x.maxCoeff(), f.maxCoeff() + 1e-7);
  }
}

// A smoother that was used for another epsilon, and one that was aborted, solves as a new one.
TEST(Tikhonov, canBeUsedAgain)
{
  const Mesh mesh = torusMesh(60, true);
  const Values f = noisyHeight(mesh);
  for (const LaplacianWeights weights :
    { LaplacianWeights::Cotangent, LaplacianWeights::MeanValue })
  {
    for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
    {
      const auto made = [&]() { return Smoothing(mesh, energy, DataMetric::Identity, weights); };
      const Values expected = made().smoother.smooth(f, 1e4);
      const Smoothing smoothing = made();
      smoothing.smoother.smooth(f, 1e7);
      EXPECT_EQ(smoothing.smoother.smooth(f, 1e4), expected);
      for (const double last : { 0.0, 0.2, 0.6 })
      {
        const Execution execution = { 0, [last](double fraction) { return fraction < last; } };
        EXPECT_THROW(smoothing.smoother.smooth(f, 1e6, execution), Aborted);
        EXPECT_EQ(smoothing.smoother.smooth(f, 1e4), expected);
      }
    }
  }
}

TEST(Tikhonov, reportsProgressThatNeverFalls)
{
  const Mesh mesh = torusMesh(60, false);
  const Smoothing smoothing(mesh, SmoothingEnergy::Biharmonic, DataMetric::Identity);
  double last = 0.0;
  const Execution execution = { 0,
    [&last](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return true;
    } };
  smoothing.smoother.smooth(noisyHeight(mesh), 1e5, execution);
  EXPECT_EQ(last, 1.0);
}

// Triangles without area do no harm.
TEST(Tikhonov, survivesSlivers)
{
  Mesh mesh = squareMesh(20, 0.3);
  for (Eigen::Index i = 30; i < 400; i += 37)
  {
    mesh.vertices.col(i) = mesh.vertices.col(i + 1); // four triangles without area
  }
  const Values f = noisyHeight(mesh);
  for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    for (const double epsilon : { 1e-6, 1e5, 1e14 })
    {
      const Smoothing smoothing(mesh, energy, DataMetric::Identity);
      const Values x = smoothing.smoother.smooth(f, epsilon);
      EXPECT_NEAR(x.mean(), f.mean(), 1e-6);
      EXPECT_LT(largest(x), 2.0);
    }
  }
}

TEST(Tikhonov, checksItsInput)
{
  const Mesh mesh = squareMesh(4, 0.0);
  const Smoothing smoothing(mesh, SmoothingEnergy::Biharmonic, DataMetric::Identity);
  const auto refusal = [&](const Values& f, double epsilon)
  {
    try
    {
      smoothing.smoother.smooth(f, epsilon);
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  Values f = Values::Zero(25);
  EXPECT_THAT(refusal(f.head(24), 1.0), HasSubstr("25 vertices, found 24"));
  EXPECT_THAT(refusal(f, 0.0), HasSubstr("Epsilon"));
  EXPECT_THAT(refusal(f, std::numeric_limits<double>::infinity()), HasSubstr("inf"));
  f[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(f, 1.0), HasSubstr("finite"));
  EXPECT_THROW(TikhonovSmoother(
                 smoothing.laplacian, Eigen::SparseMatrix<double>(3, 3), SmoothingEnergy::Harmonic),
    InvalidInput);
}

} // namespace
} // namespace SurfaceScalars
