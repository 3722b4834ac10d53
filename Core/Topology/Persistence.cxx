#include "Persistence.h"

#include "MergeTrees.h"
#include "MergeTreesBuilder.h"
#include "Require.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

std::vector<PersistencePair> pairsOf(const MergeTree& tree, const ValuesRef& values)
{
  std::vector<PersistencePair> pairs;
  pairs.reserve(tree.merges.size());
  for (const Merge& merge : tree.merges)
  {
    pairs.push_back(
      { merge.younger, merge.vertex, std::abs(values[merge.vertex] - values[merge.younger]) });
  }
  std::stable_sort(pairs.begin(), pairs.end(),
    [](const PersistencePair& a, const PersistencePair& b)
    { return a.persistence > b.persistence; });
  return pairs;
}

} // namespace

MergeTrees graphMergeTrees(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution)
{
  require(values.size() == graph.pointCount(), "one value per point",
    std::to_string(values.size()) + " values for " + std::to_string(graph.pointCount()) + " points",
    "Leave points without a value out.");
  const auto neighborsOf = [&](Index point) { return graph.neighbors(point); };
  const ValueOrder isBelow{ values.data() };
  return MergeTreesBuilder(graph.pointCount(), neighborsOf, isBelow, execution).build();
}

PersistencePairs pairsOf(const MergeTrees& trees, const ValuesRef& values)
{
  return { pairsOf(trees.sublevel, values), pairsOf(trees.superlevel, values) };
}

PersistencePairs persistencePairs(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution)
{
  return pairsOf(graphMergeTrees(graph, values, execution), values);
}

void removeBelow(
  std::vector<CriticalPoint>& points, const std::vector<CriticalPair>& pairs, double threshold)
{
  for (const CriticalPair& pair : pairs)
  {
    if (pair.persistence < threshold)
    {
      --points[pair.saddle].multiplicity;
    }
  }
  points.erase(std::remove_if(points.begin(), points.end(),
                 [=](const CriticalPoint& point)
                 { return point.persistence < threshold || point.multiplicity == 0; }),
    points.end());
}

} // namespace SurfaceScalars
