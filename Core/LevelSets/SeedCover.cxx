#include "SeedCover.h"

#include "Polyline.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// In widened sampling steps.
constexpr double PassedDistance = 0.75;
constexpr double PassedBeyondEnd = 2.5;
constexpr double SmallestAlignment = 0.8; // cosine

} // namespace

SeedCover::SeedCover(const std::vector<LevelSetPoint>& seeds)
  : positions_(positionsOf(seeds))
  , tree_(this->positions_)
  , passedBy_(seeds.size(), None)
{
}

void SeedCover::passAlong(const Segment& segment, double distance, std::size_t by)
{
  const Vector3d along = segment.to - segment.from;
  this->tree_.within(segment.from + 0.5 * along, 0.5 * along.norm() + distance, this->near_);
  for (const Index seed : this->near_.indices)
  {
    const bool close =
      distanceToSegment(this->positions_.col(seed), segment.from, segment.to) <= distance;
    if (close && (by != PastEnd || !this->isPassed(seed)))
    {
      this->passedBy_[seed] = by;
    }
  }
}

void SeedCover::pass(const TracedCurve& curve)
{
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
  {
    const Segment segment{ curve.points[i].position, curve.points[(i + 1) % count].position };
    this->passAlong(segment, PassedDistance * curve.steps[i], this->segments_.size());
    this->segments_.push_back(segment);
  }
  const auto passBeyond = [&](std::size_t end, double direction)
  {
    const Vector3d& position = curve.points[end].position;
    const double step = curve.steps[end];
    const Vector3d along = direction * PassedBeyondEnd * step * curve.tangents[end];
    this->passAlong({ position, position + along }, step, PastEnd);
  };
  if (!curve.closed && curve.start != CurveEnd::Saddle)
  {
    passBeyond(0, -1.0);
  }
  if (!curve.closed && curve.end != CurveEnd::Saddle)
  {
    passBeyond(count - 1, 1.0);
  }
}

bool SeedCover::isOnCurve(const Vector3d& place, double distance, const Vector3d& direction)
{
  const auto runsAlong = [&](const Segment& segment)
  {
    const Vector3d along = segment.to - segment.from;
    return direction.isZero() || std::abs(along.dot(direction)) > SmallestAlignment * along.norm();
  };
  this->tree_.within(place, 2.0 * distance, this->near_);
  for (const Index seed : this->near_.indices)
  {
    const std::size_t passed = this->passedBy_[seed];
    if (passed == None || passed == PastEnd)
    {
      continue;
    }
    // The curve may have come closer to the place before or after it passed the seed.
    const std::size_t around = 4;
    const std::size_t end = std::min(passed + around + 1, this->segments_.size());
    for (std::size_t i = passed - std::min(passed, around); i < end; ++i)
    {
      const Segment& segment = this->segments_[i];
      if (distanceToSegment(place, segment.from, segment.to) <= distance && runsAlong(segment))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace SurfaceScalars
