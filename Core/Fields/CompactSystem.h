#pragma once

#include "LinearTerms.h"
#include "SchwarzPreconditioner.h"

#include <Eigen/Cholesky>

namespace SurfaceScalars
{

/**
 * (10) for a kernel of compact support (Wendland, Wu): sparse, solved by preconditioned conjugate
 * gradients. The kernel matrix itself is positive definite; the polynomial is eliminated by its
 * Schur complement.
 *
 * Memory: 12 bytes for each pair of centers within the support, and the preconditioner.
 */
class CompactSystem
{
public:
  /// @param regularization added to the diagonal
  /// @throws InvalidInput if the matrix is not positive definite at machine precision; Aborted
  CompactSystem(const PointCloud& cloud, const RadialKernel& kernel, double regularization,
    const Execution& execution);

  struct Solution
  {
    Values coefficients;  ///< alpha
    Eigen::Vector4d tail; ///< beta, about tailOrigin()
  };
  /// To 1e-10 of the range of the values at least. @throws InvalidInput if conjugate gradients do
  /// not get there; Aborted
  Solution solve(const Values& values, const Execution& execution) const;

  const Vector3d& tailOrigin() const { return this->terms_.origin(); }

private:
  Values solveKernel(const Values& right, const Execution& execution) const;
  double condition(const Execution& execution) const;
  Values multiply(const Values& vector, const Execution& execution) const;

  RadialKernel kernel_;
  LinearTerms terms_;
  SparseMatrix matrix_;
  SchwarzPreconditioner preconditioner_;
  Eigen::MatrixXd polynomials_;       ///< P
  Eigen::MatrixXd solved_;            ///< K^-1 P
  Eigen::LLT<Eigen::MatrixXd> schur_; ///< P^T K^-1 P
};

/// The mean number of centers within the support around a center, itself counted; estimated from
/// some.
double meanNeighborCount(const PointCloud& cloud, double radius, const Execution& execution);

} // namespace SurfaceScalars
