#pragma once

#include "MergeTree.h"
#include "NeighborGraph.h"
#include "Persistence.h"

namespace SurfaceScalars
{

/// The merge trees of a function on the neighbor graph, ties by index.
/// @throws InvalidInput unless there is one value per point; Aborted
MergeTrees graphMergeTrees(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution);

/// The merges as pairs.
PersistencePairs pairsOf(const MergeTrees& trees, const ValuesRef& values);

} // namespace SurfaceScalars
