#include "SurfaceVertices.h"

#include "Error.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
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

vtkSmartPointer<vtkPolyData> triangulated(vtkPolyData* surface)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->PassVertsOff();
  filter->PassLinesOff();
  filter->Update();
  return filter->GetOutput();
}

/// Corners as vertices; without triangles whose corners are not three vertices.
std::vector<Index> cornersOf(vtkCellArray* cells, const VertexMap& map)
{
  std::vector<Index> corners;
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    const Index a = map.vertexOf(ids[0]);
    const Index b = map.vertexOf(ids[1]);
    const Index c = map.vertexOf(ids[2]);
    const bool isThere = a != VertexMap::None && b != VertexMap::None && c != VertexMap::None;
    if (isThere && a != b && b != c && c != a)
    {
      corners.insert(corners.end(), { a, b, c });
    }
  }
  return corners;
}

/// Keeps the vertices that are corners, in their order, and renumbers corners and points.
void dropUnused(std::vector<Index>& corners, VertexMap& map)
{
  std::vector<Index> numbers(map.pointOfVertex.size(), VertexMap::None);
  for (const Index corner : corners)
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
  std::for_each(corners.begin(), corners.end(), renumber);
  std::for_each(map.vertexOfPoint.begin(), map.vertexOfPoint.end(), renumber);
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

SampledSurface sampledSurface(
  const Points& points, const NeighborQuery& query, const Execution& execution)
{
  const Finite finite = finiteAmong(points);
  NeighborGraph graph(finite.points, query, execution);
  VertexMap map = vertexMap(graph, finite.ids, points.cols());
  return { std::move(graph), std::move(map) };
}

MeshedSurface meshedSurface(const Points& points, vtkPolyData* surface, const Execution& execution)
{
  const Finite finite = finiteAmong(points);
  VertexMap map = vertexMap(PointCloud(finite.points, execution), finite.ids, points.cols());
  std::vector<Index> corners = cornersOf(triangulated(surface)->GetPolys(), map);
  if (corners.empty())
  {
    throw InvalidInput("a mesh of triangles, quads or strips for these Weights",
      "no triangle among " + std::to_string(surface->GetNumberOfCells()) + " cells",
      "Choose Weights LocalScale for points, or apply Extract Surface to a mesh of another type.");
  }
  dropUnused(corners, map);
  MeshedSurface mesh;
  mesh.vertices = points(Eigen::all, map.pointOfVertex);
  mesh.triangles =
    Eigen::Map<const Triangles>(corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
  mesh.map = std::move(map);
  return mesh;
}

} // namespace SurfaceScalars
