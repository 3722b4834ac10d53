#include "CriticalIndex.h"

#include "Places.h"
#include "PointTree.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::array<double, 4> RingRadii{ 0.15, 0.35, 0.7, 1.4 }; // in those of the fits
constexpr std::size_t PairRing = 2; // closer together, points may not be told apart
constexpr double RingWidth = 0.2;   // of its radius: points there may be in or out

int indexOf(const TypedPoint& point)
{
  return SurfaceScalars::indexOf(point.type, point.multiplicity);
}

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

/// Whether a ring around a point encloses less than was found there: its partner is
/// missing, and of those that it could be partner of none is seen worse.
bool isHalf(const TypedPoint& point, const std::vector<TypedPoint>& points, const PointTree& tree)
{
  const std::optional<int> enclosed = point.point.enclosed[PairRing];
  if (!enclosed || point.type == CriticalType::Uncertain)
  {
    return false;
  }
  const double radius = RingRadii[PairRing] * point.point.reach;
  Neighborhood near;
  tree.within(point.point.place, (1.0 + RingWidth) * radius, near);
  int found = 0;
  for (const Index i : near.indices)
  {
    const TypedPoint& other = points[i];
    const bool isOnRing =
      (other.point.place - point.point.place).norm() >= (1.0 - RingWidth) * radius;
    const bool isWorse =
      indexOf(other) == indexOf(point) && other.point.significance[0] < point.point.significance[0];
    if (isOnRing || isWorse)
    {
      return false;
    }
    found += indexOf(other);
  }
  return found - *enclosed == indexOf(point);
}

} // namespace

void encloseByRings(
  std::vector<RefinedPoint>& points, const CriticalScale& scale, const Execution& execution)
{
  parallelForEach(points.size(), execution,
    [&](std::size_t i, const Poll&)
    {
      CriticalModel model(scale);
      RefinedPoint& point = points[i];
      for (std::size_t ring = 0; ring < RingRadii.size(); ++ring)
      {
        point.enclosed[ring] =
          indexWithin(model, { point.place, point.normal, RingRadii[ring] * point.reach });
      }
    });
}

void settleIndices(std::vector<TypedPoint>& points)
{
  for (TypedPoint& point : points)
  {
    point.type = settledType(point);
  }
  const Points places = placesOf(points, [](const TypedPoint& typed) { return typed.point.place; });
  const PointTree tree(places);
  std::vector<TypedPoint> kept;
  for (const TypedPoint& point : points)
  {
    if (point.type != CriticalType::Regular && !isHalf(point, points, tree))
    {
      kept.push_back(point);
    }
  }
  points = std::move(kept);
}

} // namespace SurfaceScalars
