#include "SurfaceVertices.h"

#include "Error.h"
#include "FilterRun.h"
#include "SurfaceTriangles.h"

#include "vtkPolyData.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// The points with a finite position, and where they are among all.
struct Finite
{
  Points points;
  std::vector<vtkIdType> ids;
};

Finite finiteAmong(const Points& points)
{
  Finite finite;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    if (points.col(i).allFinite())
    {
      finite.ids.push_back(i);
    }
  }
  if (finite.ids.empty())
  {
    throw InvalidInput("points with a finite position",
      "none among " + std::to_string(points.cols()), "Choose another input.");
  }
  finite.points = points(Eigen::all, finite.ids);
  return finite;
}

/// The triangles of points as triangles of vertices, those whose corners are three.
Triangles betweenVertices(const Triangles& triangles, const VertexMap& map)
{
  Triangles result(3, triangles.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < triangles.cols(); ++i)
  {
    const Index a = map.vertexOf(triangles(0, i));
    const Index b = map.vertexOf(triangles(1, i));
    const Index c = map.vertexOf(triangles(2, i));
    const bool isThere = a != VertexMap::None && b != VertexMap::None && c != VertexMap::None;
    if (isThere && a != b && b != c && c != a)
    {
      result.col(count++) << a, b, c;
    }
  }
  result.conservativeResize(3, count);
  return result;
}

} // namespace

Values VertexMap::atPoints(const Values& atVertices) const
{
  Values values(this->pointCount());
  for (vtkIdType point = 0; point < this->pointCount(); ++point)
  {
    const Index vertex = this->vertexOf(point);
    values(point) = vertex == None ? std::numeric_limits<double>::quiet_NaN() : atVertices(vertex);
  }
  return values;
}

VertexName VertexMap::names() const
{
  return [ids = std::make_shared<const std::vector<vtkIdType>>(this->pointOfVertex)](Index vertex)
  { return static_cast<std::size_t>((*ids)[vertex]); };
}

VertexMap vertexMap(
  const PointCloud& cloud, const std::vector<vtkIdType>& ids, vtkIdType pointCount)
{
  const auto idOf = [&ids](std::size_t sample)
  { return ids.empty() ? static_cast<vtkIdType>(sample) : ids[sample]; };
  VertexMap map;
  map.vertexOfPoint.assign(static_cast<std::size_t>(pointCount), VertexMap::None);
  for (std::size_t sample = 0; sample < cloud.inputCount(); ++sample)
  {
    map.vertexOfPoint[static_cast<std::size_t>(idOf(sample))] = cloud.pointOfInput(sample);
  }
  map.pointOfVertex.resize(cloud.pointCount());
  for (Index vertex = 0; vertex < cloud.pointCount(); ++vertex)
  {
    map.pointOfVertex[vertex] = idOf(cloud.inputOfPoint(vertex));
  }
  return map;
}

VertexMap allPoints(Eigen::Index count)
{
  VertexMap map;
  map.vertexOfPoint.resize(static_cast<std::size_t>(count));
  map.pointOfVertex.resize(static_cast<std::size_t>(count));
  std::iota(map.vertexOfPoint.begin(), map.vertexOfPoint.end(), Index(0));
  std::iota(map.pointOfVertex.begin(), map.pointOfVertex.end(), vtkIdType{ 0 });
  return map;
}

void noteOutside(
  FilterRun& run, const VertexMap& map, Eigen::Index missing, const std::string& simplex)
{
  const Eigen::Index outside =
    std::count(map.vertexOfPoint.begin(), map.vertexOfPoint.end(), VertexMap::None) - missing;
  if (outside > 0)
  {
    run.note(std::to_string(outside) + " of " + std::to_string(map.pointCount()) +
      " points are in no " + simplex + " and get NaN.");
  }
}

SampledSurface sampledSurface(
  const Points& points, const NeighborQuery& query, const Execution& execution)
{
  const Finite finite = finiteAmong(points);
  NeighborGraph graph(finite.points, query, execution);
  VertexMap map = vertexMap(graph, finite.ids, points.cols());
  return { std::move(graph), std::move(map) };
}

MeshedSurface surfaceOf(const Points& points, Triangles triangles, VertexMap map)
{
  keepCorners(triangles, map);
  Points vertices = points(Eigen::all, map.pointOfVertex);
  return { std::move(vertices), std::move(triangles), std::move(map) };
}

MeshedSurface meshedSurface(const Points& points, vtkPolyData* surface, const Execution& execution)
{
  constexpr double mapShare = 0.7; // of the whole
  const Finite finite = finiteAmong(points);
  VertexMap map =
    vertexMap(PointCloud(finite.points, execution.part(0.0, mapShare)), finite.ids, points.cols());
  Triangles triangles =
    betweenVertices(trianglesOf(surface, execution.part(mapShare, 1.0)).triangles, map);
  if (triangles.cols() == 0)
  {
    throw InvalidInput("a mesh of triangles, quads or strips for these Weights",
      "no triangle among " + std::to_string(surface->GetNumberOfCells()) + " cells",
      "Choose Weights LocalScale for points, or apply Extract Surface to a mesh of another type.");
  }
  return surfaceOf(points, std::move(triangles), std::move(map));
}

} // namespace SurfaceScalars
