#pragma once

#include "Basics.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// Which are above a bound, the largest first, ties by index; at most so many.
inline std::vector<Index> largestMisses(const Values& misses, double bound, std::size_t most)
{
  std::vector<Index> order;
  for (Index i = 0; i < static_cast<Index>(misses.size()); ++i)
  {
    if (misses[i] > bound)
    {
      order.push_back(i);
    }
  }
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
  std::partial_sort(order.begin(), end, order.end(),
    [&](Index a, Index b) { return misses[a] != misses[b] ? misses[a] > misses[b] : a < b; });
  order.erase(end, order.end());
  return order;
}

} // namespace SurfaceScalars
