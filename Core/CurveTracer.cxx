#include "CurveTracer.h"

#include "CurveJoining.h"
#include "LevelSetWalker.h"
#include "Polyline.h"
#include "SeedCover.h"

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
constexpr double ShortestCurve = 1.0;

/// Follows the curves through starts on a level set until they end.
class Tracer
{
public:
  Tracer(LevelSetWalker& walker, const TracingLimits& limits, std::size_t seeds, SeedCover& cover,
    const Poll& poll)
    : walker_(walker)
    , limits_(limits)
    , mostStations_(200 + 20 * seeds)
    , cover_(cover)
    , poll_(poll)
  {
  }

  TracedCurve trace(const Station& start);

private:
  /// Why it ends, or none if it closed.
  using Ending = std::optional<CurveEnd>;

  Ending extend(std::vector<Station>& path, bool mayClose);
  CurveEnd endAtEdge(std::vector<Station>& path);
  double stepBefore(const std::vector<Station>& path, std::size_t edge) const;

  LevelSetWalker& walker_;
  TracingLimits limits_;
  std::size_t mostStations_;
  SeedCover& cover_; ///< the curves that are there already
  const Poll& poll_;
};

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

TracedCurve loop(const std::vector<Station>& path)
{
  TracedCurve curve = joinWays(path, { path.front() });
  curve.closed = true;
  return curve;
}

/// Follows the direction of the last station. @returns none if the curve came back to the first
Tracer::Ending Tracer::extend(std::vector<Station>& path, bool mayClose)
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
    if (const std::optional<Station> saddle = this->walker_.saddleAhead(path.back()))
    {
      path.push_back(*saddle);
      return CurveEnd::Saddle;
    }
    const std::optional<Station> next = this->walker_.advance(path.back(), step);
    if (!next)
    {
      break;
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
double Tracer::stepBefore(const std::vector<Station>& path, std::size_t edge) const
{
  return this->walker_.samplingStep(path[edge - std::min(edge, StationsBefore)]);
}

CurveEnd Tracer::endAtEdge(std::vector<Station>& path)
{
  if (const std::optional<Station> last = this->walker_.extension(path.back()))
  {
    path.push_back(*last);
  }
  return CurveEnd::Edge;
}

TracedCurve Tracer::trace(const Station& start)
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

} // namespace

std::vector<TracedCurve> traceCurves(LevelSetModel& model, const SampledFunction& function,
  double level, const std::vector<LevelSetPoint>& seeds, const TracingLimits& limits,
  const Poll& poll)
{
  std::vector<TracedCurve> curves;
  SeedCover cover(seeds);
  LevelSetWalker walker(model, function, level, limits);
  Tracer tracer(walker, limits, seeds.size(), cover, poll);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    poll();
    if (cover.isPassed(i))
    {
      continue;
    }
    const std::optional<Station> start = walker.start(seeds[i]);
    if (!start ||
      cover.isOnCurve(start->point.position, OnCurveDistance * start->step, Vector3d::Zero()))
    {
      continue; // a seed that fails is not tried again
    }
    TracedCurve curve = tracer.trace(*start);
    if (curve.points.size() >= (curve.closed ? 3 : 2) &&
      polylineLength(curve.points, curve.closed) >= ShortestCurve * start->step)
    {
      cover.pass(curve);
      curves.push_back(std::move(curve));
    }
  }
  return joinEnds(std::move(curves));
}

} // namespace SurfaceScalars
