#include "SeedCover.h"

#include "Polyline.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

// In widened sampling steps.
constexpr double PassedDistance = 0.75;
constexpr double PassedBeyondEnd = 2.5;

} // namespace

SeedCover::SeedCover(const std::vector<LevelSetPoint>& seeds)
  : positions_(positionsOf(seeds))
  , tree_(this->positions_)
  , passedBy_(seeds.size(), None)
{
}

void SeedCover::passSegment(const Vector3d& from, const Vector3d& to, double distance)
{
  this->tree_.within(0.5 * (from + to), 0.5 * (to - from).norm() + distance, this->near_);
  for (const Index seed : this->near_.indices)
  {
    if (distanceToSegment(this->positions_.col(seed), from, to) <= distance)
    {
      this->passedBy_[seed] = this->segments_.size();
    }
  }
  this->segments_.push_back({ from, to });
}

void SeedCover::pass(const TracedCurve& curve)
{
  const std::size_t count = curve.points.size();
  const auto beyond = [&](std::size_t end, double direction)
  {
    const Vector3d& position = curve.points[end].position;
    const double step = curve.steps[end];
    this->passSegment(
      position, position + direction * PassedBeyondEnd * step * curve.tangents[end], step);
  };
  if (!curve.closed)
  {
    beyond(0, -1.0);
  }
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
  {
    this->passSegment(curve.points[i].position, curve.points[(i + 1) % count].position,
      PassedDistance * curve.steps[i]);
  }
  if (!curve.closed)
  {
    beyond(count - 1, 1.0);
  }
}

bool SeedCover::isOnCurve(const Vector3d& place, double distance)
{
  this->tree_.within(place, 2.0 * distance, this->near_);
  for (const Index seed : this->near_.indices)
  {
    if (!this->isPassed(seed))
    {
      continue;
    }
    // The curve may have come closer to the place before or after it passed the seed.
    const std::size_t around = 4;
    const std::size_t passed = this->passedBy_[seed];
    const std::size_t end = std::min(passed + around + 1, this->segments_.size());
    for (std::size_t i = passed - std::min(passed, around); i < end; ++i)
    {
      if (distanceToSegment(place, this->segments_[i].from, this->segments_[i].to) <= distance)
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace SurfaceScalars
