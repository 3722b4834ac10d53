#include "Laplacian.h"

#include <numeric>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// Disjoint sets, each represented by its first member.
class DisjointSets
{
public:
  explicit DisjointSets(int count)
    : parents_(static_cast<std::size_t>(count))
  {
    std::iota(this->parents_.begin(), this->parents_.end(), 0);
  }

  int first(int member)
  {
    while (this->parent(member) != member)
    {
      this->parent(member) = this->parent(this->parent(member));
      member = this->parent(member);
    }
    return member;
  }

  void unite(int one, int other)
  {
    const auto [first, second] = std::minmax({ this->first(one), this->first(other) });
    this->parent(second) = first;
  }

private:
  int& parent(int member) { return this->parents_[static_cast<std::size_t>(member)]; }

  std::vector<int> parents_;
};

} // namespace

std::vector<int> connectedComponents(const Eigen::SparseMatrix<double>& matrix)
{
  const auto count = static_cast<int>(matrix.cols());
  DisjointSets sets(count);
  for (int j = 0; j < count; ++j)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry)
    {
      if (entry.value() != 0.0)
      {
        sets.unite(static_cast<int>(entry.row()), j);
      }
    }
  }
  std::vector<int> result;
  result.reserve(static_cast<std::size_t>(count));
  int components = 0;
  for (int i = 0; i < count; ++i)
  {
    const int first = sets.first(i);
    result.push_back(first == i ? components++ : result[static_cast<std::size_t>(first)]);
  }
  return result;
}

} // namespace SurfaceScalars
