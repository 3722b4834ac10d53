#include "MergeSweep.h"
#include "SaddlePersistence.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double TouchRadius = 2.5; // in sampling steps: what lies within is at a critical point
constexpr double TouchShare = 0.5;  // and within this part of the reach of the fits
constexpr double PairRadius = 10.0; // of extrema and saddles between which the graph has no barrier
constexpr std::size_t SaddleBlocks = 8; // at most
constexpr std::size_t NearSamples = 6;  // whose values tell what the sampling can resolve

CriticalPlace placeOf(
  const CriticalPoint& point, const NeighborGraph& graph, const ValuesRef& values, double reach)
{
  const Vector3d position = point.position - graph.origin();
  const double step = graph.samplingStep(graph.pointOfInput(point.input));
  const double radius = std::max(TouchRadius, TouchShare * reach) * step;
  Neighborhood around;
  graph.within(position, radius, around);
  if (around.indices.size() < NearSamples)
  {
    graph.nearest(position, NearSamples, around);
  }
  double resolution = 0.0;
  const std::size_t near = std::min(NearSamples, around.indices.size());
  for (std::size_t i = 0; i < near; ++i)
  {
    resolution += std::abs(values[around.indices[i]] - point.value) / static_cast<double>(near);
  }
  return { std::move(around.indices), step, radius, resolution };
}

/// An extremum in the basin of another, and a saddle left over: the two of a pair that the samples
/// do not tell apart.
void pairHidden(CriticalPairing& all)
{
  for (const std::size_t extremum : all.hidden)
  {
    const CriticalPoint& point = all.points[extremum];
    const double sign = point.type == CriticalType::Minimum ? 1.0 : -1.0;
    std::size_t best = NoPoint;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < all.points.size(); ++i)
    {
      const double rise = sign * (all.points[i].value - point.value);
      if (all.isSaddle(i) && all.freeCount[i] > 0 && rise >= 0.0 && rise < least &&
        (all.points[i].position - point.position).norm() <= PairRadius * all.places[i].step)
      {
        best = i;
        least = rise;
      }
    }
    all.points[extremum].persistence = 0.0;
    if (best != NoPoint)
    {
      all.pair(extremum, best);
    }
  }
}

/// Saddles that are in too few pairs and join nothing else that the samples show.
std::vector<std::size_t> openSaddles(const CriticalPairing& all)
{
  std::vector<std::size_t> saddles;
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    if (all.freeCount[i] > 0 && all.seen[i] < LeastResolutions * all.places[i].resolution)
    {
      saddles.push_back(i);
    }
  }
  return saddles;
}

/// What loops tell of saddles that nothing else tells of: handles have the range.
void followLoops(CriticalPairing& all, double range, const Execution& execution)
{
  const std::vector<std::size_t> saddles = openSaddles(all);
  parallelFor(saddles.size(), 1 + saddles.size() / SaddleBlocks, execution,
    [&](std::size_t begin, std::size_t end)
    {
      SaddlePersistence loops(all.graph, all.values);
      for (std::size_t i = begin; i < end; ++i)
      {
        const CriticalPoint& saddle = all.points[saddles[i]];
        const Vector3d place = saddle.position - all.graph.origin();
        const double radius = all.places[saddles[i]].radius;
        all.note(saddles[i], std::min(range, loops.measure(place, saddle.value, radius)));
      }
    });
}

/// Saddles and uncertain points, once all pairs are known.
void concludePersistence(CriticalPairing& all)
{
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    const CriticalType type = all.points[i].type;
    if (type != CriticalType::Minimum && type != CriticalType::Maximum)
    {
      all.points[i].persistence = all.seen[i];
    }
  }
  for (const CriticalPair& pair : all.pairs)
  {
    double& persistence = all.points[pair.saddle].persistence;
    persistence = std::max(persistence, pair.persistence);
  }
}

} // namespace

std::vector<CriticalPair> assignPersistence(std::vector<CriticalPoint>& points,
  const NeighborGraph& graph, const ValuesRef& values, double reach, const Execution& execution)
{
  const MergeTrees trees = graphMergeTrees(graph, values, execution.part(0.0, 0.9));
  const double range = values.maxCoeff() - values.minCoeff();
  CriticalPairing all{ points, graph, values };
  for (const CriticalPoint& point : points)
  {
    all.places.push_back(placeOf(point, graph, values, reach));
    all.freeCount.push_back(point.type == CriticalType::Saddle ? point.multiplicity : 0);
  }
  all.seen.assign(points.size(), 0.0);
  MergeSweep(all, trees.sublevel, CriticalType::Minimum).run(range);
  MergeSweep(all, trees.superlevel, CriticalType::Maximum).run(range);
  pairHidden(all);
  followLoops(all, range, execution.part(0.9, 1.0));
  concludePersistence(all);
  return std::move(all.pairs);
}

} // namespace SurfaceScalars
