#pragma once

#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Orders the vertices of a pit so that each has a neighbor before it, in the pit or at its entry,
 * and one after it, in the pit or beyond its rim: an st-numbering from the entry to the rim, by
 * Tarjan (Two streamlined depth-first search algorithms, 1986). It exists: links are connected, so
 * that no vertex alone cuts a part of the pit off from both.
 *
 * Time linear in the size of the pit.
 */
class PitOrder
{
public:
  /// @param isLast vertices that come after all their neighbors
  PitOrder(const MeshTopology& mesh, std::vector<char> isLast);

  /// @param entry the only neighbor of the pit that comes before it
  /// @param pit the vertices, from `first` on
  void sort(Index entry, std::vector<Index>& pit, std::size_t first);

private:
  /// Of the search: entry and rim are the first two nodes.
  struct Node
  {
    Index vertex;
    Index parent;
    Index low;         ///< the first node next to the node or to its descendants
    const Index* next; ///< neighbor to look at
    Index before;      ///< in the order
    Index after;
    bool isMinus;
  };

  void search(Index root);
  void insert(Index node);

  const MeshTopology& mesh_;
  std::vector<char> isLast_;
  std::vector<Index> nodeOf_; ///< of a vertex: the rim's if it is not in the pit
  std::vector<Node> nodes_;
};

} // namespace SurfaceScalars
