#pragma once

#include "Laplacian.h"
#include "NeighborGraph.h"
#include "VertexName.h"

#include "vtkType.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

class vtkPolyData;

namespace SurfaceScalars
{

class FilterRun;

/// Which vertex of a graph or mesh a point of the input is. Several points at one place can be one.
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
  /// The points of the vertices, for messages; outlives the map.
  VertexName names() const;
};

/// @param ids which of the `pointCount` points the cloud was made of; empty: all
VertexMap vertexMap(
  const PointCloud& cloud, const std::vector<vtkIdType>& ids, vtkIdType pointCount);

/// All points as vertices.
VertexMap allPoints(Eigen::Index count);

/// Counts the points that are no vertices in a note, those that are missing not counted.
/// @param simplex of which they would be
void noteOutside(FilterRun& run, const VertexMap& map, Eigen::Index missing,
  const std::string& simplex = "triangle");

/// Leaves the vertices that are no corners of simplices out and renumbers the others in their
/// order.
/// @param simplices Triangles or Tetrahedra @param map of vertices to points before
template <class Simplices>
void keepCorners(Simplices& simplices, VertexMap& map)
{
  std::vector<Index> numbers(map.pointOfVertex.size(), VertexMap::None);
  for (const Index corner : simplices.reshaped())
  {
    numbers[corner] = 0;
  }
  Index count = 0;
  for (std::size_t vertex = 0; vertex < numbers.size(); ++vertex)
  {
    if (numbers[vertex] != VertexMap::None)
    {
      map.pointOfVertex[count] = map.pointOfVertex[vertex];
      numbers[vertex] = count++;
    }
  }
  map.pointOfVertex.resize(count);
  const auto renumber = [&](Index& vertex)
  { vertex = vertex == VertexMap::None ? vertex : numbers[vertex]; };
  std::for_each(simplices.data(), simplices.data() + simplices.size(), renumber);
  std::for_each(map.vertexOfPoint.begin(), map.vertexOfPoint.end(), renumber);
}

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

/// The vertices that are corners, in their order. @param map of vertices to points before any are
/// left out
MeshedSurface surfaceOf(const Points& points, Triangles triangles, VertexMap map);

/// Those of all triangles, between vertices with a finite position; points at one place are one.
/// @param points those of the polydata
/// @throws InvalidInput if there are no triangles; Aborted
MeshedSurface meshedSurface(const Points& points, vtkPolyData* surface, const Execution& execution);

} // namespace SurfaceScalars
