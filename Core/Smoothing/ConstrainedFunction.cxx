#include "ConstrainedFunction.h"

#include "ComponentMeans.h"
#include "ConstrainedVertices.h"
#include "KrylovSolver.h"
#include "RowScaling.h"
#include "SparseCholesky.h"

#include <memory>
#include <utility>

namespace SurfaceScalars
{
namespace
{

using Matrix = Eigen::SparseMatrix<double>;

constexpr double Goal = 1e-11; // of the estimated error, relative to the solution

/// The columns of the unknowns.
Matrix columnsOf(const Matrix& matrix, const std::vector<int>& unknowns)
{
  Matrix result(matrix.rows(), static_cast<Eigen::Index>(unknowns.size()));
  result.reserve(matrix.nonZeros());
  for (Eigen::Index column = 0; column < result.cols(); ++column)
  {
    result.startVec(column);
    for (Matrix::InnerIterator entry(matrix, unknowns[static_cast<std::size_t>(column)]); entry;
         ++entry)
    {
      result.insertBack(entry.row(), column) = entry.value();
    }
  }
  result.finalize();
  return result;
}

/// With S = (B C), B the columns of the unknowns: B^T A^-1 B x = -B^T A^-1 C given.
Values leastBiharmonic(const Laplacian& laplacian, const std::vector<int>& unknowns,
  const Values& given, const Execution& execution)
{
  const Matrix columns = columnsOf(laplacian.stiffness, unknowns);
  const Matrix scaled = scaleRows(columns, laplacian.mass.cwiseInverse());
  const SparseCholesky cholesky(
    std::make_shared<Matrix>(columns.transpose() * scaled), execution.part(0.0, 0.8));
  const auto image = [&](const Values& vector, const Execution&) -> Values
  { return scaled.transpose() * (columns * vector); };
  const auto inverse = [&](const Values& residual, const Execution& polling)
  {
    polling.report(0.0);
    return cholesky.solve(residual);
  };
  const Values right = -(scaled.transpose() * (laplacian.stiffness * given));
  return PreconditionedSystem{ image, inverse }.solve(right, Goal, execution.part(0.8, 1.0));
}

} // namespace

Values interpolateConstraints(const Laplacian& laplacian, SmoothingEnergy energy,
  const std::vector<ValueConstraint>& constraints, const Execution& execution,
  const VertexName& nameOf)
{
  if (energy == SmoothingEnergy::Harmonic)
  {
    return harmonicFunction(laplacian, constraints, execution, nameOf);
  }
  const ConstrainedVertices constrained(laplacian, constraints, nameOf);
  return constrained.extend([&](const Values& given)
    { return leastBiharmonic(laplacian, constrained.vertices, given, execution); });
}

Values fitConstraints(std::shared_ptr<const Laplacian> laplacian, SmoothingEnergy energy,
  const std::vector<ValueConstraint>& constraints, double epsilon, const Execution& execution,
  const VertexName& nameOf)
{
  const ConstrainedVertices constrained(*laplacian, constraints, nameOf);
  Values isFixed = Values::Ones(laplacian->mass.size());
  isFixed(constrained.vertices).setZero();
  Values values = ComponentMeans(*laplacian, isFixed).of(constrained.given);
  values += isFixed.cwiseProduct(constrained.given - values);
  const Values metric = laplacian->mass.mean() * isFixed;
  const TikhonovSmoother smoother(
    std::move(laplacian), Eigen::SparseMatrix<double>(metric.asDiagonal()), energy);
  return smoother.smooth(values, epsilon, execution);
}

} // namespace SurfaceScalars
