#pragma once

#include "Basics.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace SurfaceScalars::Truth
{

/// The place of each vertex in the order of the values, ties by index.
inline std::vector<int> ranksOf(const Values& values)
{
  std::vector<int> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  std::vector<int> ranks(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    ranks[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  }
  return ranks;
}

} // namespace SurfaceScalars::Truth
