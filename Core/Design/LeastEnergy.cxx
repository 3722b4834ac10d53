#include "LeastEnergy.h"

#include "Background.h"
#include "ConstrainedVertices.h"
#include "Error.h"
#include "NumberText.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double Goal = 1e-12;        // of the error at the constraints, of their range
constexpr double LargestError = 1e-7; // the same
constexpr int MostCorrections = 5;

/// The sum, with the constants with which it misses the values by 0 in the mean.
/// @param weights of the constraints (rows) in the mean of a component (column)
Values withConstants(const GreensFunctions& functions, const EnergyConstraints& constraints,
  const Values& lambda, const Eigen::MatrixXd& weights)
{
  Values result = functions.sum(constraints.vertices, lambda);
  const Values missed = constraints.values - result(constraints.vertices);
  const Values totals = weights.colwise().sum();
  const Values means = (weights.transpose() * missed).cwiseQuotient(totals);
  const std::vector<int>& components = functions.poisson().components();
  for (Eigen::Index i = 0; i < result.size(); ++i)
  {
    result[i] += means[components[static_cast<std::size_t>(i)]];
  }
  return result;
}

/// Rows and columns of these.
Eigen::MatrixXd block(const Eigen::SparseMatrix<double>& matrix, const std::vector<Index>& vertices)
{
  const auto count = static_cast<Eigen::Index>(vertices.size());
  return Eigen::MatrixXd::NullaryExpr(count, count,
    [&](Eigen::Index row, Eigen::Index column)
    {
      return matrix.coeff(
        vertices[static_cast<std::size_t>(row)], vertices[static_cast<std::size_t>(column)]);
    });
}

} // namespace

EnergyConstraints energyConstraints(GreensFunctions& functions,
  const std::vector<ValueConstraint>& constraints, const Execution& execution,
  const VertexName& nameOf)
{
  const PoissonSolver& poisson = functions.poisson();
  const ConstrainedVertices all(poisson.laplacian(), constraints, nameOf);
  EnergyConstraints result;
  std::set<Index> distinct;
  for (const ValueConstraint& constraint : constraints)
  {
    distinct.insert(constraint.vertex);
  }
  result.vertices.assign(distinct.begin(), distinct.end());

  result.given = all.given(result.vertices);
  result.lowest = result.given.minCoeff();
  result.range = result.given.maxCoeff() - result.lowest;
  result.range = result.range > 0.0 ? result.range : 1.0;
  result.values = (result.given.array() - result.lowest) / result.range;
  result.energies = functions.among(result.vertices, execution);
  const auto& components = poisson.components();
  result.constants.setZero(
    result.given.size(), 1 + *std::max_element(components.begin(), components.end()));
  for (std::size_t i = 0; i < result.vertices.size(); ++i)
  {
    result.constants(static_cast<Eigen::Index>(i), components[result.vertices[i]]) = 1.0;
  }
  return result;
}

Values leastEnergyThrough(const GreensFunctions& functions, const EnergyConstraints& constraints,
  const Execution& execution)
{
  const auto [basis, energies] = inBackground(execution.part(0.0, 0.2),
    [all = constraints.energies, constants = constraints.constants]()
    {
      const Eigen::MatrixXd free = orthogonalComplement(constants);
      return std::make_pair(free, Eigen::LLT<Eigen::MatrixXd>(free.transpose() * all * free));
    });
  Values lambda = Values::Zero(constraints.values.size());
  Values missed = constraints.values;
  Values result;
  double error = 1.0;
  for (int i = 0; i < MostCorrections && error > Goal; ++i)
  {
    execution.report(0.2 + 0.8 * i / MostCorrections);
    lambda += basis * energies.solve(basis.transpose() * missed);
    result = withConstants(functions, constraints, lambda, constraints.constants);
    missed = result(constraints.vertices);
    missed = constraints.values - missed;
    error = missed.lpNorm<Eigen::Infinity>();
  }
  if (energies.info() != Eigen::Success || !(error <= LargestError))
  {
    throw Error("expected a function through the " + std::to_string(missed.size()) +
      " given values, found one that misses them by " + textOf(error) +
      " of their range. Choose fewer points, or points farther apart.");
  }
  result = (result * constraints.range).array() + constraints.lowest;
  result(constraints.vertices) = constraints.given;
  return result;
}

LeastEnergyNear::LeastEnergyNear(const GreensFunctions& functions,
  const EnergyConstraints& constraints, const Eigen::SparseMatrix<double>& metric,
  const Execution& execution)
  : functions_(functions)
  , constraints_(constraints)
  , metric_(block(metric, constraints.vertices))
  , system_(ridgeSystem(
      constraints.energies, constraints.constants, this->metric_, constraints.values, execution))
{
}

ParameterCurve LeastEnergyNear::curve(double unit) const
{
  ParameterCurve result = this->system_.curve(unit);
  result.residuals *= this->constraints_.range;
  result.seminorms *= this->constraints_.range;
  result.gcv *= this->constraints_.range * this->constraints_.range;
  return result;
}

/// The constants follow from t W (values - x) = lambda, whose sum over each component is 0.
Values LeastEnergyNear::solve(double weight) const
{
  const EnergyConstraints& constraints = this->constraints_;
  const Values result = withConstants(this->functions_, constraints,
    this->system_.multipliers(weight), this->metric_ * constraints.constants);
  return (result * constraints.range).array() + constraints.lowest;
}

} // namespace SurfaceScalars
