#pragma once

#include "Multigrid.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/**
 * Linear systems with one matrix: that of an elliptic operator, such as stiffness with some values
 * held fixed, or a mass + t stiffness.
 *
 * Symmetric matrices of up to 10,000 rows are factored. For larger ones the method of conjugate
 * gradients, or if the matrix is not symmetric the stabilized biconjugate gradients of van der
 * Vorst (1992), is preconditioned by Multigrid. That also tells how large the error still is.
 *
 * A million rows with 19 entries each: made in 1.8 s and solved in 3.3 s on one thread; some 230
 * bytes per row beside the matrix.
 */
class SURFACESCALARSCORE_EXPORT EllipticSolver
{
public:
  /// @param matrix positive definite; all entries are stored, even if it is symmetric
  /// @throws Error if the matrix is singular; Aborted
  EllipticSolver(RowMatrix&& matrix, bool isSymmetric, const Execution& execution = {});

  /// @returns x with matrix * x = right, to 1e-9 of its largest component, or as far as rounding
  /// errors allow where the matrix is nearly singular @throws Error if that is not to 1e-6; Aborted
  Values solve(const ValuesRef& right, const Execution& execution = {}) const;

private:
  RowMatrix matrix_;
  Multigrid preconditioner_;
  bool isSymmetric_;
};

} // namespace SurfaceScalars
