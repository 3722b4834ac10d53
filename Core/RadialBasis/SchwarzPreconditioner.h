#pragma once

#include "Execution.h"
#include "PointCloud.h"
#include "RadialKernel.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <vector>

namespace SurfaceScalars
{

/// Symmetric; both triangles are stored.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/**
 * Approximates the inverse of a positive definite sparse matrix, the rows of which lie along a
 * Morton curve, by the sum of the inverses of overlapping diagonal blocks (additive Schwarz).
 *
 * Each block is a run of rows and as many rows again, those with the largest entries in the run's.
 * The inverse of the matrix of a compactly supported kernel decays so fast that conjugate gradients
 * then need some forty steps, however close some centers are; incomplete factorizations need
 * thousands.
 *
 * Memory: about 6.4 kB per row.
 */
class SchwarzPreconditioner
{
public:
  /// @throws Aborted
  SchwarzPreconditioner(const SparseMatrix& matrix, const Execution& execution);

  /// Whether all blocks are positive definite; if not, nothing else may be called.
  bool isPositiveDefinite() const;

  Values apply(const Values& residual, const Execution& execution) const;

private:
  struct Block
  {
    std::vector<int> rows;
    Eigen::LLT<Eigen::MatrixXd> factor;
  };
  std::vector<Block> blocks_;
};

} // namespace SurfaceScalars
