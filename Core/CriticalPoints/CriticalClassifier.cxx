#include "CriticalClassifier.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// In radii of the fits.
constexpr double LargestSplit = 2.5; // from the middle of what one point is split into
constexpr double FirstRing = 1.0;
constexpr double LargestRing = 2.0; // to begin with
constexpr double Widening = 1.35;   // from ring to ring
constexpr int Rings = 4;

/// A ring around places that one point may be split into.
Ring ringAround(const std::vector<RefinedPoint>& points, const std::vector<std::size_t>& group)
{
  Ring ring{ Vector3d::Zero(), Vector3d::Zero(), 0.0 };
  for (const std::size_t i : group)
  {
    const Vector3d& normal = points[i].normal;
    ring.center += points[i].place / static_cast<double>(group.size());
    ring.normal += ring.normal.dot(normal) < 0.0 ? Vector3d(-normal) : normal;
  }
  ring.normal.normalize();
  for (const std::size_t i : group)
  {
    ring.radius = std::max(ring.radius, (points[i].place - ring.center).norm());
  }
  return ring;
}

} // namespace

/// Those whose Hessians tell a type. If they tell of a ridge or a valley only, one uncertain point
/// stands for it.
std::vector<TypedPoint> CriticalClassifier::byHessian(const std::vector<std::size_t>& group) const
{
  std::vector<TypedPoint> result;
  const RefinedPoint* uncertain = nullptr;
  for (const std::size_t i : group)
  {
    const RefinedPoint& point = this->points_[i];
    if (this->trust_.isLikely(point))
    {
      result.push_back({ point, typeOf(point), 1, 0.0 });
    }
    else if (this->trust_.isCurved(point) &&
      (!uncertain || point.significance[1] > uncertain->significance[1]))
    {
      uncertain = &point;
    }
  }
  if (result.empty() && uncertain && !this->sure_.isAnyWithin(uncertain->place, uncertain->reach))
  {
    result.push_back({ *uncertain, CriticalType::Uncertain, 1, 0.0 });
  }
  return result;
}

/// Wider and wider, until two rings agree.
std::optional<CriticalClassifier::Enclosed> CriticalClassifier::countAround(
  const std::vector<std::size_t>& group)
{
  const double reach = this->points_[group.front()].reach;
  Ring ring = ringAround(this->points_, group);
  if (ring.radius > LargestSplit * reach)
  {
    return {};
  }
  ring.radius = std::clamp(ring.radius + 0.5 * reach, FirstRing * reach, LargestRing * reach);
  std::optional<RingCount> last;
  for (int i = 0; i < Rings; ++i, ring.radius *= Widening)
  {
    Ring centered = ring;
    std::optional<RingCount> count;
    if (centerRing(this->model_, centered) &&
      !this->sure_.isAnyWithin(centered.center, centered.radius))
    {
      count = SurfaceScalars::countAround(this->model_, centered);
    }
    if (count && last && count->changes == last->changes && count->sign == last->sign)
    {
      return Enclosed{ centered, *count };
    }
    last = count;
  }
  return {};
}

std::vector<TypedPoint> CriticalClassifier::byRing(
  const std::vector<std::size_t>& group, const Enclosed& enclosed)
{
  const int changes = enclosed.count.changes;
  if (changes == 2)
  {
    return {};
  }
  std::optional<RefinedPoint> point = changes > 4
    ? describePlace(this->model_, enclosed.ring.center)
    : this->mostCentral(group, enclosed);
  if (!point)
  {
    return {};
  }
  if (changes > 4)
  {
    point->enclosed = {}; // those of a part
  }
  const CriticalType extremum =
    enclosed.count.sign > 0 ? CriticalType::Minimum : CriticalType::Maximum;
  return { { *point, changes == 0 ? extremum : CriticalType::Saddle, std::max(1, changes / 2 - 1),
    enclosed.ring.radius } };
}

/// The settled point closest to the center of a ring, if any is inside.
std::optional<RefinedPoint> CriticalClassifier::mostCentral(
  const std::vector<std::size_t>& group, const Enclosed& enclosed) const
{
  const auto distance = [&](const RefinedPoint& point)
  { return (point.place - enclosed.ring.center).norm(); };
  std::optional<RefinedPoint> result;
  for (const std::size_t i : group)
  {
    const RefinedPoint& point = this->points_[i];
    if (point.isSettled && distance(point) < (result ? distance(*result) : enclosed.ring.radius))
    {
      result = point;
    }
  }
  return result;
}

std::vector<TypedPoint> CriticalClassifier::classify(const std::vector<std::size_t>& group)
{
  const RefinedPoint& first = this->points_[group.front()];
  if (this->trust_.isSure(first)) // then it is alone
  {
    return this->byHessian(group);
  }
  const auto isSeen = [&](std::size_t i) { return this->trust_.isSeen(this->points_[i]); };
  if (std::none_of(group.begin(), group.end(), isSeen))
  {
    return {};
  }
  const std::optional<Enclosed> enclosed = this->countAround(group);
  return enclosed ? this->byRing(group, *enclosed) : this->byHessian(group);
}

} // namespace SurfaceScalars
