#pragma once

#include "Front.h"
#include "MeshTopology.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/**
 * Distances along a mesh from places where they are given: for each vertex the least, over the
 * points q of the edges opposite to it, of the distance of q, linear along the edge, and the way
 * from q straight to the vertex. Exact for a front that is a straight line, given at all vertices
 * of the triangles it passes through; where it is curved the error falls with the square of the
 * edges as far as they are short against its radius.
 *
 * Vertices are passed in the order of their distances. One whose distance falls afterwards, as it
 * may beside obtuse angles, is passed a second time; what more would add is less than 1e-5 on a
 * rough surface, and on one of thin triangles it may take forever.
 *
 * (GeodesicDistance.h takes fronts for circles around a point, as they are around single sources.)
 */
class MeshFront
{
public:
  MeshFront(const PointsRef& vertices, const MeshTopology& mesh);

  void clear();
  void offer(Index vertex, double distance) { this->front_.offer(vertex, distance); }

  /// Goes on until all of these vertices have been passed.
  void reach(const std::vector<Index>& targets, const Poll& poll);

  double distance(Index vertex) const { return this->front_.distance(vertex); }
  /// Of vertices with a finite distance.
  std::size_t reachedCount() const { return this->front_.reached().size(); }
  /// The least way to a place across an edge, ends included.
  double across(const Vector3d& place, Index a, Index b) const;

private:
  void pass(Index vertex);

  PointsRef vertices_;
  const MeshTopology& mesh_;
  Front front_;
  std::vector<char> turns_; ///< how often each vertex was passed
};

} // namespace SurfaceScalars
