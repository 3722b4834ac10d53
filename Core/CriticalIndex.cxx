#include "CriticalIndex.h"

#include "Places.h"
#include "PointTree.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

// In radii of the fits.
constexpr double PairDistance = 1.4; // of a saddle and an extremum that may be left out together
constexpr double SamePlace = 1e-6;
constexpr double Resolved = 5.0;    // larger eigenvalue to its standard error
constexpr double RidgeBend = 0.1;   // change of the Hessian to its larger eigenvalue
constexpr double RidgeRatio = 0.01; // of eigenvalues: less may be the misfit to a curved ridge

int indexOf(const TypedPoint& point)
{
  return SurfaceScalars::indexOf(point.type, point.multiplicity);
}

/// 0 where it is not known, too.
int indexOf(const RefinedPoint& place)
{
  return place.enclosed.front().value_or(0);
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

bool isAt(const TypedPoint& point, const RefinedPoint& place)
{
  return (point.point.place - place.place).norm() <= SamePlace * place.reach;
}

bool isPartOf(const TypedPoint& point, const RefinedPoint& place)
{
  return (point.point.place - place.place).norm() <= point.extent;
}

/// Whether a simple point was typed on a circle around parts whose indices sum to another one.
bool isContradicted(const TypedPoint& point, const std::vector<RefinedPoint>& places)
{
  if (point.extent == 0.0 || point.multiplicity > 1)
  {
    return false;
  }
  int sum = 0;
  bool isKnown = false;
  for (const RefinedPoint& place : places)
  {
    if (isPartOf(point, place))
    {
      sum += indexOf(place);
      isKnown = isKnown || place.enclosed.front();
    }
  }
  return isKnown && sum != indexOf(point);
}

/// The places whose index no point has.
std::vector<RefinedPoint> leftOut(
  const std::vector<TypedPoint>& points, const std::vector<RefinedPoint>& places)
{
  const Points positions =
    placesOf(points, [](const TypedPoint& point) { return point.point.place; });
  const PointTree tree(positions);
  double largestExtent = 0.0;
  for (const TypedPoint& point : points)
  {
    largestExtent = std::max(largestExtent, point.extent);
  }
  Neighborhood near;
  const auto isTaken = [&](const RefinedPoint& place)
  {
    tree.within(place.place, std::max(largestExtent, SamePlace * place.reach), near);
    return indexOf(place) == 0 ||
      std::any_of(near.indices.begin(), near.indices.end(),
        [&](Index i)
        {
          return indexOf(points[i]) != 0 &&
            (isPartOf(points[i], place) ||
              (isAt(points[i], place) && indexOf(points[i]) == indexOf(place)));
        });
  };
  std::vector<RefinedPoint> result;
  std::remove_copy_if(places.begin(), places.end(), std::back_inserter(result), isTaken);
  return result;
}

struct OppositePair
{
  double distance; ///< in radii
  std::size_t first;
  std::size_t second;
};

/// The closest first.
std::vector<OppositePair> oppositePairs(const std::vector<RefinedPoint>& places)
{
  const Points positions = placesOf(places, [](const RefinedPoint& place) { return place.place; });
  const PointTree tree(positions);
  std::vector<OppositePair> pairs;
  Neighborhood near;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    tree.within(places[i].place, PairDistance * places[i].reach, near);
    for (const Index other : near.indices)
    {
      if (indexOf(places[i]) == -indexOf(places[other]))
      {
        const double distance = (places[i].place - places[other].place).norm() / places[i].reach;
        pairs.push_back({ distance, i, static_cast<std::size_t>(other) });
      }
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
    [](const OppositePair& a, const OppositePair& b) { return a.distance < b.distance; });
  return pairs;
}

/// What remains when opposite neighbors are taken away together.
std::vector<RefinedPoint> withoutPairs(const std::vector<RefinedPoint>& places)
{
  std::vector<char> isGone(places.size(), 0);
  for (const OppositePair& pair : oppositePairs(places))
  {
    if (!isGone[pair.first] && !isGone[pair.second])
    {
      isGone[pair.first] = isGone[pair.second] = 1;
    }
  }
  std::vector<RefinedPoint> single;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (!isGone[i])
    {
      single.push_back(places[i]);
    }
  }
  return single;
}

/// Along which f hardly changes: noise turns the gradient there. Between a saddle and an extremum
/// the smaller curvature vanishes, too, but the Hessian changes.
bool isOnRidge(const RefinedPoint& place)
{
  const Vector2d sizes = place.curvature.cwiseAbs();
  return sizes.minCoeff() < RidgeRatio * sizes.maxCoeff() &&
    place.bend < RidgeBend * sizes.maxCoeff();
}

/// Whether fits see f curved there: else samples are too coarse, and gradients turn by chance.
bool isResolved(const RefinedPoint& place)
{
  return place.significance[1] >= Resolved;
}

TypedPoint typedByIndex(const RefinedPoint& place)
{
  const int index = indexOf(place);
  if (index < 0)
  {
    return { place, CriticalType::Saddle, -index, 0.0 };
  }
  return { place, place.curvature.sum() > 0.0 ? CriticalType::Minimum : CriticalType::Maximum, 1,
    0.0 };
}

} // namespace

void settleIndices(std::vector<TypedPoint>& points, const std::vector<RefinedPoint>& places)
{
  std::vector<TypedPoint> kept;
  for (TypedPoint point : points)
  {
    point.type = settledType(point);
    if (point.type != CriticalType::Regular && !isContradicted(point, places))
    {
      kept.push_back(point);
    }
  }
  for (const RefinedPoint& place : withoutPairs(leftOut(kept, places)))
  {
    if (isOnRidge(place) || !isResolved(place))
    {
      continue;
    }
    const auto isThere = [&](const TypedPoint& point) { return isAt(point, place); };
    kept.erase(std::remove_if(kept.begin(), kept.end(), isThere), kept.end());
    kept.push_back(typedByIndex(place));
  }
  points = std::move(kept);
}

} // namespace SurfaceScalars
