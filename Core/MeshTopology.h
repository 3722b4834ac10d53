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
 * components, orientable or not. Flat arrays, built once.
 *
 * Memory: (some) bytes per vertex. Time O(n).
 */
class SURFACESCALARSCORE_EXPORT MeshTopology
{
public:
  /**
   * @param triangles corners below vertexCount, three different ones each
   * @throws InvalidInput that names a vertex: for an edge of more than two triangles, a vertex whose
   * triangles do not form one fan (pinched), a vertex without triangles, a corner that does not
   * exist, a triangle that has a corner twice; without triangles. Aborted
   */
  MeshTopology(Index vertexCount, const Triangles& triangles, const Execution& execution = {},
    const VertexName& nameOf = {});

  Index vertexCount() const;
  const Triangles& triangles() const;

  /// The link: neighbors in cyclic order, each joined by an edge to the next; of a vertex on the
  /// boundary from one boundary edge to the other, of an interior one the last is next to the first.
  VertexRange link(Index vertex) const;
  bool isBoundary(Index vertex) const;
  bool isClosed() const;

  /// Of connected components, numbered from 0 in the order of their first vertices.
  Index component(Index vertex) const;
  Index componentCount() const;

  /// Vertices - edges + triangles.
  std::int64_t eulerCharacteristic() const;
};

} // namespace SurfaceScalars
