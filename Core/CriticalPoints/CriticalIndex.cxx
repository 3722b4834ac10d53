#include "CriticalIndex.h"

#include "CriticalBalance.h"
#include "Places.h"
#include "PointTree.h"

#include <algorithm>
#include <optional>

namespace SurfaceScalars
{
namespace
{

constexpr double SamePlace = 0.02; // in radii of the fits

/// The type that the turns of the gradient leave to a point.
CriticalType settledType(const TypedPoint& point)
{
  const std::optional<int> own = point.point.enclosed.front();
  if (own == 0)
  {
    return CriticalType::Regular;
  }
  return !own || *own == indexOf(point) ? point.type : CriticalType::Uncertain;
}

/// How far the places lie that a point stands for: the parts of a multiple saddle, or its own.
double partsRadius(const TypedPoint& point)
{
  return std::max(point.multiplicity > 1 ? point.extent : 0.0, SamePlace * point.point.reach);
}

/// Appends the places that no point stands for as regular points, unless nothing turns there.
void addOtherPlaces(std::vector<TypedPoint>& points, const std::vector<RefinedPoint>& places)
{
  const Points positions =
    placesOf(points, [](const TypedPoint& point) { return point.point.place; });
  const PointTree tree(positions);
  double largestRadius = 0.0;
  for (const TypedPoint& point : points)
  {
    largestRadius = std::max(largestRadius, partsRadius(point));
  }
  Neighborhood near;
  for (const RefinedPoint& place : places)
  {
    tree.within(place.place, largestRadius, near);
    const auto isPart = [&](Index i)
    { return (points[i].point.place - place.place).norm() <= partsRadius(points[i]); };
    if (place.enclosed.front() != 0 &&
      std::none_of(near.indices.begin(), near.indices.end(), isPart))
    {
      points.push_back({ place, CriticalType::Regular, 1, 0.0 });
    }
  }
}

void removeRegular(std::vector<TypedPoint>& points)
{
  points.erase(std::remove_if(points.begin(), points.end(),
                 [](const TypedPoint& point) { return point.type == CriticalType::Regular; }),
    points.end());
}

} // namespace

void settleIndices(std::vector<TypedPoint>& points, const std::vector<RefinedPoint>& places,
  const CriticalScale& scale, const Execution& execution)
{
  for (TypedPoint& point : points)
  {
    point.type = settledType(point);
  }
  removeRegular(points);
  addOtherPlaces(points, places);
  balanceIndices(points, scale, execution);
  removeRegular(points);
}

} // namespace SurfaceScalars
