#pragma once

#include "MergeTree.h"
#include "NeighborGraph.h"
#include "Persistence.h"

namespace SurfaceScalars
{

struct MergeTrees
{
  MergeTree sublevel;   ///< of {f <= t}, t rising: minima
  MergeTree superlevel; ///< of {f >= t}, t falling: maxima
};

/// Both merge trees of a graph, beside each other. @param isBelow and the other parameters as of
/// MergeTreeBuilder
template <class Adjacency, class Order>
MergeTrees mergeTrees(
  Index count, const Adjacency& neighborsOf, const Order& isBelow, const Execution& execution)
{
  const auto isAbove = [&](Index a, Index b) { return isBelow(b, a); };
  MergeTrees trees;
  parallelForEach(2, execution,
    [&](std::size_t which, const Poll& poll)
    {
      if (which == 0)
      {
        trees.sublevel = MergeTreeBuilder(count, neighborsOf, isBelow, poll).build();
      }
      else
      {
        trees.superlevel = MergeTreeBuilder(count, neighborsOf, isAbove, poll).build();
      }
    });
  return trees;
}

/// The merge trees of a function on the neighbor graph, ties by index.
/// @throws InvalidInput unless there is one value per point; Aborted
MergeTrees graphMergeTrees(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution);

/// The merges as pairs.
PersistencePairs pairsOf(const MergeTrees& trees, const ValuesRef& values);

} // namespace SurfaceScalars
