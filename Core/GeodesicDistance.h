#pragma once

#include "Execution.h"
#include "NeighborGraph.h"
#include "SurfaceScalarsCoreExport.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The length of the shortest way along the surface from the nearest of the sources to each point of
 * a neighbor graph (point-set paper, sec. 2.2), by fast marching: a point takes its distance from
 * two neighbors whose distances are known, as in the plane of the three points.
 *
 * @param sources points of the graph, at least one
 * @returns length units; infinite at points that no way leads to
 * @throws InvalidInput without sources or for ones that do not exist; Aborted
 */
SURFACESCALARSCORE_EXPORT Values geodesicDistance(
  const NeighborGraph& graph, const std::vector<Index>& sources, const Execution& execution = {});

} // namespace SurfaceScalars
