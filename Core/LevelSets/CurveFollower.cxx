#include "CurveFollower.h"

#include "Polyline.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// Lengths are in widened sampling steps.
constexpr double FirstStep = 0.5;
constexpr double ClosingDistance = 0.5;
constexpr double ShortestLoop = 2.5;
constexpr double ShortestWinding = 4.0;
constexpr std::size_t WindingCheck =
  64; // stations between checks whether a curve runs along itself
constexpr double OnCurveDistance = 0.75;
constexpr double DoubledLength =
  1.5; // along another curve, closer than OnCurveDistance: it is that one
constexpr std::size_t StationsBefore =
  6; // an edge, where the sampling step is not yet under its influence
constexpr double EndPrecision = 0.1;

/// Whether the way from the last station to the next passes the first.
bool closes(const std::vector<Station>& path, const Station& next, double length)
{
  const Station& start = path.front();
  return length > ShortestLoop * next.step && next.direction.dot(start.direction) > 0.5 &&
    distanceToSegment(start.point.position, path.back().point.position, next.point.position) <
    ClosingDistance * next.step;
}

/// Index of the first segment that a station runs along the same way, among those that end a while
/// before it; or none.
std::optional<std::size_t> woundOnto(const std::vector<Station>& path, std::size_t station)
{
  const Station& here = path[station];
  double length = 0.0;
  std::size_t last = station;
  for (; last > 0 && length < ShortestWinding * here.step; --last)
  {
    length += (path[last].point.position - path[last - 1].point.position).norm();
  }
  for (std::size_t i = 0; i < last; ++i)
  {
    if (here.direction.dot(path[i].direction) > 0.8 &&
      distanceToSegment(here.point.position, path[i].point.position, path[i + 1].point.position) <
        ClosingDistance * here.step)
    {
      return i + 1;
    }
  }
  return {};
}

/// A trace that noise led past its start runs round and round: if it does, keeps one round.
bool closeWinding(std::vector<Station>& path)
{
  if (!woundOnto(path, path.size() - 1))
  {
    return false;
  }
  std::size_t end = path.size() - 1;
  std::optional<std::size_t> begin = woundOnto(path, end);
  // Back to where the second round began.
  while (end > 0)
  {
    const std::optional<std::size_t> before = woundOnto(path, end - 1);
    if (!before)
    {
      break;
    }
    begin = before;
    --end;
  }
  path.assign(path.begin() + static_cast<std::ptrdiff_t>(*begin),
    path.begin() + static_cast<std::ptrdiff_t>(end));
  return path.size() >= 3;
}

/// One curve of the stations reached from a start in its direction and against it.
TracedCurve joinWays(const std::vector<Station>& forward, const std::vector<Station>& backward)
{
  TracedCurve curve;
  for (auto station = backward.rbegin(); station + 1 < backward.rend(); ++station)
  {
    curve.points.push_back(station->point);
    curve.points.back().normal =
      -station->point.normal; // it was kept on the other side of the direction
    curve.tangents.emplace_back(-station->direction);
    curve.steps.push_back(station->step);
  }
  for (const Station& station : forward)
  {
    curve.points.push_back(station.point);
    curve.tangents.push_back(station.direction);
    curve.steps.push_back(station.step);
  }
  return curve;
}

/// The center of a saddle as a station of a curve that passes one of its branches.
Station centerBeside(const SaddleFan& fan, const Station& branch)
{
  Station center = fan.center;
  if (center.point.normal.dot(branch.point.normal) < 0.0)
  {
    center.point.normal = -center.point.normal;
  }
  center.direction = branch.direction;
  center.step = branch.step;
  return center;
}

TracedCurve loop(const std::vector<Station>& path)
{
  TracedCurve curve = joinWays(path, { path.front() });
  curve.closed = true;
  return curve;
}

} // namespace

/// Follows the direction of the last station. @returns none if the curve came back to the first
CurveFollower::Ending CurveFollower::extend(std::vector<Station>& path, bool mayClose)
{
  double step = FirstStep * path.back().step;
  double length = 0.0;
  double gap = 0.0;     // from the last sample passed
  double doubled = 0.0; // length along another curve
  std::size_t lastSupported = path.size();
  std::size_t lastAlone = path.size();
  for (std::size_t i = 0; i < this->mostStations_; ++i)
  {
    this->poll_();
    if (this->endsAtSaddle(path))
    {
      return CurveEnd::Saddle;
    }
    const std::optional<Station> next = this->walker_.advance(path.back(), step);
    if (!next)
    {
      break;
    }
    if (this->entersSaddle(path, *next))
    {
      return CurveEnd::Saddle;
    }
    const double chord = (next->point.position - path.back().point.position).norm();
    if (!next->supported && path.back().supported && chord > EndPrecision * next->step)
    {
      step = 0.5 * chord; // find the place where the surface ends
      continue;
    }
    gap = (path.back().supported ? path.back().nearest : gap) + chord;
    if ((!next->supported || !path.back().supported) &&
      gap + next->nearest > this->limits_.linkDistance * this->stepBefore(path, lastSupported))
    {
      path.resize(lastSupported, path.front());
      return this->endAtEdge(path);
    }
    length += chord;
    if (mayClose && closes(path, *next, length))
    {
      return {};
    }
    path.push_back(*next);
    if (path.size() % WindingCheck == 0 && closeWinding(path))
    {
      return {};
    }
    lastSupported = next->supported ? path.size() : lastSupported;
    const bool onCurve =
      this->cover_.isOnCurve(next->point.position, OnCurveDistance * next->step, next->direction);
    doubled = onCurve && lastAlone + 1 < path.size() ? doubled + chord : 0.0;
    lastAlone = onCurve ? lastAlone : path.size();
    if (doubled > DoubledLength * next->step)
    {
      lastSupported = std::min(lastSupported, lastAlone);
      break;
    }
  }
  path.resize(lastSupported, path.front());
  return CurveEnd::Lost;
}

/// The sampling step some way before an edge: at the edge itself samples seem farther apart.
double CurveFollower::stepBefore(const std::vector<Station>& path, std::size_t edge) const
{
  return this->walker_.samplingStep(path[edge - std::min(edge, StationsBefore)]);
}

CurveEnd CurveFollower::endAtEdge(std::vector<Station>& path)
{
  if (const std::optional<Station> last = this->walker_.extension(path.back()))
  {
    path.push_back(*last);
  }
  return CurveEnd::Edge;
}

/// Whether the curve has come to a saddle of the level's value, which then ends it.
bool CurveFollower::endsAtSaddle(std::vector<Station>& path)
{
  const Station station = path.back();
  const std::optional<Saddle> saddle = this->walker_.saddleNear(station);
  if (!saddle)
  {
    return false;
  }
  const Vector3d way = saddle->position - station.point.position;
  if (way.dot(station.direction) < 0.5 * way.norm())
  {
    return false;
  }
  if (const std::optional<Vector3d> end = this->saddles_.endAt(*saddle, station))
  {
    path.push_back(this->walker_.endAt(*end, station));
    return true;
  }
  return false;
}

/// Whether the way to the next station leads into a known saddle, which is then the end.
bool CurveFollower::entersSaddle(std::vector<Station>& path, const Station& next)
{
  this->entered_ = this->saddles_.entered(path.back(), next);
  if (!this->entered_)
  {
    return false;
  }
  const SaddleFan& fan = this->saddles_.known()[this->entered_->fan];
  Station branch = fan.branches[this->entered_->branch];
  branch.direction = -branch.direction;
  branch.point.normal = -branch.point.normal;
  path.push_back(branch);
  path.push_back(centerBeside(fan, branch));
  return true;
}

SaddleArc CurveFollower::traceArc(const BranchId& from)
{
  const SaddleFan& fan = this->saddles_.known()[from.fan];
  const Station& branch = fan.branches[from.branch];
  std::vector<Station> path{ centerBeside(fan, branch), branch };
  this->entered_.reset();
  const Ending end = this->extend(path, false);
  SaddleArc arc{ end ? joinWays(path, { path.front() }) : loop(path), from, this->entered_ };
  arc.curve.start = CurveEnd::Saddle;
  arc.curve.end = end.value_or(CurveEnd::Lost);
  return arc;
}

TracedCurve CurveFollower::trace(const Station& start)
{
  std::vector<Station> forward{ start };
  const Ending end = this->extend(forward, true);
  if (!end)
  {
    return loop(forward);
  }
  std::vector<Station> backward{ start };
  backward.front().direction = -start.direction;
  backward.front().point.normal = -start.point.normal; // larger values stay to the left
  const Ending beginning = this->extend(backward, false);
  if (!beginning)
  {
    return loop(backward);
  }
  TracedCurve curve = joinWays(forward, backward);
  curve.start = *beginning;
  curve.end = *end;
  // Both ends at one saddle: a loop through it.
  curve.closed = curve.start == CurveEnd::Saddle && curve.end == CurveEnd::Saddle &&
    curve.points.size() > 3 &&
    (curve.points.front().position - curve.points.back().position).norm() <=
      10.0 * this->limits_.tolerance;
  if (curve.closed)
  {
    curve.points.pop_back();
    curve.tangents.pop_back();
    curve.steps.pop_back();
  }
  return curve;
}

} // namespace SurfaceScalars
