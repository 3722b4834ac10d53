#include "CriticalClusters.h"

#include "CriticalCompletion.h"
#include "CriticalIndex.h"
#include "Places.h"
#include "PointTree.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace SurfaceScalars
{
namespace
{

// In radii of the fits.
constexpr double SamePlace = 0.1;
constexpr double SamePoint = 0.5;      // of the same type
constexpr double SplitDistance = 0.75; // of places that one degenerate point is split into

/// What is linked, directly or not, as groups of indices in the order of their first points.
template <class Linked>
std::vector<std::vector<std::size_t>> groupsOf(
  const std::vector<RefinedPoint>& points, double distance, const Linked& linked)
{
  const Points places = placesOf(points, [](const RefinedPoint& point) { return point.place; });
  const PointTree tree(places);
  std::vector<char> taken(points.size(), 0);
  std::vector<std::vector<std::size_t>> groups;
  Neighborhood near;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (taken[i])
    {
      continue;
    }
    taken[i] = 1;
    std::vector<std::size_t> group{ i };
    for (std::size_t next = 0; next < group.size(); ++next)
    {
      const RefinedPoint& point = points[group[next]];
      tree.within(point.place, distance * point.reach, near);
      for (const Index other : near.indices)
      {
        if (!taken[other] && linked(point, points[other]))
        {
          taken[other] = 1;
          group.push_back(other);
        }
      }
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Each place once, with the votes of all.
std::vector<RefinedPoint> mergeSame(const std::vector<RefinedPoint>& points, const Trust& trust)
{
  const auto isSame = [&](const RefinedPoint& a, const RefinedPoint& b)
  {
    const double distance = (a.place - b.place).norm() / std::max(a.reach, b.reach);
    return distance <= SamePlace ||
      (distance <= SamePoint && trust.isSure(a) && trust.isSure(b) && typeOf(a) == typeOf(b));
  };
  std::vector<RefinedPoint> merged;
  for (const std::vector<std::size_t>& group : groupsOf(points, SamePoint, isSame))
  {
    const auto best = std::max_element(group.begin(), group.end(),
      [&](std::size_t a, std::size_t b)
      { return points[a].significance[0] < points[b].significance[0]; });
    merged.push_back(points[*best]);
    merged.back().votes = 0;
    for (const std::size_t i : group)
    {
      merged.back().votes += points[i].votes;
    }
  }
  return merged;
}

/// A multiple saddle swallows the simple ones that fits split it into, and itself seen twice.
void dropParts(std::vector<TypedPoint>& points)
{
  std::vector<TypedPoint> kept;
  const auto isPart = [&](const TypedPoint& part)
  {
    return std::any_of(points.begin(), points.end(),
      [&](const TypedPoint& whole)
      {
        const bool isFirst = whole.multiplicity > part.multiplicity ||
          (whole.multiplicity == part.multiplicity && whole.type == part.type && &whole < &part);
        return isFirst && (whole.point.place - part.point.place).norm() < whole.extent;
      });
  };
  std::remove_copy_if(points.begin(), points.end(), std::back_inserter(kept), isPart);
  points = std::move(kept);
}

} // namespace

std::vector<TypedPoint> clusterPoints(
  const std::vector<RefinedPoint>& points, const CriticalScale& scale, const Execution& execution)
{
  const Trust trust(scale);
  std::vector<RefinedPoint> merged = mergeSame(points, trust);
  completePlaces(merged, scale, execution.part(0.0, 0.5));
  const SurePoints sure(merged, trust);
  const std::vector<std::vector<std::size_t>> groups = groupsOf(merged, SplitDistance,
    [&](const RefinedPoint& a, const RefinedPoint& b)
    { return !trust.isSure(a) && !trust.isSure(b); });
  std::vector<std::vector<TypedPoint>> typed(groups.size());
  parallelForEach(groups.size(), execution.part(0.5, 1.0),
    [&](std::size_t group, const Poll&)
    { typed[group] = CriticalClassifier(merged, sure, trust, scale).classify(groups[group]); });
  std::vector<TypedPoint> result;
  for (const std::vector<TypedPoint>& some : typed)
  {
    result.insert(result.end(), some.begin(), some.end());
  }
  dropParts(result);
  settleIndices(result, merged);
  return result;
}

} // namespace SurfaceScalars
