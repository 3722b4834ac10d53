#pragma once

#include "LevelSetModel.h"

#include <vector>

namespace SurfaceScalars
{

/// Where a level meets an edge of the neighbor graph, f taken as linear along it (sec. 4.1).
struct EdgeCrossing
{
  Index from;
  Index to;
  double parameter; ///< t of (1 - t) from + t to, in [0, 1]
};

/// The crossings of one level: at most one for each point, the one closest to it. Ascending by
/// `from`, but for chained().
using LevelCrossings = std::vector<EdgeCrossing>;

/**
 * Where ascending levels meet the edges from each point to its closest neighbors. Each point is
 * ranked among the levels once; an edge meets the levels between the ranks of its ends. f < level
 * is below, f >= level is above.
 */
std::vector<LevelCrossings> findCrossings(
  const SampledFunction& function, const std::vector<double>& levels, const Execution& execution);

/// Keeps crossings that lie about `spacing` sampling steps of the place (at least one) apart: of
/// those of neighboring points, one.
LevelCrossings thinned(
  const LevelCrossings& crossings, const NeighborGraph& graph, double spacing, const Poll& poll);

/// In an order in which most follow one that is close, along the curves to be.
LevelCrossings chained(const LevelCrossings& crossings, const NeighborGraph& graph);

} // namespace SurfaceScalars
