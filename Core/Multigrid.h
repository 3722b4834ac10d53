#pragma once

#include "Aggregation.h"
#include "Basics.h"
#include "Execution.h"

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
 * functions that the next level stands for. A step of that method before and one after the next
 * level's correction do the rest, and all for rows that their diagonal dominates. The last level is
 * factored, so that for a small matrix the inverse is exact.
 *
 * Time and memory O(entries): about as much again as the matrix takes.
 */
class Multigrid
{
public:
  /// @param matrix positive diagonal, mostly negative entries beside it
  /// @throws Error if the last level is singular; Aborted
  Multigrid(RowMatrix&& matrix, bool isSymmetric, const Execution& execution);

  const RowMatrix& matrix() const { return this->levels_.front().matrix; }
  Values apply(const Values& residual, const Execution& execution) const;

private:
  struct Level
  {
    RowMatrix matrix;
    Values relaxation;      ///< of Jacobi's method: by how much of its residual a row is corrected
    RowMatrix prolongation; ///< from the next level's functions to this one's
    RowMatrix restriction;  ///< its transpose
  };

  static void linkToNext(Level& level, const Execution& execution);
  static RowMatrix matrixOfNext(const Level& level, const Execution& execution);
  void factorLast();
  Values solveLast(const Values& residual) const;
  Values cycle(std::size_t level, const Values& residual, const Execution& execution) const;

  std::deque<Level> levels_; ///< Eigen's matrices are copied where a vector would move them
  bool isSymmetric_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky_; ///< of the last level: this
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;             ///< or this if not symmetric
};

} // namespace SurfaceScalars
