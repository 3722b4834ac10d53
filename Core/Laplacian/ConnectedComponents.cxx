#include "DisjointSets.h"
#include "Laplacian.h"

#include <algorithm>

namespace SurfaceScalars
{

std::vector<int> connectedComponents(const Eigen::SparseMatrix<double>& matrix)
{
  const auto count = static_cast<Index>(matrix.cols());
  DisjointSets sets(count); // the first member of each is its root
  for (Index j = 0; j < count; ++j)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry)
    {
      const auto [first, second] =
        std::minmax({ sets.find(static_cast<Index>(entry.row())), sets.find(j) });
      if (entry.value() != 0.0 && first != second)
      {
        sets.attach(second, first);
      }
    }
  }
  std::vector<int> result;
  result.reserve(count);
  int components = 0;
  for (Index i = 0; i < count; ++i)
  {
    result.push_back(sets.isRoot(i) ? components++ : result[sets.find(i)]);
  }
  return result;
}

} // namespace SurfaceScalars
