#pragma once

#include "Basics.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace SurfaceScalars
{

/// Rows lie together: the product with a vector is one of rows, on any number of threads.
using RowMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;

/// Which entries say that their row and column have nearly the same value.
class Coupling
{
public:
  explicit Coupling(const RowMatrix& matrix);

  bool isStrong(Eigen::Index row, Eigen::Index column, double value) const
  {
    const double first = this->strongest_[row];
    const double second = this->strongest_[column];
    return row != column && std::abs(value) >= LeastCoupling * std::min(first, second) &&
      std::isfinite(std::max(first, second));
  }

  /// Calls visit(neighbor, strength).
  template <class Visit>
  void forEachStrong(Eigen::Index row, const Visit& visit) const
  {
    for (RowMatrix::InnerIterator entry(this->matrix_, row); entry; ++entry)
    {
      if (this->isStrong(row, entry.col(), entry.value()))
      {
        visit(entry.col(), std::abs(entry.value()));
      }
    }
  }

private:
  static constexpr double LeastCoupling = 0.4; // of a strong entry, relative to its row's strongest

  const RowMatrix& matrix_;
  Values strongest_; ///< in each row; infinite in one that its diagonal dominates
};

/// Rows that are strongly coupled are gathered.
struct Aggregates
{
  static constexpr int None = -1; ///< of rows without strong entries

  std::vector<int> ofRow; ///< counted from 0
  int count = 0;
};

/// Aggregates of a row and all that are coupled to it, and of neighbors of these that are left.
/// Each has at least two rows.
Aggregates aggregate(const Coupling& coupling, Eigen::Index rows);

} // namespace SurfaceScalars
