#pragma once

#include "Laplacian.h"
#include "NeighborGraph.h"

#include "vtkType.h"

#include <limits>
#include <vector>

class vtkPolyData;

namespace SurfaceScalars
{

/// Which vertex of a graph or mesh a point of the input is. Points at one place are one vertex.
struct VertexMap
{
  static constexpr Index None = std::numeric_limits<Index>::max();

  std::vector<Index> vertexOfPoint;     ///< None for points that are not part of the surface
  std::vector<vtkIdType> pointOfVertex; ///< the first of the points there

  vtkIdType pointCount() const { return static_cast<vtkIdType>(this->vertexOfPoint.size()); }
  Index vertexOf(vtkIdType point) const
  {
    return this->vertexOfPoint[static_cast<std::size_t>(point)];
  }
  /// Values of the vertices at the points, NaN at those that are not part of the surface.
  Values atPoints(const Values& atVertices) const;
};

/// @param ids which of the `pointCount` points the cloud was made of; empty: all
VertexMap vertexMap(
  const PointCloud& cloud, const std::vector<vtkIdType>& ids, vtkIdType pointCount);

/// The surface sampled by all points with a finite position.
struct SampledSurface
{
  NeighborGraph graph;
  VertexMap map;
};

/// @throws InvalidInput if fewer than two are distinct; Aborted
SampledSurface sampledSurface(
  const Points& points, const NeighborQuery& query, const Execution& execution);

/// The surface of the triangles, quads and strips of polydata; vertices of at least one triangle.
struct MeshedSurface
{
  Points vertices;
  Triangles triangles;
  VertexMap map;
};

/// @param points those of the polydata
/// @throws InvalidInput if there are no triangles; Aborted
MeshedSurface meshedSurface(const Points& points, vtkPolyData* surface, const Execution& execution);

} // namespace SurfaceScalars
