#include "SeparatrixOutput.h"

#include "MeshOutput.h"
#include "OutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr vtkIdType NotPassed = -1;

/// Which vertices of the mesh become points of the output: those that paths pass, in their order.
VertexMap passedVertices(const MorseComplex& complex, Eigen::Index vertexCount)
{
  VertexMap map;
  map.pointOfVertex.assign(static_cast<std::size_t>(vertexCount), NotPassed);
  for (const Separatrix& path : complex.separatrices)
  {
    for (const Index vertex : path.vertices)
    {
      map.pointOfVertex[vertex] = 0;
    }
  }
  for (std::size_t vertex = 0; vertex < map.pointOfVertex.size(); ++vertex)
  {
    if (map.pointOfVertex[vertex] != NotPassed)
    {
      map.pointOfVertex[vertex] = map.pointCount();
      map.vertexOfPoint.push_back(static_cast<Index>(vertex));
    }
  }
  return map;
}

/// Places, values and ids of the points.
void writePoints(const MorseComplex& complex, const VertexMap& map, const MeshInput& mesh,
  const std::string& valueName, vtkPolyData* output)
{
  const auto places = vtkSmartPointer<vtkPoints>::New();
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(map.pointCount());
  const auto values = makeDoubles(valueName, map.pointCount());
  const auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName("PointId");
  ids->SetNumberOfValues(map.pointCount());
  for (vtkIdType point = 0; point < map.pointCount(); ++point)
  {
    const Index vertex = map.vertexOf(point);
    places->SetPoint(point, mesh.surface.vertices.col(vertex).data());
    values->SetValue(point, complex.values(vertex));
    ids->SetValue(point, mesh.surface.map.pointOfVertex[vertex]);
  }
  output->SetPoints(places);
  output->GetPointData()->SetScalars(values);
  output->GetPointData()->AddArray(ids);
}

void writePaths(const MorseComplex& complex, const VertexMap& map, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(complex.separatrices.size());
  const auto sources = makeInts("SourceId", count);
  const auto destinations = makeInts("DestinationId", count);
  const auto types = makeInts("SeparatrixType", count);
  const auto persistences = makeDoubles("Persistence", count);
  const auto lines = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType cell = 0;
  for (const Separatrix& path : complex.separatrices)
  {
    lines->InsertNextCell(static_cast<int>(path.vertices.size()));
    for (const Index vertex : path.vertices)
    {
      lines->InsertCellPoint(map.pointOfVertex[vertex]);
    }
    sources->SetValue(cell, static_cast<int>(path.source));
    destinations->SetValue(cell, static_cast<int>(path.destination));
    types->SetValue(cell, path.ascending ? 1 : 0);
    persistences->SetValue(cell++, path.persistence);
  }
  output->SetLines(lines);
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ sources, destinations, types, persistences })
  {
    output->GetCellData()->AddArray(array);
  }
}

/// The nodes that paths end in, named by the points of the output.
std::vector<CriticalPoint> passedNodes(const MorseComplex& complex, const VertexMap& map)
{
  std::vector<CriticalPoint> nodes;
  std::copy_if(complex.nodes.begin(), complex.nodes.end(), std::back_inserter(nodes),
    [&map](const CriticalPoint& node) { return map.pointOfVertex[node.input] != NotPassed; });
  return namedByPoints(std::move(nodes), map);
}

} // namespace

void writeSeparatrices(
  const MorseComplex& complex, const MeshInput& mesh, const FilterRun& run, vtkPolyData* output)
{
  const VertexMap map = passedVertices(complex, mesh.surface.vertices.cols());
  const std::string name =
    freeName(run, mesh.valueName, { "CriticalType", "Multiplicity", "PointId" });
  writePoints(complex, map, mesh, name, output);
  writePaths(complex, map, output);
  writeTypes(passedNodes(complex, map), map, name, run, output);
}

} // namespace SurfaceScalars
