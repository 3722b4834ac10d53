#pragma once

#include "PointTree.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace SurfaceScalars
{

/**
 * What is linked, directly or not, as groups of indices in the order of their first places.
 *
 * @param radiusAt of a place's index: how far links are looked for from there
 * @param isLinked of the indices of two places at most that far apart
 */
template <class RadiusAt, class IsLinked>
std::vector<std::vector<std::size_t>> groupsOf(
  const Points& places, const RadiusAt& radiusAt, const IsLinked& isLinked)
{
  const PointTree tree(places);
  const auto count = static_cast<std::size_t>(places.cols());
  std::vector<char> taken(count, 0);
  std::vector<std::vector<std::size_t>> groups;
  Neighborhood near;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (taken[i])
    {
      continue;
    }
    taken[i] = 1;
    std::vector<std::size_t> group{ i };
    for (std::size_t next = 0; next < group.size(); ++next)
    {
      const std::size_t from = group[next];
      tree.within(places.col(static_cast<Eigen::Index>(from)), radiusAt(from), near);
      for (const Index to : near.indices)
      {
        if (!taken[to] && isLinked(from, static_cast<std::size_t>(to)))
        {
          taken[to] = 1;
          group.push_back(to);
        }
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

} // namespace SurfaceScalars
