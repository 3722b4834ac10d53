#pragma once

#include "DisjointSets.h"
#include "VertexOrder.h"
#include "VolumeTopology.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace SurfaceScalars
{

/// A triangle without a pair, by the places of its corners in the order, descending.
struct UnpairedTriangle
{
  std::array<Index, 3> corners;
  std::array<Index, 2> tetrahedra; ///< beside it; their count is the outside of the volume
};

/// The pairs in the lower stars of some vertices, one vertex after the other.
struct StarPairs
{
  static constexpr Index None = std::numeric_limits<Index>::max();

  /// An edge of a lower star.
  struct Edge
  {
    Index end;                       ///< place of the other end
    Index turn;                      ///< when it was met: from 0 for each vertex
    std::array<Index, 2> ofTriangle; ///< places of end and third corner, if one is its pair
  };

  std::vector<Index> counts; ///< of edges, for each vertex
  std::vector<Edge> edges;   ///< of each vertex by their ends, ascending
  std::vector<UnpairedTriangle> triangles;
};

/**
 * Pairs simplices of a lower star, which is what a vertex is the last corner of, with faces in it,
 * so that no way along the pairs returns (Robins, Wood and Sheppard 2011, ProcessLowerStars): one
 * that has one face left is met with that; only if there is no such, one with none left is met
 * alone. In the order in which they are met, a simplex comes after its faces, and right after the
 * last of them if that is its pair.
 *
 * Time O(n log n) for n tetrahedra around the vertex.
 */
class LowerStarPairing
{
public:
  /// @param isRelative leaves out the simplices of the boundary
  /// @param pairs gets what is found
  /// @param tetrahedra gets each that is paired attached to the one behind its triangle; their
  /// count is the outside
  LowerStarPairing(const VolumeTopology& volume, const VertexOrder& order, bool isRelative,
    StarPairs& pairs, DisjointSets& tetrahedra);

  /// The vertex at a place, the next.
  void add(Index place);

private:
  /// The corners of a simplex beside the vertex: 1 + their places, descending, then 0.
  using Simplex = std::array<Index, 3>;

  /// A triangle at the vertex, as a side of one tetrahedron.
  struct Side
  {
    Simplex triangle;
    Index opposite; ///< corner
    Index tetrahedron;

    bool operator<(const Side& other) const { return this->triangle < other.triangle; }
  };

  /// A simplex as a coface of one of its faces.
  struct Incidence
  {
    Index face = StarPairs::None;
    Index next = StarPairs::None; ///< incidence of this face
  };

  static constexpr Index None = StarPairs::None;

  void gather();
  void gather(Index vertex, Index tetrahedron, bool all);
  bool isLower(const Simplex& simplex) const { return simplex[0] <= this->place_; }
  void removeBoundary();
  void findFaces();
  void addEdges();
  void meet(Index simplex);
  void meetWithFace(Index simplex);
  void meetAlone(Index simplex);
  void attach(const Simplex& triangle, const Simplex& tetrahedron);

  const VolumeTopology& volume_;
  const VertexOrder& order_;
  bool isRelative_;
  StarPairs& pairs_;
  DisjointSets& tetrahedra_;

  Index place_ = 0;
  Index turn_ = 0;
  std::vector<Side> sides_;            ///< ascending
  std::vector<Simplex> simplices_;     ///< of the lower star, ascending: faces come before
  std::vector<Incidence> incidences_;  ///< three for each simplex
  std::vector<Index> firstIncidences_; ///< of each as a face
  std::vector<Index> left_;            ///< faces of each that are not met
  std::vector<char> isMet_;
  std::vector<Index> edges_; ///< of each simplex: its place in the pairs, if it is an edge
  std::vector<Index> ready_; ///< simplices with one face left, a heap, and others
  std::vector<Index> free_;  ///< those with none, a heap, and others
};

} // namespace SurfaceScalars
