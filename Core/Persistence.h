#pragma once

#include "CriticalPoint.h"
#include "NeighborGraph.h"
#include "SurfaceScalarsCoreExport.h"

#include <vector>

namespace SurfaceScalars
{

/// An extremum that vanishes at a saddle as the level passes it: two components of {f <= t}, or of
/// {f >= t}, become one there and the younger ends.
struct PersistencePair
{
  Index extremum;
  Index saddle;
  double persistence; ///< |f(saddle) - f(extremum)|
};

struct PersistencePairs
{
  std::vector<PersistencePair> minima; ///< by persistence, descending
  std::vector<PersistencePair> maxima;
};

/**
 * The extremum-saddle pairs of a function on the vertices of a graph, by union-find in the order of
 * the values, ties by index (design paper, sec. 2). Extrema that never vanish, one minimum and one
 * maximum per connected component, are in no pair.
 *
 * Time O(n log n).
 */
SURFACESCALARSCORE_EXPORT PersistencePairs persistencePairs(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution = {});

/**
 * Gives critical points found off the samples their persistence: that of the pairs of the graph at
 * their places. What is in no pair gets f's range.
 *
 * @param values f~ at the points of the graph
 */
void assignPersistence(std::vector<CriticalPoint>& points, const NeighborGraph& graph,
  const ValuesRef& values, const Execution& execution);

} // namespace SurfaceScalars
