#include "CriticalBalance.h"

#include "CriticalGroups.h"
#include "CriticalOutline.h"
#include "Places.h"
#include "PointTree.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>

namespace SurfaceScalars
{
namespace
{

// In radii of the fits.
constexpr double LinkDistance = 0.8;  // of points next to each other
constexpr double OtherDistance = 2.5; // of others that an outline may touch

constexpr double Resolved = 5.0;    // larger curvature to its standard error
constexpr double RidgeBend = 0.1;   // change of the Hessian to its larger eigenvalue
constexpr double RidgeRatio = 0.01; // of eigenvalues

using Group = std::vector<std::size_t>;

/// 0 where it is not known, too.
int ownIndex(const TypedPoint& point)
{
  return point.point.enclosed.front().value_or(0);
}

/// Of the weaker curvature, in standard errors.
double strength(const TypedPoint& point)
{
  return point.point.significance[0];
}

/// Whether fits see f curved there, but not along a ridge only, where noise turns the gradient and
/// the misfit to a curved one looks like a curvature along it. Between a saddle and an extremum the
/// smaller curvature vanishes, too, but the Hessian changes.
bool isResolved(const TypedPoint& point)
{
  const RefinedPoint& place = point.point;
  const Vector2d sizes = place.curvature.cwiseAbs();
  const bool isRidge =
    sizes.minCoeff() < RidgeRatio * sizes.maxCoeff() && place.bend < RidgeBend * sizes.maxCoeff();
  return place.significance[1] >= Resolved && !isRidge;
}

/// Points next to each other, in groups.
class GroupedPoints
{
public:
  /// @param points must outlive this
  explicit GroupedPoints(const std::vector<TypedPoint>& points);

  const std::vector<Group>& groups() const { return this->groups_; }
  /// What an outline around a group encloses; none where the indices are those already, or not
  /// known.
  std::optional<int> otherTotal(std::size_t group, const CriticalScale& scale) const;

private:
  bool isPlain(const Group& group) const;
  PlaceList othersAround(std::size_t group) const;

  const std::vector<TypedPoint>& points_;
  Points places_;
  PointTree tree_;
  std::vector<Group> groups_;
  std::vector<std::size_t> groupOf_; ///< of each point
};

GroupedPoints::GroupedPoints(const std::vector<TypedPoint>& points)
  : points_(points)
  , places_(placesOf(points, [](const TypedPoint& point) { return point.point.place; }))
  , tree_(this->places_)
  , groupOf_(points.size())
{
  const auto reachAt = [&](std::size_t i) { return points[i].point.reach; };
  this->groups_ = groupsOf(
    this->places_, [&](std::size_t i) { return 2.0 * LinkDistance * reachAt(i); },
    [&](std::size_t i, std::size_t j)
    {
      const double distance = (points[i].point.place - points[j].point.place).norm();
      return distance <= LinkDistance * std::max(reachAt(i), reachAt(j));
    });
  for (std::size_t group = 0; group < this->groups_.size(); ++group)
  {
    for (const std::size_t i : this->groups_[group])
    {
      this->groupOf_[i] = group;
    }
  }
}

/// One point alone, and no ring around it says otherwise.
bool GroupedPoints::isPlain(const Group& group) const
{
  const TypedPoint& first = this->points_[group.front()];
  const EnclosedIndices& enclosed = first.point.enclosed;
  return group.size() == 1 &&
    std::all_of(enclosed.begin(), enclosed.end(),
      [&](const std::optional<int>& index)
      { return index.value_or(indexOf(first)) == indexOf(first); });
}

PlaceList GroupedPoints::othersAround(std::size_t group) const
{
  PlaceList others;
  Neighborhood near;
  for (const std::size_t i : this->groups_[group])
  {
    const RefinedPoint& point = this->points_[i].point;
    this->tree_.within(point.place, OtherDistance * point.reach, near);
    for (const Index other : near.indices)
    {
      if (this->groupOf_[other] != group)
      {
        others.push_back(&this->points_[other].point);
      }
    }
  }
  return others;
}

std::optional<int> GroupedPoints::otherTotal(std::size_t group, const CriticalScale& scale) const
{
  if (this->isPlain(this->groups_[group]))
  {
    return {};
  }
  PlaceList places;
  for (const std::size_t i : this->groups_[group])
  {
    places.push_back(&this->points_[i].point);
  }
  CriticalModel model(scale);
  return indexAround(model, places, this->othersAround(group));
}

/// Of those that may be chosen, the one of which the least, or the most, is to be seen; or null.
template <class MayBe, class IsBetter>
TypedPoint* choose(
  std::vector<TypedPoint>& points, const Group& group, const MayBe& mayBe, const IsBetter& isBetter)
{
  TypedPoint* best = nullptr;
  for (const std::size_t i : group)
  {
    TypedPoint& point = points[i];
    if (mayBe(point) && (!best || isBetter(strength(point), strength(*best))))
    {
      best = &point;
    }
  }
  return best;
}

void typeByIndex(TypedPoint& point, int index)
{
  point.multiplicity = 1;
  point.type = index < 0                ? CriticalType::Saddle
    : point.point.curvature.sum() > 0.0 ? CriticalType::Minimum
                                        : CriticalType::Maximum;
}

/// Until the indices of a group sum to a total.
void balance(std::vector<TypedPoint>& points, const Group& group, int total)
{
  int sum = 0;
  for (const std::size_t i : group)
  {
    sum += indexOf(points[i]);
  }
  while (sum != total)
  {
    const int missing = sum < total ? 1 : -1;
    TypedPoint* weakest = choose(
      points, group, [=](const TypedPoint& point) { return indexOf(point) == -missing; },
      std::less<>());
    TypedPoint* strongest = choose(
      points, group,
      [=](const TypedPoint& point) { return indexOf(point) == 0 && ownIndex(point) == missing; },
      std::greater<>());
    if (!weakest && !strongest)
    {
      strongest = choose(
        points, group, [](const TypedPoint& point) { return indexOf(point) == 0; },
        std::greater<>());
    }
    if (strongest && (!weakest || isResolved(*strongest)))
    {
      typeByIndex(*strongest, missing);
    }
    else if (weakest)
    {
      weakest->type = CriticalType::Regular;
    }
    else
    {
      return; // a multiple saddle, whose parts are not known
    }
    sum += missing;
  }
}

} // namespace

void balanceIndices(
  std::vector<TypedPoint>& points, const CriticalScale& scale, const Execution& execution)
{
  const GroupedPoints grouped(points);
  const std::vector<Group>& groups = grouped.groups();
  std::vector<std::optional<int>> totals(groups.size());
  parallelForEach(groups.size(), execution,
    [&](std::size_t group, const Poll&) { totals[group] = grouped.otherTotal(group, scale); });
  for (std::size_t group = 0; group < groups.size(); ++group)
  {
    if (totals[group])
    {
      balance(points, groups[group], *totals[group]);
    }
  }
}

} // namespace SurfaceScalars
