#include "EllipticSolver.h"

#include "KrylovSolver.h"

namespace SurfaceScalars
{
namespace
{

constexpr double Goal = 1e-11; // of the estimated error, relative to the solution

/// Eigen copies sparse matrices that one means to move.
RowMatrix take(RowMatrix& matrix)
{
  RowMatrix result;
  result.swap(matrix);
  return result;
}

} // namespace

EllipticSolver::EllipticSolver(RowMatrix&& matrix, bool isSymmetric, const Execution& execution)
  : matrix_(take(matrix))
  , preconditioner_(this->matrix_, isSymmetric, execution)
  , isSymmetric_(isSymmetric)
{
}

Values EllipticSolver::solve(const ValuesRef& right, const Execution& execution) const
{
  const auto image = [this](const Values& vector, const Execution& polling)
  { return multiply(this->matrix_, vector, polling); };
  const auto corrected = [this](const Values& residual, const Execution& polling)
  { return this->preconditioner_.apply(residual, polling); };
  return PreconditionedSystem{ image, corrected, this->isSymmetric_ }.solve(right, Goal, execution);
}

} // namespace SurfaceScalars
