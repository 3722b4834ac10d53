#include "RowOrder.h"

#include <cstdlib>

namespace SurfaceScalars
{
namespace
{

Eigen::Index farEntries(const RowMatrix& matrix, int near)
{
  Eigen::Index count = 0;
  for (int row = 0; row < matrix.rows(); ++row)
  {
    for (RowMatrix::InnerIterator entry(matrix, row); entry; ++entry)
    {
      count += std::abs(entry.col() - row) > near ? 1 : 0;
    }
  }
  return count;
}

} // namespace

std::vector<int> orderOfRows(const RowMatrix& matrix, int near)
{
  std::vector<int> order;
  if (2 * farEntries(matrix, near) < matrix.nonZeros())
  {
    return order;
  }
  const auto count = static_cast<std::size_t>(matrix.rows());
  order.reserve(count);
  std::vector<char> isKnown(count, 0);
  const auto append = [&](int row)
  {
    if (isKnown[static_cast<std::size_t>(row)] == 0)
    {
      isKnown[static_cast<std::size_t>(row)] = 1;
      order.push_back(row);
    }
  };
  std::size_t next = 0;
  for (int start = 0; start < matrix.rows(); ++start)
  {
    append(start); // of each component the first
    for (; next < order.size(); ++next)
    {
      for (RowMatrix::InnerIterator entry(matrix, order[next]); entry; ++entry)
      {
        append(static_cast<int>(entry.col()));
      }
    }
  }
  return order;
}

RowMatrix inOrder(const RowMatrix& matrix, const std::vector<int>& order)
{
  std::vector<int> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    places[static_cast<std::size_t>(order[place])] = static_cast<int>(place);
  }
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(static_cast<std::size_t>(matrix.nonZeros()));
  for (const int row : order)
  {
    for (RowMatrix::InnerIterator entry(matrix, row); entry; ++entry)
    {
      entries.emplace_back(places[static_cast<std::size_t>(row)],
        places[static_cast<std::size_t>(entry.col())], entry.value());
    }
  }
  RowMatrix result(matrix.rows(), matrix.cols());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace SurfaceScalars
