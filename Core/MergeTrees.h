#pragma once

#include "MergeTree.h"
#include "NeighborGraph.h"

namespace SurfaceScalars
{

struct GraphMergeTrees
{
  MergeTree sublevel;   ///< of {f <= t}, t rising: minima
  MergeTree superlevel; ///< of {f >= t}, t falling: maxima
};

/// The merge trees of a function on the neighbor graph, ties by index.
/// @throws InvalidInput unless there is one value per point; Aborted
GraphMergeTrees graphMergeTrees(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution);

} // namespace SurfaceScalars
