#pragma once

#include "LevelSets.h"
#include "NeighborGraph.h"

#include <functional>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{

/// Samples and the curves traced on them.
struct Traced
{
  NeighborGraph graph;
  LevelSets levelSets;

  double step() const { return this->graph.medianSamplingStep(); }
};

inline ContourParameters at(std::vector<double> isoValues)
{
  ContourParameters parameters;
  parameters.isoValues = std::move(isoValues);
  return parameters;
}

inline Traced trace(const PointsRef& points, const ValuesRef& values,
  const ContourParameters& parameters, const Execution& execution = {})
{
  NeighborGraph graph(points, NeighborQuery(), execution);
  LevelSets levelSets = traceLevelSets(graph, graph.average(values), parameters, execution);
  return { std::move(graph), std::move(levelSets) };
}

/// Everything that is returned, compared bit for bit.
inline bool identical(const LevelSetPoint& a, const LevelSetPoint& b)
{
  return a.position == b.position && a.normal == b.normal && a.residual == b.residual &&
    a.converged == b.converged;
}

inline bool identical(const LevelSets& a, const LevelSets& b)
{
  const auto sameCurve = [](const LevelSetCurve& left, const LevelSetCurve& right)
  {
    return left.level == right.level && left.component == right.component &&
      left.closed == right.closed && left.length == right.length &&
      std::equal(left.points.begin(), left.points.end(), right.points.begin(), right.points.end(),
        [](const LevelSetPoint& x, const LevelSetPoint& y) { return identical(x, y); });
  };
  const auto sameSample = [](const LevelSetSample& left, const LevelSetSample& right)
  { return left.level == right.level && identical(left.point, right.point); };
  return a.isoValues == b.isoValues && a.componentCounts == b.componentCounts &&
    a.neighborCount == b.neighborCount &&
    std::equal(a.curves.begin(), a.curves.end(), b.curves.begin(), b.curves.end(), sameCurve) &&
    std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(), sameSample);
}

} // namespace SurfaceScalars::Truth
