#pragma once

#include "Basics.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/**
 * A Cholesky factor L of a sparse matrix whose entries are rounded to single precision. (L L^T)^-1
 * is symmetric and positive definite whatever the rounding: a preconditioner of half the memory,
 * applied in a third of the time that the factor takes.
 *
 * Columns with the same rows lie together in dense blocks.
 */
class RoundedFactor
{
public:
  /// @param order at each place of the eliminated matrix the row of the original one
  /// @param scale entries are divided by this: about the largest
  /// @param entries of all columns together
  RoundedFactor(std::vector<int> order, double scale, std::size_t entries);

  /// The next columns.
  /// @param rows ascending; first those of the columns
  /// @param values one column after the other, rows.size() each; what is above the diagonal is not
  /// read
  void append(int columns, const std::vector<int>& rows, const double* values);

  Values solve(const ValuesRef& rightSide) const;

private:
  struct Block
  {
    int first; ///< column
    int columns;
    int below; ///< rows below those of the columns
    std::size_t rows;
    std::size_t values;
  };

  void forward(const Block& block, Values& vector, Values& work) const;
  void backward(const Block& block, Values& vector, Values& work) const;

  std::vector<int> order_;
  double scale_;
  std::vector<Block> blocks_;
  std::vector<int> rows_; ///< below the blocks' columns
  std::vector<float> values_;
};

} // namespace SurfaceScalars
