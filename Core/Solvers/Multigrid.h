#pragma once

#include "Aggregation.h"
#include "Basics.h"
#include "Execution.h"
#include "GaussSeidel.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>

#include <deque>

namespace SurfaceScalars
{

/// matrix * vector @throws Aborted
Values multiply(const RowMatrix& matrix, const Values& vector, const Execution& execution);

/**
 * Approximates the inverse of the matrix of an elliptic operator, such as a Laplacian with some
 * values held fixed, by one V-cycle of smoothed aggregation (Vanek, Mandel and Brezina, 1996).
 *
 * Each level's rows are gathered in aggregates of a row and those strongly coupled to it, the rows
 * of the next level; constants on the aggregates, smoothed by a step of Jacobi's method, are the
 * functions that the next level stands for. A sweep of Gauss and Seidel's method through the rows
 * before the next level's correction and one back after it do the rest, and all for rows that their
 * diagonal dominates; so a symmetric matrix has a symmetric, positive definite approximation. The
 * last level is factored, so that for a small matrix the inverse is exact.
 *
 * Time and memory O(entries): about as much again as the matrix takes.
 */
class Multigrid
{
public:
  /// @param matrix positive diagonal, mostly negative entries beside it
  /// @throws Error if the last level is singular; Aborted
  Multigrid(const RowMatrix& matrix, bool isSymmetric, const Execution& execution);

  bool isExact() const { return this->levels_.empty(); } ///< the inverse, for a small matrix

  /// right - matrix * solution, entries rounded to single precision; unless isExact()
  Values residual(const Values& right, const Values& solution, const Execution& execution) const
  {
    return this->levels_.front().sweeps.residual(right, solution, execution);
  }

  Values apply(const Values& residual, const Execution& execution) const;

private:
  struct Level
  {
    GaussSeidel sweeps;
    RowMatrix prolongation; ///< from the next level's functions to this one's
    RowMatrix restriction;  ///< its transpose
  };

  void factorLast(const RowMatrix& matrix, Eigen::Index rows);
  Values solveLast(const Values& residual) const;
  Values cycle(std::size_t level, const Values& residual, const Execution& execution) const;

  std::deque<Level> levels_; ///< but the last; Eigen's matrices are copied where a vector moves
  bool isSymmetric_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky_; ///< of the last level: this
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;             ///< or this if not symmetric
};

} // namespace SurfaceScalars
