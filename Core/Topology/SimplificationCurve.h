#pragma once

#include "MeshCriticalPoints.h"

#include <vector>

namespace SurfaceScalars
{

/// How many critical points are left as a threshold rises (smoothing paper, Fig. 2).
struct SimplificationCurve
{
  std::vector<double> thresholds;            ///< fractions of f's range
  std::vector<CriticalCounts> byDelta;       ///< whose delta threshold is larger; all for 0
  std::vector<CriticalCounts> byPersistence; ///< what removeBelow() leaves
};

/**
 * By delta a saddle counts with its whole multiplicity; by persistence with what its pairs leave of
 * it, so that on a closed mesh Euler's formula holds at every threshold up to 1.
 *
 * Time O((n + k) log n) for n critical points and k thresholds.
 *
 * @param deltas of all vertices, see deltaThresholds()
 * @param range of f
 * @param thresholds fractions of the range, in any order
 */
SURFACESCALARSCORE_EXPORT SimplificationCurve simplificationCurve(
  const MeshCriticalPoints& critical, const ValuesRef& deltas, double range,
  const std::vector<double>& thresholds);

} // namespace SurfaceScalars
