#include "CriticalPointOutput.h"

#include "OutputArrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1 << 14; // points per block of a parallel loop

} // namespace

void writeSampleCriticality(const SampleCriticality& samples, const VertexMap& map,
  const std::string& valueName, const FilterRun& run, const Execution& execution,
  vtkPolyData* output)
{
  const vtkIdType count = map.pointCount();
  const auto probabilities = makeDoubles("CriticalProbability", count);
  const auto gradients = makeDoubles("Gradient", count, 3);
  const auto normals = makeDoubles("Normals", count, 3);
  const auto types = makeInts("CriticalType", count);
  const Vector3d none = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto write = [&](vtkIdType point)
  {
    const Index vertex = map.vertexOf(point);
    const bool isThere = vertex != VertexMap::None;
    probabilities->SetValue(point, isThere ? samples.probability(vertex) : none.x());
    gradients->SetTypedTuple(point, isThere ? samples.gradient.col(vertex).data() : none.data());
    normals->SetTypedTuple(point, isThere ? samples.normal.col(vertex).data() : none.data());
    types->SetValue(
      point, static_cast<int>(isThere ? samples.type[vertex] : CriticalType::Excluded));
  };
  parallelFor(static_cast<std::size_t>(count), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto point = static_cast<vtkIdType>(begin); point < static_cast<vtkIdType>(end); ++point)
      {
        write(point);
      }
    });

  vtkPointData* data = output->GetPointData();
  const std::string name = makeRoom(
    run, data, { "CriticalProbability", "Gradient", "Normals", "CriticalType" }, valueName);
  data->AddArray(probabilities);
  data->AddArray(gradients);
  data->AddArray(normals);
  data->AddArray(types);
  data->SetActiveNormals("Normals");
  data->SetActiveScalars(name.c_str());
}

void writeCriticalPoints(const std::vector<CriticalPoint>& points, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(points.size());
  const auto places = vtkSmartPointer<vtkPoints>::New();
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(count);
  const auto types = makeInts("CriticalType", count);
  const auto multiplicities = makeInts("Multiplicity", count);
  const auto values = makeDoubles("ScalarValue", count);
  const auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName("PointId");
  ids->SetNumberOfValues(count);
  const auto persistences = makeDoubles("Persistence", count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const CriticalPoint& point = points[static_cast<std::size_t>(i)];
    places->SetPoint(i, point.position.data());
    types->SetValue(i, static_cast<int>(point.type));
    multiplicities->SetValue(i, point.multiplicity);
    values->SetValue(i, point.value);
    ids->SetValue(i, static_cast<vtkIdType>(point.input));
    persistences->SetValue(i, point.persistence);
  }
  output->SetPoints(places);
  output->SetVerts(makeVertices(count));
  vtkPointData* data = output->GetPointData();
  data->SetScalars(types);
  data->AddArray(multiplicities);
  data->AddArray(values);
  data->AddArray(ids);
  data->AddArray(persistences);
}

void writeFuzzyCriticalPoints(const std::vector<CriticalPoint>& points, vtkPolyData* output)
{
  writeCriticalPoints(points, output);
  const auto count = static_cast<vtkIdType>(points.size());
  const auto probabilities = makeDoubles("CriticalProbability", count);
  const auto residuals = makeDoubles("Residual", count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    probabilities->SetValue(i, points[static_cast<std::size_t>(i)].probability);
    residuals->SetValue(i, points[static_cast<std::size_t>(i)].residual);
  }
  output->GetPointData()->AddArray(probabilities);
  output->GetPointData()->AddArray(residuals);
}

} // namespace SurfaceScalars
