#pragma once

#include "DisjointSets.h"
#include "MeshTopology.h"

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace SurfaceScalars
{

/// Two neighbors.
struct MeshEdge
{
  Index from;
  Index to;

  std::uint64_t key() const; ///< of the edge in either direction
};

/**
 * Where the ways of a tree of paths meet from different sides, on a closed mesh that is cut along a
 * network: the dual graph of the edges that are not in the tree, without its dead ends. What
 * crosses one and the same chain of it is homotopic; so the chains are all the ways worth trying
 * from the root of the tree back to it, or to the network, round the points and the handles.
 */
class CutLocus
{
public:
  explicit CutLocus(const MeshTopology& mesh);

  /// @param isInNetwork by vertex
  /// @param previous by vertex: the next one to the root of the tree, which spans all vertices off
  /// the network that are connected to it; itself where there is none
  /// @param points vertices or triangles next to these are not dead ends
  void find(const std::vector<char>& isInNetwork, const std::vector<Index>& previous,
    const std::vector<Index>& points);

  /// The edges that are crossed, chain by chain.
  const std::vector<std::vector<MeshEdge>>& chains() const { return this->chains_; }

  bool isCrossed(MeshEdge edge) const { return this->crossed_.count(edge.key()) > 0; }

private:
  void puncture(const std::vector<Index>& points);
  void removeDeadEnds();
  void collectChains();

  const MeshTopology& mesh_;
  std::vector<std::array<Index, 3>> neighbors_; ///< of triangles, across the edge from each corner
                                                ///< to the next
  std::vector<std::array<char, 3>> isOpen_;     ///< whether that edge is crossed
  std::vector<char> isPoint_;                   ///< by triangle
  std::vector<std::vector<MeshEdge>> chains_;
  std::unordered_set<std::uint64_t> crossed_;
};

} // namespace SurfaceScalars
