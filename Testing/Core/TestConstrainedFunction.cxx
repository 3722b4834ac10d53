#include "ConstrainedFunction.h"
#include "Error.h"
#include "MeshExamples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using testing::HasSubstr;
using Truth::Mesh;
using Truth::torusMesh;

std::shared_ptr<const Laplacian> laplacianOf(const Mesh& mesh, LaplacianWeights weights)
{
  return std::make_shared<Laplacian>(meshLaplacian(mesh.vertices, mesh.triangles, weights));
}

/// x^T matrix x is the energy.
Eigen::MatrixXd biharmonicMatrix(const Laplacian& laplacian)
{
  const Eigen::MatrixXd stiffness = laplacian.stiffness;
  return stiffness.transpose() * laplacian.mass.cwiseInverse().asDiagonal() * stiffness;
}

const std::vector<ValueConstraint> someConstraints = { { 3, -1.0 }, { 100, 2.0 }, { 101, 2.5 },
  { 250, 0.5 }, { 333, 1.0 }, { 100, 2.0 } };

class ConstrainedFunction : public testing::TestWithParam<LaplacianWeights>
{
};
INSTANTIATE_TEST_SUITE_P(Weights, ConstrainedFunction,
  testing::Values(LaplacianWeights::Cotangent, LaplacianWeights::MeanValue));

// (6): the values are as given, and elsewhere the energy's derivative is 0. That of the harmonic
// function, which the paper takes for the solution, is not, and its energy is greater.
TEST_P(ConstrainedFunction, interpolatesWithLeastEnergy)
{
  const auto laplacian = laplacianOf(torusMesh(30, true), GetParam());
  const Eigen::MatrixXd matrix = biharmonicMatrix(*laplacian);
  const Values x = interpolateConstraints(*laplacian, SmoothingEnergy::Biharmonic, someConstraints);
  Values derivative = matrix * x;
  for (const auto& [vertex, value] : someConstraints)
  {
    EXPECT_EQ(x[vertex], value);
    EXPECT_GT(std::abs(derivative[vertex]), 0.01);
  }
  for (const ValueConstraint& constraint : someConstraints)
  {
    derivative[constraint.vertex] = 0.0;
  }
  EXPECT_LT(
    derivative.lpNorm<Eigen::Infinity>(), 1e-7 * (matrix.cwiseAbs() * x.cwiseAbs()).maxCoeff());

  const Values harmonic =
    interpolateConstraints(*laplacian, SmoothingEnergy::Harmonic, someConstraints);
  EXPECT_EQ(harmonic, harmonicFunction(*laplacian, someConstraints));
  EXPECT_GT(harmonic.dot(matrix * harmonic), 2.0 * x.dot(matrix * x));
}

// (7) equals the solution of its normal equations by dense elimination with more digits,
// for any epsilon.
TEST_P(ConstrainedFunction, fitsInTheSenseOfLeastSquares)
{
  const auto laplacian = laplacianOf(torusMesh(26, true), GetParam());
  const LongMatrix stiffness = Eigen::MatrixXd(laplacian->stiffness).cast<long double>();
  const long double area = laplacian->mass.sum();
  const auto count = static_cast<int>(laplacian->mass.size());
  for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    const bool isHarmonic = energy == SmoothingEnergy::Harmonic;
    for (const double epsilon : { 0.1, 1e2, 1e5, 1e12 })
    {
      const long double t = epsilon / (isHarmonic ? 1.0L : area) / count;
      LongMatrix matrix = stiffness;
      if (!isHarmonic)
      {
        matrix = stiffness.transpose() *
          laplacian->mass.cast<long double>().asDiagonal().inverse() * stiffness;
      }
      LongVector right = LongVector::Zero(count);
      for (const auto& [vertex, value] : someConstraints)
      {
        matrix(vertex, vertex) += right[vertex] == 0.0L ? t : 0.0L; // one is there twice
        right[vertex] = t * value;
      }
      const LongVector expected = matrix.partialPivLu().solve(right);
      const Values found = fitConstraints(laplacian, energy, someConstraints, epsilon);
      EXPECT_LT((found - expected.cast<double>()).lpNorm<Eigen::Infinity>(), 1e-6) << epsilon;
    }
  }
}

// The closer the fit, the closer it is to interpolation; the looser, to the mean.
TEST(ConstrainedFunctionFit, isBetweenTheMeanAndInterpolation)
{
  const auto laplacian = laplacianOf(torusMesh(30, false), LaplacianWeights::Cotangent);
  const Values exact =
    interpolateConstraints(*laplacian, SmoothingEnergy::Biharmonic, someConstraints);
  const Values close =
    fitConstraints(laplacian, SmoothingEnergy::Biharmonic, someConstraints, 1e13);
  EXPECT_LT((close - exact).lpNorm<Eigen::Infinity>(), 1e-3);
  const Values loose =
    fitConstraints(laplacian, SmoothingEnergy::Biharmonic, someConstraints, 1e-6);
  EXPECT_LT((loose.array() - 1.0).abs().maxCoeff(), 1e-3); // the mean of five
}

// Constants, and the unit of f, are found again.
TEST(ConstrainedFunctionFit, isLinear)
{
  const auto laplacian = laplacianOf(torusMesh(30, true), LaplacianWeights::Cotangent);
  std::vector<ValueConstraint> moved = someConstraints;
  for (ValueConstraint& constraint : moved)
  {
    constraint.value = 1e3 * constraint.value + 7.0;
  }
  const auto solutions = [&](const std::vector<ValueConstraint>& constraints)
  {
    return std::pair(interpolateConstraints(*laplacian, SmoothingEnergy::Biharmonic, constraints),
      fitConstraints(laplacian, SmoothingEnergy::Biharmonic, constraints, 1e4));
  };
  const auto [exact, fit] = solutions(someConstraints);
  const auto [exactMoved, fitMoved] = solutions(moved);
  EXPECT_LT((exactMoved.array() - 1e3 * exact.array() - 7.0).abs().maxCoeff(), 1e-6);
  EXPECT_LT((fitMoved.array() - 1e3 * fit.array() - 7.0).abs().maxCoeff(), 1e-4);
  const auto [constant, constantFit] = solutions({ { 7, 0.1 }, { 8, 0.1 } });
  EXPECT_EQ(constant, Values::Constant(constant.size(), 0.1));
  EXPECT_EQ(constantFit, constant);
}

// What is contradictory or not determined is refused, and the place named.
TEST(ConstrainedFunctionInput, isChecked)
{
  Mesh mesh = torusMesh(10, false);
  mesh.vertices.conservativeResize(3, 53);
  mesh.vertices.rightCols(3) = 5.0 * Eigen::Matrix3d::Identity();
  mesh.triangles.conservativeResize(3, mesh.triangles.cols() + 1);
  mesh.triangles.rightCols(1) << 50, 51, 52;
  const auto laplacian = laplacianOf(mesh, LaplacianWeights::Cotangent);
  const VertexName name = [](Index vertex) -> std::size_t { return vertex + 1000; };
  const auto expectRefusal =
    [&](const std::vector<ValueConstraint>& constraints, const std::string& part)
  {
    for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
    {
      const auto check = [&](const auto& solve)
      {
        try
        {
          solve();
          ADD_FAILURE() << part;
        }
        catch (const InvalidInput& error)
        {
          EXPECT_THAT(error.what(), HasSubstr(part));
        }
      };
      check([&]() { interpolateConstraints(*laplacian, energy, constraints, {}, name); });
      check([&]() { fitConstraints(laplacian, energy, constraints, 1e5, {}, name); });
    }
  };
  expectRefusal({}, "none");
  expectRefusal({ { 3, 1.0 } }, "that of point 1050 (3 points)");
  expectRefusal({ { 3, 1.0 }, { 50, 0.0 }, { 3, 2.0 } }, "1 and 2 at point 1003");
  expectRefusal({ { 99, 1.0 } }, "found 99");
}

TEST(ConstrainedFunctionInput, canBeAborted)
{
  const auto laplacian = laplacianOf(torusMesh(60, true), LaplacianWeights::Cotangent);
  for (const double last : { 0.0, 0.5, 0.9 })
  {
    const Execution execution = { 0, [last](double fraction) { return fraction < last; } };
    EXPECT_THROW(
      interpolateConstraints(*laplacian, SmoothingEnergy::Biharmonic, someConstraints, execution),
      Aborted);
    EXPECT_THROW(
      fitConstraints(laplacian, SmoothingEnergy::Biharmonic, someConstraints, 1e5, execution),
      Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars
