#pragma once

#include "Basics.h"
#include "Execution.h"
#include "RoundedFactor.h"

#include <Eigen/SparseCore>

#include <memory>

namespace SurfaceScalars
{

/**
 * The factors of a symmetric positive definite sparse matrix, as of a Laplacian and a multiple of
 * its mass: by CHOLMOD where the build has it, by Eigen otherwise.
 *
 * For the links of points to 16 neighbors, factoring takes time O(n^1.5) and memory O(n log n):
 * about 1.4 kB per point for 100,000. A solution takes 25 to 40 ms then, as the BLAS beneath is.
 */
class SparseCholesky
{
public:
  /// @param matrix its lower triangle is read
  /// @throws InvalidInput if the matrix is too large; Error if it is not positive definite;
  /// Aborted, within a second: the factorization then goes on to its end, unheard
  SparseCholesky(
    const std::shared_ptr<const Eigen::SparseMatrix<double>>& matrix, const Execution& execution);

  SparseCholesky(const SparseCholesky&) = delete; // refactor() would change copies as well
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Other entries at the same places: in what order to eliminate is known already. After an
  /// exception there are no factors. @throws as the constructor
  void refactor(
    const std::shared_ptr<const Eigen::SparseMatrix<double>>& matrix, const Execution& execution);

  Values solve(const ValuesRef& rightSide) const;
  Eigen::MatrixXd solveColumns(const Eigen::MatrixXd& rightSides) const;
  RoundedFactor rounded() const;

private:
  struct Factors;
  std::shared_ptr<Factors> factors_;
};

} // namespace SurfaceScalars
