#pragma once

#include "MeshTopology.h"
#include "Tetrahedra.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace SurfaceScalars
{

/**
 * Who is next to whom in a volume of tetrahedra, with or without boundary, of any number of
 * components; which way round the corners of a tetrahedron are numbered does not matter. Flat
 * arrays, built once.
 *
 * It need not be a manifold: parts may meet in a vertex or an edge only, as they do where cells
 * were left out.
 *
 * Memory: 32 bytes per tetrahedron, 16 of them its corners, 8 per edge and 13 per vertex; that is
 * 260 per point of an image cut into tetrahedra. Time O(n log k) for k tetrahedra around a vertex.
 */
class SURFACESCALARSCORE_EXPORT VolumeTopology
{
public:
  /// More are refused: indices are numbers of 32 bits.
  static constexpr Eigen::Index MostTetrahedra = std::numeric_limits<Index>::max() / 12; // edges

  /**
   * @param tetrahedra corners below vertexCount, four different ones each
   * @throws InvalidInput that names a vertex: for a face of more than two tetrahedra, a vertex
   * without tetrahedra, a corner that does not exist, a tetrahedron that has a corner twice;
   * without tetrahedra. Aborted
   */
  VolumeTopology(Index vertexCount, Tetrahedra tetrahedra, const Execution& execution = {},
    const VertexName& nameOf = {});

  Index vertexCount() const { return static_cast<Index>(this->isBoundary_.size()); }
  const Tetrahedra& tetrahedra() const { return this->tetrahedra_; }

  /// The vertices joined to one by an edge, ascending.
  VertexRange link(Index vertex) const
  {
    return this->rangeOf(this->linkStarts_, this->links_, vertex);
  }

  /// The tetrahedra around a vertex, ascending.
  VertexRange star(Index vertex) const
  {
    return this->rangeOf(this->starStarts_, this->stars_, vertex);
  }

  /// Whether the vertex has a face of only one tetrahedron.
  bool isBoundary(Index vertex) const { return this->isBoundary_[vertex] != 0; }
  bool isClosed() const { return this->boundaryFaceCount_ == 0; }

  /// Of connected components, numbered from 0 in the order of their first vertices.
  Index component(Index vertex) const { return this->components_[vertex]; }
  Index componentCount() const { return this->componentCount_; }

  /// Vertices - edges + faces - tetrahedra.
  std::int64_t eulerCharacteristic() const;

private:
  static VertexRange rangeOf(
    const std::vector<Index>& starts, const std::vector<Index>& all, Index vertex)
  {
    return { all.data() + starts[vertex], all.data() + starts[vertex + 1] };
  }

  void checkTetrahedra(const Execution& execution, const VertexName& nameOf) const;
  void findStars(const Execution& execution, const VertexName& nameOf);
  void findLinks(const Execution& execution, const VertexName& nameOf);

  Tetrahedra tetrahedra_;
  std::vector<Index> starStarts_; ///< of each vertex in stars_, and the end
  std::vector<Index> stars_;
  std::vector<Index> linkStarts_; ///< of each vertex in links_, and the end
  std::vector<Index> links_;
  std::vector<char> isBoundary_;
  std::vector<Index> components_;
  Index componentCount_ = 0;
  Index boundaryFaceCount_ = 0;
};

} // namespace SurfaceScalars
