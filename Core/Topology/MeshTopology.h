#pragma once

#include "Execution.h"
#include "SurfaceScalarsCoreExport.h"
#include "Triangles.h"
#include "VertexName.h"

#include <cstdint>
#include <vector>

namespace SurfaceScalars
{

/// The vertices around a vertex: a half-open range of indices.
struct VertexRange
{
  const Index* first;
  const Index* last;

  const Index* begin() const { return this->first; }
  const Index* end() const { return this->last; }
  Index size() const { return static_cast<Index>(this->last - this->first); }
};

/**
 * Who is next to whom on a triangle mesh: a manifold, with or without boundary, of any number of
 * components, orientable or not; in which direction each triangle runs does not matter. Flat
 * arrays, built once.
 *
 * Memory: 60 bytes per vertex, 24 of them the triangles. Time O(n).
 */
class SURFACESCALARSCORE_EXPORT MeshTopology
{
public:
  /**
   * @param triangles corners below vertexCount, three different ones each
   * @throws InvalidInput that names a vertex: for an edge of more than two triangles, a vertex
   * whose triangles do not form one fan (pinched), a vertex without triangles, a corner that does
   * not exist, a triangle that has a corner twice; without triangles. Aborted
   */
  MeshTopology(Index vertexCount, Triangles triangles, const Execution& execution = {},
    const VertexName& nameOf = {});

  Index vertexCount() const { return static_cast<Index>(this->starts_.size() - 1); }
  const Triangles& triangles() const { return this->triangles_; }

  /// The link: neighbors in cyclic order, each joined by an edge to the next; of a vertex on the
  /// boundary from one boundary edge to the other, of an interior one the last is next to the
  /// first.
  VertexRange link(Index vertex) const
  {
    const VertexRange path = this->linkPath(vertex);
    return { path.first, path.last - (*path.first == path.last[-1] ? 1 : 0) };
  }

  /// The link as a path along its edges, one for each triangle: that of an interior vertex comes
  /// back to where it begins.
  VertexRange linkPath(Index vertex) const
  {
    const Index* links = this->links_.data();
    return { links + this->starts_[vertex], links + this->starts_[vertex + 1] };
  }

  bool isBoundary(Index vertex) const
  {
    const VertexRange path = this->linkPath(vertex);
    return *path.first != path.last[-1];
  }
  bool isClosed() const { return this->boundaryCount_ == 0; }

  /// Of connected components, numbered from 0 in the order of their first vertices.
  Index component(Index vertex) const { return this->components_[vertex]; }
  Index componentCount() const { return this->componentCount_; }

  /// Vertices - edges + triangles.
  std::int64_t eulerCharacteristic() const;

private:
  void checkTriangles(const VertexName& nameOf) const;
  void findTrianglesOfVertices(const Execution& execution, const VertexName& nameOf);
  void orderLinks(const Execution& execution, const VertexName& nameOf);
  void numberComponents(const Execution& execution);

  Triangles triangles_;
  std::vector<Index> starts_; ///< of each vertex in links_, and the end
  std::vector<Index> links_;  ///< the paths
  std::vector<Index> components_;
  Index componentCount_ = 0;
  Index boundaryCount_ = 0; ///< vertices of the boundary, which are as many as its edges
};

} // namespace SurfaceScalars
