#include "Aggregation.h"

#include <limits>

namespace SurfaceScalars
{
namespace
{

// Of the entries beside a diagonal that solves its row alone.
constexpr double Dominance = 0.2;

/// Each row without a neighbor in an aggregate starts one with all its neighbors.
Aggregates startAggregates(const Coupling& coupling, Eigen::Index rows)
{
  Aggregates result{ std::vector<int>(static_cast<std::size_t>(rows), Aggregates::None) };
  int* const ofRow = result.ofRow.data();
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    bool isFree = ofRow[row] == Aggregates::None;
    bool isAlone = true;
    coupling.forEachStrong(row,
      [&](Eigen::Index neighbor, double)
      {
        isAlone = false;
        isFree = isFree && ofRow[neighbor] == Aggregates::None;
      });
    if (isFree && !isAlone)
    {
      ofRow[row] = result.count;
      coupling.forEachStrong(
        row, [&](Eigen::Index neighbor, double) { ofRow[neighbor] = result.count; });
      ++result.count;
    }
  }
  return result;
}

} // namespace

Coupling::Coupling(const RowMatrix& matrix)
  : matrix_(matrix)
  , strongest_(Values::Zero(matrix.rows()))
{
  for (Eigen::Index row = 0; row < matrix.rows(); ++row)
  {
    double diagonal = 0.0;
    double sum = 0.0;
    for (RowMatrix::InnerIterator entry(matrix, row); entry; ++entry)
    {
      const double size = std::abs(entry.value());
      (entry.col() == row ? diagonal : sum) += size;
      if (entry.col() != row)
      {
        this->strongest_[row] = std::max(this->strongest_[row], size);
      }
    }
    if (sum <= Dominance * diagonal)
    {
      this->strongest_[row] = std::numeric_limits<double>::infinity();
    }
  }
}

/// The other rows join that of their strongest neighbor in one; those without neighbors join none.
Aggregates aggregate(const Coupling& coupling, Eigen::Index rows)
{
  const Aggregates started = startAggregates(coupling, rows);
  Aggregates result = started;
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    int& own = result.ofRow[static_cast<std::size_t>(row)];
    if (own != Aggregates::None)
    {
      continue;
    }
    double strongest = 0.0;
    coupling.forEachStrong(row,
      [&](Eigen::Index neighbor, double strength)
      {
        const int other = started.ofRow[static_cast<std::size_t>(neighbor)];
        if (other != Aggregates::None && strength > strongest)
        {
          strongest = strength;
          own = other;
        }
      });
  }
  return result;
}

} // namespace SurfaceScalars
