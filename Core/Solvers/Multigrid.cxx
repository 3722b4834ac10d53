#include "Multigrid.h"

#include "Aggregation.h"
#include "Error.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t ProductGrain = 32768;     // rows of a product with a vector
constexpr std::size_t RowGrain = 2048;          // rows of a product of matrices
constexpr Eigen::Index MostFactored = 10000;    // rows of the last level: some tenths of a second
constexpr Eigen::Index MostFactoredByLU = 1000; // which takes many times as long
constexpr double SmoothingWeight = 4.0 / 3.0;   // of Jacobi's method, over the largest eigenvalue

/// Rows that are made in blocks on several threads.
RowMatrix stack(Eigen::Index rows, Eigen::Index columns, const Execution& execution,
  const std::function<RowMatrix(Eigen::Index begin, Eigen::Index count)>& blockAt)
{
  const auto count = static_cast<std::size_t>(rows);
  std::vector<RowMatrix> blocks((count + RowGrain - 1) / RowGrain);
  parallelFor(count, RowGrain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      blocks[begin / RowGrain] =
        blockAt(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
    });
  Eigen::Index entries = 0;
  for (const RowMatrix& block : blocks)
  {
    entries += block.nonZeros();
  }
  RowMatrix result(rows, columns);
  result.reserve(entries);
  for (std::size_t b = 0, row = 0; b < blocks.size(); ++b)
  {
    RowMatrix block;
    block.swap(blocks[b]); // to be freed
    for (Eigen::Index i = 0; i < block.rows(); ++i, ++row)
    {
      result.startVec(static_cast<Eigen::Index>(row));
      for (RowMatrix::InnerIterator entry(block, i); entry; ++entry)
      {
        result.insertBack(static_cast<Eigen::Index>(row), entry.col()) = entry.value();
      }
    }
  }
  result.finalize();
  return result;
}

/// The constants on the aggregates.
RowMatrix indicators(const Aggregates& aggregates)
{
  const auto rows = static_cast<Eigen::Index>(aggregates.ofRow.size());
  RowMatrix result(rows, aggregates.count);
  result.reserve(rows);
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    result.startVec(row);
    const int aggregate = aggregates.ofRow[static_cast<std::size_t>(row)];
    if (aggregate != Aggregates::None)
    {
      result.insertBack(row, aggregate) = 1.0;
    }
  }
  result.finalize();
  return result;
}

/// Some rows of identity - weight * diagonal^-1 * matrix, of which weak entries are added to the
/// diagonal: then the functions of the next level overlap less.
RowMatrix smoothingRows(const RowMatrix& matrix, const Coupling& coupling, const Values& diagonal,
  double weight, Eigen::Index begin, Eigen::Index count)
{
  RowMatrix rows = matrix.middleRows(begin, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Eigen::Index row = begin + i;
    double weak = 0.0;
    for (RowMatrix::InnerIterator entry(rows, i); entry; ++entry)
    {
      const bool isKept = coupling.isStrong(row, entry.col(), entry.value());
      weak += entry.col() != row && !isKept ? entry.value() : 0.0;
      entry.valueRef() *= isKept || entry.col() == row ? -weight / diagonal[row] : 0.0;
    }
    rows.coeffRef(i, row) += 1.0 - weight * weak / diagonal[row];
  }
  return rows;
}

/// At least the largest eigenvalue of diagonal^-1 * matrix, by Gershgorin's theorem.
double largestEigenvalue(const RowMatrix& matrix, const Values& diagonal)
{
  double largest = 0.0;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
  {
    double sum = 0.0;
    for (RowMatrix::InnerIterator entry(matrix, row); entry; ++entry)
    {
      sum += std::abs(entry.value());
    }
    largest = std::max(largest, sum / diagonal[row]);
  }
  return largest;
}

/// From the functions of the next level to those of this.
RowMatrix prolongationOf(const RowMatrix& matrix, const Execution& execution)
{
  const Coupling coupling(matrix);
  const Aggregates aggregates = aggregate(coupling, matrix.rows());
  const Values diagonal = matrix.diagonal();
  const double weight = SmoothingWeight / largestEigenvalue(matrix, diagonal);
  const RowMatrix constants = indicators(aggregates);
  return stack(matrix.rows(), aggregates.count, execution,
    [&](Eigen::Index begin, Eigen::Index count)
    {
      const RowMatrix rows =
        smoothingRows(matrix, coupling, diagonal, weight, begin, count) * constants;
      return RowMatrix(rows.pruned(1.0, 0.0));
    });
}

/// restriction * matrix * prolongation
RowMatrix matrixOfNext(const RowMatrix& restriction, const RowMatrix& matrix,
  const RowMatrix& prolongation, const Execution& execution)
{
  return stack(restriction.rows(), restriction.rows(), execution,
    [&](Eigen::Index begin, Eigen::Index count)
    {
      const RowMatrix rows = restriction.middleRows(begin, count) * matrix;
      return RowMatrix(rows * prolongation);
    });
}

/// Calls body(first, count) for blocks of rows.
template <class Body>
void forEachBlock(Eigen::Index rows, const Execution& execution, const Body& body)
{
  parallelFor(static_cast<std::size_t>(rows), ProductGrain, execution,
    [&](std::size_t begin, std::size_t end)
    { body(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin)); });
}

/// sum += matrix * vector
void addProduct(
  const RowMatrix& matrix, const Values& vector, Values& sum, const Execution& execution)
{
  forEachBlock(matrix.rows(), execution,
    [&](Eigen::Index first, Eigen::Index count)
    { sum.segment(first, count).noalias() += matrix.middleRows(first, count) * vector; });
}

} // namespace

Values multiply(const RowMatrix& matrix, const Values& vector, const Execution& execution)
{
  Values result(matrix.rows());
  forEachBlock(matrix.rows(), execution,
    [&](Eigen::Index first, Eigen::Index count)
    { result.segment(first, count).noalias() = matrix.middleRows(first, count) * vector; });
  return result;
}

Multigrid::Multigrid(const RowMatrix& matrix, bool isSymmetric, const Execution& execution)
  : isSymmetric_(isSymmetric)
{
  RowMatrix last;
  const RowMatrix* current = &matrix;
  double done = 0.0;
  while (current->rows() > (isSymmetric ? MostFactored : MostFactoredByLU))
  {
    const double next = 0.2 * done + 0.8; // a level takes a fraction of the one before
    const double half = 0.5 * (done + next);
    Level& level =
      this->levels_.emplace_back(Level{ GaussSeidel(*current), RowMatrix(), RowMatrix() });
    level.prolongation = prolongationOf(*current, execution.part(done, half));
    level.restriction = level.prolongation.transpose();
    RowMatrix coarse =
      matrixOfNext(level.restriction, *current, level.prolongation, execution.part(half, next));
    last.swap(coarse);
    current = &last;
    done = next;
  }
  this->factorLast(*current, matrix.rows());
  execution.report(1.0);
}

/// @param rows of the first
void Multigrid::factorLast(const RowMatrix& matrix, Eigen::Index rows)
{
  if (matrix.rows() == 0)
  {
    return; // diagonals dominate all rows of the level before
  }
  const auto factor = [&matrix](auto& factorization)
  {
    factorization.compute(matrix);
    return factorization.info() == Eigen::Success;
  };
  if (!(this->isSymmetric_ ? factor(this->cholesky_) : factor(this->lu_)))
  {
    throw Error(
      "the matrix of a linear system of " + std::to_string(rows) + " equations is singular.");
  }
}

Values Multigrid::solveLast(const Values& residual) const
{
  if (residual.size() == 0)
  {
    return residual;
  }
  return this->isSymmetric_ ? Values(this->cholesky_.solve(residual))
                            : Values(this->lu_.solve(residual));
}

Values Multigrid::apply(const Values& residual, const Execution& execution) const
{
  return this->cycle(0, residual, execution);
}

Values Multigrid::cycle(std::size_t level, const Values& residual, const Execution& execution) const
{
  if (level == this->levels_.size())
  {
    return this->solveLast(residual);
  }
  const Level& fine = this->levels_[level];
  GaussSeidel::Sweep sweep = fine.sweeps.forward(residual, execution);
  const Values correction =
    this->cycle(level + 1, multiply(fine.restriction, sweep.residual, execution), execution);
  addProduct(fine.prolongation, correction, sweep.solution, execution);
  fine.sweeps.back(residual, sweep, execution);
  return std::move(sweep.solution);
}

} // namespace SurfaceScalars
