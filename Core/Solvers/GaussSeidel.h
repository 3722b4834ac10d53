#pragma once

#include "Aggregation.h"
#include "Basics.h"
#include "Execution.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Sweeps of Gauss and Seidel's method through the rows of a matrix. They run in blocks of rows, as
 * if the other blocks did not change meanwhile, whatever the number of threads; where many entries
 * lead from one block to another, rows are corrected by less, so that sweeps converge.
 *
 * Entries beside the diagonal are rounded to single precision, and diagonals take what row sums
 * would lose by that. The two entries of each pair of rows lie together: one pass through memory
 * does a sweep forward and finds what it leaves, another the sweep back.
 */
class GaussSeidel
{
public:
  explicit GaussSeidel(const RowMatrix& matrix);

  struct Sweep
  {
    Values solution;
    Values residual; ///< right - matrix * solution
  };

  /// From the first row of each block to the last; from 0 on.
  Sweep forward(const Values& right, const Execution& execution) const;

  /// The other way round, the adjoint of forward() if the matrix is symmetric: improves the
  /// solution. The residual is not read and not found.
  void back(const Values& right, Sweep& sweep, const Execution& execution) const;

  /// right - matrix * solution
  Values residual(const Values& right, const Values& solution, const Execution& execution) const;

private:
  struct Pair
  {
    int column;  ///< before the row
    float lower; ///< entry (row, column), in units
    float upper; ///< entry (column, row), in units
  };
  struct OutsideEntry
  {
    int row;
    int column;
    float value;
  };

  struct Pairs
  {
    const Pair* first;
    const Pair* last;

    const Pair* begin() const { return this->first; }
    const Pair* end() const { return this->last; }
  };

  Pairs pairsOf(Eigen::Index row) const
  {
    const Pair* pairs = this->pairs_.data();
    return { pairs + this->starts_[row], pairs + this->starts_[row + 1] };
  }
  float round(double value, Eigen::Index row);
  void append(const RowMatrix& matrix, const RowMatrix& transposed, Eigen::Index row);
  double appendOutside(const RowMatrix& matrix, Eigen::Index row);
  void subtractOutside(std::size_t pairOfBlocks, const Values& solution, Values& right) const;

  double unit_; ///< of the entries
  std::vector<Pair> pairs_;
  std::vector<int> starts_; ///< of the pairs of each row, and the end
  std::vector<OutsideEntry> outside_;
  std::vector<int> outsideStarts_; ///< of the entries of each pair of blocks, and the end
  Values diagonal_;
  Values inversePivots_; ///< in units: by what a row's residual is multiplied
};

} // namespace SurfaceScalars
