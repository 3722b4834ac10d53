#include "CurveScore.h"

#include "PointSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars::Truth
{
namespace
{

struct Segment
{
  Vector3d from;
  Vector3d to;

  double distance(const Vector3d& place) const
  {
    const Vector3d direction = this->to - this->from;
    const double squaredLength = direction.squaredNorm();
    const double along =
      squaredLength > 0.0 ? (place - this->from).dot(direction) / squaredLength : 0.0;
    return (place - this->from - std::clamp(along, 0.0, 1.0) * direction).norm();
  }
};

/// All pieces of the curves, none longer than the mean so that a search around their centers stays
/// local.
class Polylines
{
public:
  Polylines(const std::vector<const LevelSetCurve*>& curves)
  {
    std::vector<Segment> whole;
    double length = 0.0;
    for (const LevelSetCurve* curve : curves)
    {
      const std::size_t count = curve->points.size();
      for (std::size_t i = 0; i + (curve->closed ? 0 : 1) < count; ++i)
      {
        whole.push_back({ curve->points[i].position, curve->points[(i + 1) % count].position });
        length += (whole.back().to - whole.back().from).norm();
      }
    }
    const double longest = whole.empty() ? 0.0 : length / static_cast<double>(whole.size());
    this->halfLength_ = 0.5 * longest;
    for (const Segment& segment : whole)
    {
      const Vector3d direction = segment.to - segment.from;
      const int pieces =
        longest > 0.0 ? std::max(1, static_cast<int>(std::ceil(direction.norm() / longest))) : 1;
      for (int i = 0; i < pieces; ++i)
      {
        this->segments_.push_back(
          { segment.from + direction * i / pieces, segment.from + direction * (i + 1) / pieces });
        this->centers_.push_back(0.5 * (this->segments_.back().from + this->segments_.back().to));
      }
    }
  }

  bool isEmpty() const { return this->segments_.empty(); }
  const std::vector<Vector3d>& centers() const { return this->centers_; }

  double distance(const Vector3d& place, const PointSearch& search) const
  {
    double best = this->segments_[search.nearest(place).first].distance(place);
    for (const std::size_t i : search.within(place, (best + this->halfLength_) * (1.0 + 1e-9)))
    {
      best = std::min(best, this->segments_[i].distance(place));
    }
    return best;
  }

private:
  std::vector<Segment> segments_;
  std::vector<Vector3d> centers_;
  double halfLength_ = 0.0;
};

double distanceToExact(const Vector3d& place, const SpaceFunction& function,
  const ExactLevelSet& exact, const PointSearch& search)
{
  const double sampled = search.nearest(place).second;
  Vector3d foot = place;
  if (!projectOntoLevelSet(function, exact.isoValue, foot))
  {
    return sampled;
  }
  return std::min(sampled, (foot - place).norm());
}

} // namespace

double CurveScore::pointMean() const
{
  return this->pointCount > 0 ? this->pointSum / static_cast<double>(this->pointCount) : 0.0;
}

void CurveScore::add(const CurveScore& other)
{
  this->pointCount += other.pointCount;
  this->pointSum += other.pointSum;
  this->pointMaximum = std::max(this->pointMaximum, other.pointMaximum);
  this->exactMaximum = std::max(this->exactMaximum, other.exactMaximum);
  this->exactInnerMaximum = std::max(this->exactInnerMaximum, other.exactInnerMaximum);
}

double largestDistance(
  const std::vector<Vector3d>& places, const std::vector<const LevelSetCurve*>& curves)
{
  const Polylines polylines(curves);
  if (polylines.isEmpty())
  {
    return std::numeric_limits<double>::infinity();
  }
  const PointSearch search(polylines.centers());
  double largest = 0.0;
  for (const Vector3d& place : places)
  {
    largest = std::max(largest, polylines.distance(place, search));
  }
  return largest;
}

CurveScore scoreCurves(const std::vector<const LevelSetCurve*>& curves,
  const SpaceFunction& function, const ExactLevelSet& exact, double boundaryMargin)
{
  CurveScore score;
  const PointSearch search(exact.points);
  for (const LevelSetCurve* curve : curves)
  {
    for (const LevelSetPoint& point : curve->points)
    {
      const double distance = distanceToExact(point.position, function, exact, search);
      ++score.pointCount;
      score.pointSum += distance;
      score.pointMaximum = std::max(score.pointMaximum, distance);
    }
  }
  std::vector<Vector3d> inner;
  std::copy_if(exact.points.begin(), exact.points.end(), std::back_inserter(inner),
    [=](const Vector3d& place)
    { return boundaryMargin <= 0.0 || distanceFromCut(place) >= boundaryMargin; });
  score.exactMaximum = largestDistance(exact.points, curves);
  score.exactInnerMaximum = inner.empty() ? 0.0 : largestDistance(inner, curves);
  return score;
}

} // namespace SurfaceScalars::Truth
