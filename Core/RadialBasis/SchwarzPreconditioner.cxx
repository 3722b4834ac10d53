#include "SchwarzPreconditioner.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int RunLength = 200;

/// The rows outside of [begin, end) that have the largest entries in it, at most as many as those
/// within, and those within.
std::vector<int> overlapping(const SparseMatrix& matrix, int begin, int end)
{
  std::unordered_map<int, double> largest;
  for (int row = begin; row < end; ++row)
  {
    for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
    {
      const auto column = static_cast<int>(entry.col());
      if (column < begin || column >= end)
      {
        double& value = largest[column];
        value = std::max(value, entry.value());
      }
    }
  }
  std::vector<std::pair<double, int>> outside; // the nearest first
  outside.reserve(largest.size());
  for (const auto& [column, value] : largest)
  {
    outside.emplace_back(-value, column);
  }
  std::sort(outside.begin(), outside.end());
  outside.resize(std::min(outside.size(), static_cast<std::size_t>(end - begin)));
  std::vector<int> rows(static_cast<std::size_t>(end - begin));
  std::iota(rows.begin(), rows.end(), begin);
  for (const auto& [value, column] : outside)
  {
    rows.push_back(column);
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// The rows and columns that are given, in ascending order.
Eigen::MatrixXd principal(const SparseMatrix& matrix, const std::vector<int>& rows)
{
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    Eigen::Index i = 0;
    for (SparseMatrix::InnerIterator entry(matrix, rows[static_cast<std::size_t>(j)]);
         entry && i < count; ++entry)
    {
      while (i < count && rows[static_cast<std::size_t>(i)] < entry.col())
      {
        ++i;
      }
      if (i < count && rows[static_cast<std::size_t>(i)] == entry.col())
      {
        result(i, j) = entry.value();
      }
    }
  }
  return result;
}

} // namespace

SchwarzPreconditioner::SchwarzPreconditioner(const SparseMatrix& matrix, const Execution& execution)
{
  const auto count = static_cast<std::size_t>(matrix.rows());
  this->blocks_.resize((count + RunLength - 1) / RunLength);
  parallelFor(count, RunLength, execution,
    [&](std::size_t begin, std::size_t end)
    {
      Block& block = this->blocks_[begin / RunLength];
      block.rows = overlapping(matrix, static_cast<int>(begin), static_cast<int>(end));
      block.factor.compute(principal(matrix, block.rows));
    });
}

bool SchwarzPreconditioner::isPositiveDefinite() const
{
  return std::all_of(this->blocks_.begin(), this->blocks_.end(),
    [](const Block& block) { return block.factor.info() == Eigen::Success; });
}

Values SchwarzPreconditioner::apply(const Values& residual, const Execution& execution) const
{
  std::vector<Values> parts(this->blocks_.size());
  parallelFor(parts.size(), 8, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const Block& block = this->blocks_[i];
        parts[i] = block.factor.solve(residual(block.rows));
      }
    });
  // In one order, for the same rounding errors with any number of threads.
  Values result = Values::Zero(residual.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    result(this->blocks_[i].rows) += parts[i];
  }
  return result;
}

} // namespace SurfaceScalars
