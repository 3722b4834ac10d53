#pragma once

#include "LevelSetModel.h"
#include "Projection.h"

#include <vector>

namespace SurfaceScalars
{

/// Why an open curve ends where it does.
enum class CurveEnd
{
  Lost,  ///< noise: no step onwards was good
  Edge,  ///< the samples end
  Saddle ///< of the level's value
};

/// A curve as traced: the points carry their tangents, which point onwards.
struct TracedCurve
{
  std::vector<LevelSetPoint> points;
  std::vector<Vector3d> tangents;
  std::vector<double> steps;        ///< widened sampling steps
  std::vector<std::size_t> corners; ///< points that are saddles, ascending: only of loops
  bool closed = false;
  CurveEnd start = CurveEnd::Lost;
  CurveEnd end = CurveEnd::Lost;
};

/// The lengths a tracer works with, in sampling steps of the place unless said otherwise.
struct TracingLimits
{
  double tolerance;      ///< of the projection, length
  int maximumIterations; ///< of the projection
  double widening;   ///< of the step along curves: sqrt of the neighborhood's size to the usual one
  double voidRadius; ///< no sample within: a hole, not a gap of random sampling
  double linkDistance; ///< widest hole that a curve runs on across
};

/**
 * Traces the curves of one level set by prediction and correction: from each seed that no curve has
 * passed yet, along the tangent in both directions, until the curve closes, leaves the samples, or
 * ends at a saddle of the same value. Once the saddles of the level are known, their branches are
 * traced first and joined into loops: see joinArcs().
 *
 * @param seeds points on the level set
 */
std::vector<TracedCurve> traceCurves(LevelSetModel& model, const SampledFunction& function,
  double level, const std::vector<LevelSetPoint>& seeds, const TracingLimits& limits,
  const Poll& poll);

} // namespace SurfaceScalars
