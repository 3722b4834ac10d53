#include "CriticalClusters.h"

#include "CriticalCompletion.h"
#include "CriticalGroups.h"
#include "CriticalIndex.h"
#include "Places.h"

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

/// Each place once, with the votes of all.
std::vector<RefinedPoint> mergeSame(const std::vector<RefinedPoint>& points, const Trust& trust)
{
  const Points places = placesOf(points, [](const RefinedPoint& point) { return point.place; });
  const auto radiusAt = [&](std::size_t i) { return SamePoint * points[i].reach; };
  const auto isSame = [&](std::size_t i, std::size_t j)
  {
    const RefinedPoint& a = points[i];
    const RefinedPoint& b = points[j];
    const double distance = (a.place - b.place).norm() / std::max(a.reach, b.reach);
    return distance <= SamePlace ||
      (distance <= SamePoint && trust.isSure(a) && trust.isSure(b) && typeOf(a) == typeOf(b));
  };
  std::vector<RefinedPoint> merged;
  for (const std::vector<std::size_t>& group : groupsOf(places, radiusAt, isSame))
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
  completePlaces(merged, scale, execution.part(0.0, 0.4));
  const SurePoints sure(merged, trust);
  const std::vector<std::vector<std::size_t>> groups = groupsOf(
    placesOf(merged, [](const RefinedPoint& point) { return point.place; }),
    [&](std::size_t i) { return SplitDistance * merged[i].reach; },
    [&](std::size_t i, std::size_t j)
    { return !trust.isSure(merged[i]) && !trust.isSure(merged[j]); });
  std::vector<std::vector<TypedPoint>> typed(groups.size());
  parallelForEach(groups.size(), execution.part(0.4, 0.8),
    [&](std::size_t group, const Poll&)
    { typed[group] = CriticalClassifier(merged, sure, trust, scale).classify(groups[group]); });
  std::vector<TypedPoint> result;
  for (const std::vector<TypedPoint>& some : typed)
  {
    result.insert(result.end(), some.begin(), some.end());
  }
  dropParts(result);
  settleIndices(result, merged, scale, execution.part(0.8, 1.0));
  return result;
}

} // namespace SurfaceScalars
