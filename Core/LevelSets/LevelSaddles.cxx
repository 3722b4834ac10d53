#include "LevelSaddles.h"

#include "Polyline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double SameSaddleDistance = 1.0; // in widened sampling steps
constexpr double FanInfluence = 2.0;       // in radii of its circle
constexpr double EntryDistance = 0.5;      // from the beginning of a branch, in such steps

/// Whether a saddle of the model is one of these: a degenerate one has others around it.
bool isAmong(const std::vector<SaddleFan>& fans, const Vector3d& saddle, double step)
{
  return std::any_of(fans.begin(), fans.end(),
    [&](const SaddleFan& fan)
    {
      return (fan.center.point.position - saddle).norm() <=
        std::max(SameSaddleDistance * step, FanInfluence * fan.radius);
    });
}

} // namespace

std::optional<Vector3d> LevelSaddles::endAt(const Saddle& saddle, const Station& station)
{
  if (isAmong(this->known_, saddle.position, station.step))
  {
    return {};
  }
  std::optional<SaddleFan> fan;
  if (std::none_of(this->rejected_.begin(), this->rejected_.end(),
        [&](const Vector3d& place)
        { return (place - saddle.position).norm() <= SameSaddleDistance * station.step; }))
  {
    fan = this->finder_.find(saddle, station);
  }
  if (!fan)
  {
    this->rejected_.push_back(saddle.position);
    return std::abs(saddle.value - this->level_) <= CriticalFraction
      ? std::optional<Vector3d>(saddle.position)
      : std::nullopt;
  }
  const Vector3d center = fan->center.point.position;
  if (isAmong(this->known_, center, station.step))
  {
    return {};
  }
  if (!isAmong(this->found_, center, station.step))
  {
    this->found_.push_back(std::move(*fan));
  }
  return center;
}

std::optional<BranchId> LevelSaddles::entered(const Station& from, const Station& next) const
{
  for (std::size_t k = 0; k < this->known_.size(); ++k)
  {
    const SaddleFan& fan = this->known_[k];
    const Vector3d offset = next.point.position - fan.center.point.position;
    const bool isInside = offset.norm() < fan.radius && offset.dot(next.direction) < 0.0;
    double nearest = isInside ? INFINITY : EntryDistance * next.step;
    std::optional<BranchId> entered;
    for (std::size_t i = 0; i < fan.branches.size(); ++i)
    {
      const Station& branch = fan.branches[i];
      const double distance =
        distanceToSegment(branch.point.position, from.point.position, next.point.position);
      if (next.direction.dot(branch.direction) < -0.5 && distance < nearest)
      {
        nearest = distance;
        entered = BranchId{ k, i };
      }
    }
    if (entered)
    {
      return entered;
    }
  }
  return {};
}

bool LevelSaddles::learn()
{
  const bool any = !this->found_.empty();
  std::move(this->found_.begin(), this->found_.end(), std::back_inserter(this->known_));
  this->found_.clear();
  return any;
}

} // namespace SurfaceScalars
