#include "GaussSeidel.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index BlockSize = 8192; // rows
constexpr Eigen::Index PairSize = 2 * BlockSize;
constexpr double Damping = 1.5; // of entries between blocks

Eigen::Index blockOf(Eigen::Index row)
{
  return row / BlockSize;
}

/// Calls body(pair, first, last) for the rows of each pair of blocks.
template <class Body>
void forEachPairOfBlocks(Eigen::Index rows, const Execution& execution, const Body& body)
{
  parallelFor(static_cast<std::size_t>(rows), PairSize, execution,
    [&](std::size_t begin, std::size_t end)
    { body(begin / PairSize, static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end)); });
}

/// Calls body(row), in the two blocks by turns: each row waits for the one before, and a processor
/// can as well wait for two.
template <class Body>
void goForward(Eigen::Index first, Eigen::Index last, const Body& body)
{
  const Eigen::Index middle = std::min(first + BlockSize, last);
  for (Eigen::Index row = first; row < middle; ++row)
  {
    body(row);
    if (row + BlockSize < last)
    {
      body(row + BlockSize);
    }
  }
}

/// The same from the last rows on.
template <class Body>
void goBack(Eigen::Index first, Eigen::Index last, const Body& body)
{
  const Eigen::Index middle = std::min(first + BlockSize, last);
  for (Eigen::Index row = middle - 1; row >= first; --row)
  {
    if (row + BlockSize < last)
    {
      body(row + BlockSize);
    }
    body(row);
  }
}

} // namespace

GaussSeidel::GaussSeidel(const RowMatrix& matrix)
  : unit_(matrix.diagonal().maxCoeff())
  , starts_{ 0 }
  , diagonal_(matrix.diagonal())
  , inversePivots_(matrix.rows())
{
  const RowMatrix transposed = matrix.transpose();
  this->pairs_.reserve(static_cast<std::size_t>(matrix.nonZeros() - matrix.rows()) / 2);
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
  {
    if (row % PairSize == 0)
    {
      this->outsideStarts_.push_back(static_cast<int>(this->outside_.size()));
    }
    this->append(matrix, transposed, row);
    this->starts_.push_back(static_cast<int>(this->pairs_.size()));
    const double outside = this->appendOutside(matrix, row);
    // Sweeps converge if twice the pivots exceed the diagonal and what is outside.
    this->inversePivots_[row] = this->unit_ /
      std::max(this->diagonal_[row], 0.5 * (this->diagonal_[row] + Damping * outside));
  }
  this->outsideStarts_.push_back(static_cast<int>(this->outside_.size()));
}

/// What that takes from the row goes to its diagonal.
float GaussSeidel::round(double value, Eigen::Index row)
{
  const auto result = static_cast<float>(value / this->unit_);
  this->diagonal_[row] += value - this->unit_ * static_cast<double>(result);
  return result;
}

/// The pairs of a row, where either entry is one of the matrix.
void GaussSeidel::append(const RowMatrix& matrix, const RowMatrix& transposed, Eigen::Index row)
{
  RowMatrix::InnerIterator lower(matrix, row);
  RowMatrix::InnerIterator upper(transposed, row);
  while (true)
  {
    const Eigen::Index a = lower ? lower.col() : row;
    const Eigen::Index b = upper ? upper.col() : row;
    const Eigen::Index column = std::min(a, b);
    if (column >= row)
    {
      return;
    }
    if (blockOf(column) == blockOf(row))
    {
      this->pairs_.push_back(
        { static_cast<int>(column), a == column ? this->round(lower.value(), row) : 0.0F,
          b == column ? this->round(upper.value(), column) : 0.0F });
    }
    if (a == column)
    {
      ++lower;
    }
    if (b == column)
    {
      ++upper;
    }
  }
}

/// @returns the sum of their magnitudes
double GaussSeidel::appendOutside(const RowMatrix& matrix, Eigen::Index row)
{
  double sum = 0.0;
  for (RowMatrix::InnerIterator entry(matrix, row); entry; ++entry)
  {
    if (blockOf(entry.col()) != blockOf(row))
    {
      this->outside_.push_back(
        { static_cast<int>(row), static_cast<int>(entry.col()), this->round(entry.value(), row) });
      sum += std::abs(entry.value());
    }
  }
  return sum;
}

void GaussSeidel::subtractOutside(
  std::size_t pairOfBlocks, const Values& solution, Values& right) const
{
  const int end = this->outsideStarts_[pairOfBlocks + 1];
  for (int i = this->outsideStarts_[pairOfBlocks]; i < end; ++i)
  {
    const OutsideEntry& entry = this->outside_[i];
    right[entry.row] -= this->unit_ * static_cast<double>(entry.value) * solution[entry.column];
  }
}

GaussSeidel::Sweep GaussSeidel::forward(const Values& right, const Execution& execution) const
{
  Sweep result{ Values(right.size()), Values(right.size()) };
  double* const solution = result.solution.data();
  double* const residual = result.residual.data();
  const auto relax = [&, inverseUnit = 1.0 / this->unit_](Eigen::Index row)
  {
    double sum = 0.0;
    for (const Pair& pair : this->pairsOf(row))
    {
      sum += static_cast<double>(pair.lower) * solution[pair.column];
    }
    const double value = (inverseUnit * right[row] - sum) * this->inversePivots_[row];
    solution[row] = value;
    residual[row] = right[row] - this->unit_ * sum - this->diagonal_[row] * value;
    const double share = this->unit_ * value;
    for (const Pair& pair : this->pairsOf(row))
    {
      residual[pair.column] -= static_cast<double>(pair.upper) * share;
    }
  };
  forEachPairOfBlocks(right.size(), execution,
    [&](std::size_t, Eigen::Index first, Eigen::Index last) { goForward(first, last, relax); });
  forEachPairOfBlocks(right.size(), execution,
    [&](std::size_t pair, Eigen::Index, Eigen::Index)
    { this->subtractOutside(pair, result.solution, result.residual); });
  return result;
}

void GaussSeidel::back(const Values& right, Sweep& sweep, const Execution& execution) const
{
  double* const solution = sweep.solution.data();
  double* const rest = sweep.residual.data(); // without what other blocks and later rows contribute
  forEachPairOfBlocks(right.size(), execution,
    [&](std::size_t pair, Eigen::Index first, Eigen::Index last)
    {
      std::copy(right.data() + first, right.data() + last, rest + first);
      this->subtractOutside(pair, sweep.solution, sweep.residual);
      for (Eigen::Index row = first; row < last; ++row)
      {
        rest[row] /= this->unit_;
      }
    });
  const auto relax = [&, inverseUnit = 1.0 / this->unit_](Eigen::Index row)
  {
    double sum = inverseUnit * this->diagonal_[row] * solution[row];
    for (const Pair& pair : this->pairsOf(row))
    {
      sum += static_cast<double>(pair.lower) * solution[pair.column];
    }
    const double value = solution[row] + (rest[row] - sum) * this->inversePivots_[row];
    solution[row] = value;
    for (const Pair& pair : this->pairsOf(row))
    {
      rest[pair.column] -= static_cast<double>(pair.upper) * value;
    }
  };
  forEachPairOfBlocks(right.size(), execution,
    [&](std::size_t, Eigen::Index first, Eigen::Index last) { goBack(first, last, relax); });
}

Values GaussSeidel::residual(
  const Values& right, const Values& solution, const Execution& execution) const
{
  Values result = right;
  forEachPairOfBlocks(right.size(), execution,
    [&](std::size_t pairOfBlocks, Eigen::Index first, Eigen::Index last)
    {
      this->subtractOutside(pairOfBlocks, solution, result);
      for (Eigen::Index row = first; row < last; ++row)
      {
        const double share = this->unit_ * solution[row];
        double sum = 0.0;
        for (const Pair& pair : this->pairsOf(row))
        {
          sum += static_cast<double>(pair.lower) * solution[pair.column];
          result[pair.column] -= static_cast<double>(pair.upper) * share;
        }
        result[row] -= this->diagonal_[row] * solution[row] + this->unit_ * sum;
      }
    });
  return result;
}

} // namespace SurfaceScalars
