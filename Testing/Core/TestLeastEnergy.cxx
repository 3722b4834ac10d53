#include "ConstrainedFunction.h"
#include "DesignMesh.h"
#include "Error.h"
#include "LeastEnergy.h"
#include "MeshExamples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using testing::HasSubstr;
using Truth::Mesh;
using Truth::torusMesh;

const std::vector<ValueConstraint> someConstraints = { { 3, -1.0 }, { 100, 2.0 }, { 101, 2.5 },
  { 102, 2.4 }, { 250, 0.5 }, { 333, 1.0 } };

Eigen::MatrixXd dense(const Eigen::SparseMatrix<double>& matrix)
{
  return matrix;
}

/// A mesh with its matrices, dense.
struct Problem
{
  Mesh mesh = torusMesh(28, true);
  DesignMesh design = DesignMesh(mesh.vertices, mesh.triangles);
  Laplacian laplacian = meshLaplacian(mesh.vertices, mesh.triangles, LaplacianWeights::Cotangent);

  /// x^T matrix x is the energy; biharmonic with the mass matrix of the metric.
  Eigen::MatrixXd energy(SmoothingEnergy energy, DataMetric metric) const
  {
    const Eigen::MatrixXd stiffness = dense(this->laplacian.stiffness);
    if (energy == SmoothingEnergy::Harmonic)
    {
      return stiffness;
    }
    const Eigen::MatrixXd mass = metric == DataMetric::MassMatrix
      ? dense(this->design.metric(metric, {}))
      : Eigen::MatrixXd(this->laplacian.mass.asDiagonal());
    return stiffness * mass.ldlt().solve(stiffness);
  }
};

class LeastEnergyNorms : public testing::TestWithParam<std::tuple<SmoothingEnergy, DataMetric>>
{
protected:
  SmoothingEnergy energy = std::get<0>(GetParam());
  DataMetric metric = std::get<1>(GetParam());
};
INSTANTIATE_TEST_SUITE_P(All, LeastEnergyNorms,
  testing::Combine(testing::Values(SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic),
    testing::Values(DataMetric::Identity, DataMetric::MassMatrix, DataMetric::LumpedMass)));

// (2): the values are met exactly, and the derivative of the energy is 0 at all other vertices.
TEST_P(LeastEnergyNorms, interpolate)
{
  const Problem problem;
  GreensFunctions& functions = problem.design.greensFunctions(this->energy, this->metric, {});
  const Values x =
    leastEnergyThrough(functions, energyConstraints(functions, someConstraints, {}, {}), {});
  const Eigen::MatrixXd matrix = problem.energy(this->energy, this->metric);
  Values derivative = matrix * x;
  for (const auto& [vertex, value] : someConstraints)
  {
    EXPECT_EQ(x[vertex], value);
    derivative[vertex] = 0.0;
  }
  EXPECT_LT(derivative.lpNorm<Eigen::Infinity>(), 1e-9 * matrix.diagonal().maxCoeff());
}

// (3): the derivative of energy(x) + t (x - g)^T W (x - g) is 0, by elimination of the dense
// matrix.
TEST_P(LeastEnergyNorms, approximate)
{
  const Problem problem;
  GreensFunctions& functions = problem.design.greensFunctions(this->energy, this->metric, {});
  const EnergyConstraints constraints = energyConstraints(functions, someConstraints, {}, {});
  const Eigen::SparseMatrix<double> whole = problem.design.metric(this->metric, {});
  const LeastEnergyNear near(functions, constraints, whole);
  const Eigen::MatrixXd matrix = problem.energy(this->energy, this->metric);

  const Eigen::Index size = matrix.rows();
  Values given = Values::Zero(size);
  Values isGiven = Values::Zero(size);
  for (const auto& [vertex, value] : someConstraints)
  {
    given[vertex] = value;
    isGiven[vertex] = 1.0;
  }
  const Eigen::MatrixXd weights = isGiven.asDiagonal() * dense(whole) * isGiven.asDiagonal();
  for (const double relative : { 1e-3, 1.0, 1e3 })
  {
    const double weight = relative * matrix.diagonal().mean() / weights.diagonal().maxCoeff();
    const Values x = near.solve(weight);
    const Values expected =
      (matrix + weight * weights).fullPivLu().solve(weight * (weights * given));
    EXPECT_LT((x - expected).lpNorm<Eigen::Infinity>(), 1e-7);

    // The curve has the norms of these solutions.
    const ParameterCurve curve = near.curve(weight);
    const Values logarithms = curve.epsilons.array().log().abs();
    Eigen::Index at = 0;
    logarithms.minCoeff(&at);
    const Values y = near.solve(weight * curve.epsilons[at]);
    EXPECT_NEAR(curve.residuals[at], std::sqrt((y - given).dot(weights * (y - given))),
      1e-6 * curve.residuals[at]);
    EXPECT_NEAR(curve.seminorms[at], std::sqrt(y.dot(matrix * y)), 1e-5 * curve.seminorms[at]);
  }
}

// The same as by factoring the assembled matrix of the unknowns.
TEST(LeastEnergy, agreesWithConstrainedFunctions)
{
  const Problem problem;
  const auto laplacian = std::make_shared<Laplacian>(problem.laplacian);
  for (const auto energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    GreensFunctions& functions = problem.design.greensFunctions(energy, DataMetric::Identity, {});
    const EnergyConstraints constraints = energyConstraints(functions, someConstraints, {}, {});
    EXPECT_LT((leastEnergyThrough(functions, constraints, {}) -
                interpolateConstraints(*laplacian, energy, someConstraints))
                .lpNorm<Eigen::Infinity>(),
      1e-8);
    constexpr double epsilon = 1e6;
    const double area = laplacian->mass.sum();
    const double unit = energy == SmoothingEnergy::Harmonic ? 1.0 / area : 1.0 / (area * area);
    const LeastEnergyNear near(
      functions, constraints, problem.design.metric(DataMetric::Identity, {}));
    EXPECT_LT(
      (near.solve(epsilon * unit) - fitConstraints(laplacian, energy, someConstraints, epsilon))
        .lpNorm<Eigen::Infinity>(),
      1e-6);
  }
}

// What is kept of vertices asked for before does not change what others get.
TEST(LeastEnergy, remembersOnlyWhatIsTrue)
{
  const Problem problem;
  const auto through = [&](const std::vector<ValueConstraint>& constraints)
  {
    GreensFunctions& functions =
      problem.design.greensFunctions(SmoothingEnergy::Biharmonic, DataMetric::LumpedMass, {});
    return leastEnergyThrough(functions, energyConstraints(functions, constraints, {}, {}), {});
  };
  const Values first = through(someConstraints);
  std::vector<ValueConstraint> moved = someConstraints;
  moved[2].vertex = 77;
  const Values second = through(moved);
  const Problem fresh;
  GreensFunctions& functions =
    fresh.design.greensFunctions(SmoothingEnergy::Biharmonic, DataMetric::LumpedMass, {});
  EXPECT_LT(
    (second - leastEnergyThrough(functions, energyConstraints(functions, moved, {}, {}), {}))
      .lpNorm<Eigen::Infinity>(),
    1e-9);
  EXPECT_LT((through(someConstraints) - first).lpNorm<Eigen::Infinity>(), 1e-9);
}

// Constants on each component: values there are not known elsewhere.
TEST(LeastEnergy, treatsComponentsAlone)
{
  const Truth::TriangleMesh two =
    besideEachOther(Truth::subdividedSphere(2), Truth::subdividedSphere(3));
  const DesignMesh mesh(two.points, trianglesOf(two));
  GreensFunctions& functions =
    mesh.greensFunctions(SmoothingEnergy::Biharmonic, DataMetric::LumpedMass, {});
  const auto through = [&](const std::vector<ValueConstraint>& constraints)
  { return leastEnergyThrough(functions, energyConstraints(functions, constraints, {}, {}), {}); };
  const Index first = mesh.vertices().cols() - 1;
  const Values x = through({ { 0, 5.0 }, { first, 1.0 }, { first - 9, 2.0 } });
  EXPECT_LT((x.head(66).array() - 5.0).abs().maxCoeff(), 1e-9);
  EXPECT_NEAR(x[first], 1.0, 1e-15);
  try
  {
    through({ { first, 1.0 } });
    FAIL() << "a component without a value was taken";
  }
  catch (const InvalidInput& error)
  {
    EXPECT_THAT(error.what(), HasSubstr("component"));
  }
}

} // namespace
} // namespace SurfaceScalars
