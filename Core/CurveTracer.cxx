#include "CurveTracer.h"

#include "CurveJoining.h"
#include "LevelSetWalker.h"
#include "Polyline.h"
#include "SaddleFan.h"
#include "SaddleLoops.h"
#include "SeedCover.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

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
constexpr double SameSaddleDistance = 1.0;
constexpr double FanInfluence = 2.0; // in radii of its circle
constexpr int MostRounds = 8;        // in each of which further saddles are found

/// The saddles of a level.
struct LevelSaddles
{
  std::vector<SaddleFan> known;   ///< whose branches are curves' ends
  std::vector<SaddleFan> found;   ///< while tracing
  std::vector<Vector3d> rejected; ///< saddles of the model that are none of the level
};

/// Follows the curves through starts on a level set until they end.
class Tracer
{
public:
  Tracer(LevelSetWalker& walker, SaddleFinder& finder, const TracingLimits& limits,
    std::size_t seeds, SeedCover& cover, LevelSaddles& saddles, const Poll& poll)
    : walker_(walker)
    , finder_(finder)
    , limits_(limits)
    , mostStations_(200 + 20 * seeds)
    , cover_(cover)
    , saddles_(saddles)
    , poll_(poll)
  {
  }

  TracedCurve trace(const Station& start);
  SaddleArc traceArc(const BranchId& from);

private:
  /// Why it ends, or none if it closed.
  using Ending = std::optional<CurveEnd>;

  Ending extend(std::vector<Station>& path, bool mayClose);
  CurveEnd endAtEdge(std::vector<Station>& path);
  double stepBefore(const std::vector<Station>& path, std::size_t edge) const;
  bool endsAtSaddle(std::vector<Station>& path);
  std::optional<Vector3d> saddleAt(const Saddle& saddle, const Station& station);
  bool entersFan(std::vector<Station>& path, const Station& next);

  LevelSetWalker& walker_;
  SaddleFinder& finder_;
  TracingLimits limits_;
  std::size_t mostStations_;
  SeedCover& cover_; ///< the curves that are there already
  LevelSaddles& saddles_;
  std::optional<BranchId> entered_; ///< by the last curve that ended
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
    if (this->endsAtSaddle(path))
    {
      return CurveEnd::Saddle;
    }
    const std::optional<Station> next = this->walker_.advance(path.back(), step);
    if (!next)
    {
      break;
    }
    if (this->entersFan(path, *next))
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

/// Whether the curve has come to a saddle of the level's value, which then ends it.
bool Tracer::endsAtSaddle(std::vector<Station>& path)
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
  if (const std::optional<Vector3d> end = this->saddleAt(*saddle, station))
  {
    path.push_back(this->walker_.endAt(*end, station));
    return true;
  }
  return false;
}

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

/// The end of a curve at a saddle of the model: none if that is none of the level, or one to be
/// entered along a branch.
std::optional<Vector3d> Tracer::saddleAt(const Saddle& saddle, const Station& station)
{
  LevelSaddles& saddles = this->saddles_;
  if (isAmong(saddles.known, saddle.position, station.step))
  {
    return {};
  }
  std::optional<SaddleFan> fan;
  if (std::none_of(saddles.rejected.begin(), saddles.rejected.end(),
        [&](const Vector3d& place)
        { return (place - saddle.position).norm() <= SameSaddleDistance * station.step; }))
  {
    fan = this->finder_.find(saddle, station);
  }
  if (!fan)
  {
    saddles.rejected.push_back(saddle.position);
    return std::abs(saddle.value - this->walker_.level()) <= CriticalFraction
      ? std::optional<Vector3d>(saddle.position)
      : std::nullopt;
  }
  const Vector3d center = fan->center.point.position;
  if (isAmong(saddles.known, center, station.step))
  {
    return {};
  }
  if (!isAmong(saddles.found, center, station.step))
  {
    saddles.found.push_back(std::move(*fan));
  }
  return center;
}

/// Whether the way to the next station leads into a saddle along one of its branches, or past them
/// among them; the saddle is then the end.
bool Tracer::entersFan(std::vector<Station>& path, const Station& next)
{
  for (const SaddleFan& fan : this->saddles_.known)
  {
    const Vector3d offset = next.point.position - fan.center.point.position;
    const bool isInside = offset.norm() < fan.radius && offset.dot(next.direction) < 0.0;
    double nearest = isInside ? INFINITY : ClosingDistance * next.step;
    std::optional<std::size_t> entered;
    for (std::size_t i = 0; i < fan.branches.size(); ++i)
    {
      const Station& branch = fan.branches[i];
      const double distance =
        distanceToSegment(branch.point.position, path.back().point.position, next.point.position);
      if (next.direction.dot(branch.direction) < -0.5 && distance < nearest)
      {
        nearest = distance;
        entered = i;
      }
    }
    if (entered)
    {
      Station branch = fan.branches[*entered];
      branch.direction = -branch.direction;
      branch.point.normal = -branch.point.normal;
      path.push_back(branch);
      path.push_back(centerBeside(fan, branch));
      this->entered_ =
        BranchId{ static_cast<std::size_t>(&fan - this->saddles_.known.data()), *entered };
      return true;
    }
  }
  return false;
}

SaddleArc Tracer::traceArc(const BranchId& from)
{
  const SaddleFan& fan = this->saddles_.known[from.fan];
  const Station& branch = fan.branches[from.branch];
  std::vector<Station> path{ centerBeside(fan, branch), branch };
  this->entered_.reset();
  const Ending end = this->extend(path, false);
  SaddleArc arc{ end ? joinWays(path, { path.front() }) : loop(path), from, this->entered_ };
  arc.curve.start = CurveEnd::Saddle;
  arc.curve.end = end.value_or(CurveEnd::Lost);
  return arc;
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

/// The curves through saddles. A branch along which tracing fails may yet be entered by an arc that
/// comes from elsewhere.
std::vector<TracedCurve> traceArcs(
  Tracer& tracer, const std::vector<SaddleFan>& fans, SeedCover& cover)
{
  std::vector<SaddleArc> arcs;
  std::vector<SaddleArc> lost;
  std::vector<std::vector<bool>> isTaken;
  for (const SaddleFan& fan : fans)
  {
    isTaken.emplace_back(fan.branches.size(), false);
  }
  const auto take = [&](SaddleArc&& arc)
  {
    cover.pass(arc.curve);
    isTaken[arc.from.fan][arc.from.branch] = true;
    if (arc.to && isTaken[arc.to->fan][arc.to->branch])
    {
      arc.to.reset(); // another curve ends there
    }
    if (arc.to)
    {
      isTaken[arc.to->fan][arc.to->branch] = true;
    }
    arcs.push_back(std::move(arc));
  };
  for (std::size_t fan = 0; fan < fans.size(); ++fan)
  {
    for (std::size_t branch = 0; branch < fans[fan].branches.size(); ++branch)
    {
      if (!isTaken[fan][branch])
      {
        SaddleArc arc = tracer.traceArc({ fan, branch });
        arc.curve.end == CurveEnd::Lost ? lost.push_back(std::move(arc)) : take(std::move(arc));
      }
    }
  }
  for (SaddleArc& arc : lost)
  {
    if (!isTaken[arc.from.fan][arc.from.branch])
    {
      take(std::move(arc));
    }
  }
  return joinArcs(fans, arcs);
}

void traceSeeds(Tracer& tracer, LevelSetWalker& walker, const std::vector<LevelSetPoint>& seeds,
  SeedCover& cover, const Poll& poll, std::vector<TracedCurve>& curves)
{
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
}

} // namespace

std::vector<TracedCurve> traceCurves(LevelSetModel& model, const SampledFunction& function,
  double level, const std::vector<LevelSetPoint>& seeds, const TracingLimits& limits,
  const Poll& poll)
{
  LevelSetWalker walker(model, function, level, limits);
  SaddleFinder finder(model, walker, function, level, poll);
  LevelSaddles saddles;
  std::vector<TracedCurve> curves;
  for (int round = 0; round < MostRounds; ++round)
  {
    SeedCover cover(seeds);
    Tracer tracer(walker, finder, limits, seeds.size(), cover, saddles, poll);
    curves = traceArcs(tracer, saddles.known, cover);
    traceSeeds(tracer, walker, seeds, cover, poll, curves);
    if (saddles.found.empty())
    {
      break;
    }
    // Again, from the saddles.
    std::move(saddles.found.begin(), saddles.found.end(), std::back_inserter(saddles.known));
    saddles.found.clear();
  }
  return joinEnds(std::move(curves));
}

} // namespace SurfaceScalars
