#include "CurveTracer.h"

#include "CurveFollower.h"
#include "CurveJoining.h"
#include "Polyline.h"

#include <utility>

namespace SurfaceScalars
{
namespace
{

// Lengths are in widened sampling steps.
constexpr double OnCurveDistance = 0.75;
constexpr double ShortestCurve = 1.0;
constexpr int MostRounds = 8; // in each of which further saddles are found

/// The curves through saddles. A branch along which tracing fails may yet be entered by an arc that
/// comes from elsewhere.
std::vector<TracedCurve> traceArcs(
  CurveFollower& follower, const std::vector<SaddleFan>& fans, SeedCover& cover)
{
  std::vector<SaddleArc> arcs;
  std::vector<SaddleArc> lost;
  std::vector<std::vector<bool>> isTaken;
  isTaken.reserve(fans.size());
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
        SaddleArc arc = follower.traceArc({ fan, branch });
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

void traceSeeds(CurveFollower& follower, LevelSetWalker& walker,
  const std::vector<LevelSetPoint>& seeds, SeedCover& cover, const Poll& poll,
  std::vector<TracedCurve>& curves)
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
    TracedCurve curve = follower.trace(*start);
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
  LevelSaddles saddles(finder, level);
  std::vector<TracedCurve> curves;
  for (int round = 0; round < MostRounds; ++round)
  {
    SeedCover cover(seeds);
    CurveFollower follower(walker, limits, seeds.size(), cover, saddles, poll);
    curves = traceArcs(follower, saddles.known(), cover);
    traceSeeds(follower, walker, seeds, cover, poll, curves);
    if (!saddles.learn())
    {
      break;
    }
    // Again, from the saddles.
  }
  return joinEnds(std::move(curves));
}

} // namespace SurfaceScalars
