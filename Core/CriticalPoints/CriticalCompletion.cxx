#include "CriticalCompletion.h"

#include "CriticalTurns.h"
#include "Places.h"
#include "PointTree.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace SurfaceScalars
{
namespace
{

// In radii of the fits.
constexpr std::array<double, 4> RingRadii{ 0.15, 0.35, 0.7, 1.4 };
constexpr double SmallestDisc = 0.85;    // that is searched
constexpr double DiscMargin = 1.15;      // of the ring: places on it may be in or out
constexpr double CellWidth = 0.13;       // less than the smallest ring
constexpr double SamePlace = 0.05;       // where Newton's method leads
constexpr double SameCell = 0.2;         // where it does not
constexpr double LonelinessMargin = 1.2; // of the ring around a single place

std::optional<int> indexAround(CriticalModel& model, const RefinedPoint& point, std::size_t ring)
{
  return indexWithin(model, { point.place, point.normal, RingRadii[ring] * point.reach });
}

/// Asks the rings from one on, around all points from one on.
void encloseByRings(std::vector<RefinedPoint>& points, std::size_t firstPoint,
  std::size_t firstRing, const CriticalScale& scale, const Execution& execution)
{
  parallelForEach(points.size() - firstPoint, execution,
    [&](std::size_t i, const Poll&)
    {
      CriticalModel model(scale);
      RefinedPoint& point = points[firstPoint + i];
      for (std::size_t ring = firstRing; ring < RingRadii.size(); ++ring)
      {
        point.enclosed[ring] = indexAround(model, point, ring);
      }
    });
}

/// The places so far, with the indices that are known.
class KnownPlaces
{
public:
  explicit KnownPlaces(const std::vector<RefinedPoint>& points)
    : points_(points)
    , places_(placesOf(points, [](const RefinedPoint& point) { return point.place; }))
    , tree_(this->places_)
  {
    for (const RefinedPoint& point : points)
    {
      this->indices_.push_back(point.enclosed.front().value_or(0));
    }
  }

  /// The radius, in those of the fit, of the disc around a place that misses another; or none.
  std::optional<double> incompleteAround(std::size_t i, Neighborhood& near) const;
  /// What the widest ring that encloses nothing else, or else the smallest, says.
  std::optional<int> ownIndex(std::size_t i, Neighborhood& near) const;

private:
  const std::vector<RefinedPoint>& points_;
  Points places_;
  PointTree tree_;
  std::vector<int> indices_;
};

std::optional<double> KnownPlaces::incompleteAround(std::size_t i, Neighborhood& near) const
{
  const RefinedPoint& point = this->points_[i];
  if (!point.enclosed.front())
  {
    return SmallestDisc;
  }
  for (std::size_t ring = 1; ring < RingRadii.size(); ++ring)
  {
    this->tree_.within(point.place, RingRadii[ring] * point.reach, near);
    int sum = 0;
    for (const Index other : near.indices)
    {
      sum += this->indices_[other];
    }
    if (point.enclosed[ring].value_or(sum) != sum)
    {
      return std::max(SmallestDisc, DiscMargin * RingRadii[ring]);
    }
  }
  return {};
}

std::optional<int> KnownPlaces::ownIndex(std::size_t i, Neighborhood& near) const
{
  const RefinedPoint& point = this->points_[i];
  std::optional<int> own = point.enclosed.front();
  for (std::size_t ring = 1; ring + 1 < RingRadii.size(); ++ring)
  {
    this->tree_.within(point.place, LonelinessMargin * RingRadii[ring] * point.reach, near);
    const bool isAlone = std::all_of(near.indices.begin(), near.indices.end(),
      [&](Index other) { return other == static_cast<Index>(i) || this->indices_[other] == 0; });
    if (isAlone && point.enclosed[ring])
    {
      own = point.enclosed[ring];
    }
  }
  return own;
}

/// The zero of the gradient in a cell around which it turns. Newton's method may lead to another
/// one, of other index; then the middle of the cell serves. No other ring is asked yet: most places
/// found so are known.
std::optional<RefinedPoint> placeIn(CriticalModel& model, const Turn& turn, double reach)
{
  std::optional<RefinedPoint> point = refinePlace(model, turn.place, reach);
  if (!point || indexAround(model, *point, 0).value_or(turn.index) != turn.index)
  {
    point = describePlace(model, turn.place);
    if (!point || model.isOnPlateau())
    {
      return {};
    }
    point->isSettled = false;
  }
  point->enclosed.front() = turn.index;
  return point;
}

/// Adds what is not there yet. The index of what is there may be new.
void addPlace(std::vector<RefinedPoint>& points, const RefinedPoint& found)
{
  const auto same = std::find_if(points.begin(), points.end(),
    [&](const RefinedPoint& point)
    {
      const double near = point.isSettled && found.isSettled ? SamePlace : SameCell;
      return (point.place - found.place).norm() <= near * point.reach &&
        point.enclosed.front().value_or(*found.enclosed.front()) == *found.enclosed.front();
    });
  if (same == points.end())
  {
    points.push_back(found);
  }
  else
  {
    same->enclosed.front() = found.enclosed.front();
  }
}

std::vector<RefinedPoint> placesAround(
  const RefinedPoint& point, double radius, const CriticalScale& scale)
{
  CriticalModel model(scale);
  std::vector<RefinedPoint> result;
  const Ring disc{ point.place, point.normal, radius * point.reach };
  for (const Turn& turn : turnsWithin(model, disc, CellWidth * point.reach))
  {
    const std::optional<RefinedPoint> found = placeIn(model, turn, point.reach);
    if (found)
    {
      result.push_back(*found);
    }
  }
  return result;
}

} // namespace

void completePlaces(
  std::vector<RefinedPoint>& points, const CriticalScale& scale, const Execution& execution)
{
  encloseByRings(points, 0, 0, scale, execution.part(0.0, 0.6));
  const std::size_t count = points.size();
  std::vector<std::vector<RefinedPoint>> missed(count);
  const KnownPlaces before(points);
  parallelForEach(count, execution.part(0.6, 0.9),
    [&](std::size_t i, const Poll&)
    {
      Neighborhood near;
      const std::optional<double> radius = before.incompleteAround(i, near);
      if (radius)
      {
        missed[i] = placesAround(points[i], *radius, scale);
      }
    });
  for (const std::vector<RefinedPoint>& some : missed)
  {
    for (const RefinedPoint& found : some)
    {
      addPlace(points, found);
    }
  }
  encloseByRings(points, count, 1, scale, execution.part(0.9, 1.0));
  const KnownPlaces all(points);
  Neighborhood near;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points[i].enclosed.front() = all.ownIndex(i, near);
  }
}

} // namespace SurfaceScalars
