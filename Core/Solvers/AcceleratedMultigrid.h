#pragma once

#include "Multigrid.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Approximates the inverse of a symmetric matrix up to a given relative error: V-cycles, combined
 * by the polynomial of Chebyshev for the range of the eigenvalues of cycle times matrix, whose
 * greatest is 1 and whose least is estimated. Linear, symmetric and positive definite. Rows may be
 * in any order.
 */
class AcceleratedMultigrid
{
public:
  /// @param matrix as of Multigrid, symmetric
  /// @param error below 1, in the norm of the matrix
  /// @throws Error if it is singular; Aborted
  AcceleratedMultigrid(const RowMatrix& matrix, double error, const Execution& execution);

  int cycleCount() const { return this->cycleCount_; } ///< about 5 if triangles are fair
  Values apply(const Values& right, const Execution& execution) const;

private:
  double estimateLeast(Eigen::Index rows, const Execution& execution) const;
  Values applyInOrder(const Values& right, const Execution& execution) const;

  std::vector<int> order_; ///< of rows in multigrid_; empty if as they are given
  Multigrid multigrid_;
  double least_; ///< eigenvalue
  int cycleCount_;
};

} // namespace SurfaceScalars
