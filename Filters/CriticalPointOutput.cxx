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

Eigen::Map<Points> asPoints(vtkDoubleArray* array)
{
  return { array->GetPointer(0), 3, array->GetNumberOfTuples() };
}

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
  Eigen::Map<Points> gradientAt = asPoints(gradients);
  Eigen::Map<Points> normalAt = asPoints(normals);
  const Vector3d none = Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  // One array after the other: samples lie in another order than points, and more accesses to one
  // array wait for memory at a time than to four.
  const auto write = [&](double from, double to, const auto& writePoint)
  {
    parallelFor(static_cast<std::size_t>(count), Grain, execution.part(from, to),
      [&](std::size_t begin, std::size_t end)
      {
        for (auto point = static_cast<vtkIdType>(begin); point < static_cast<vtkIdType>(end);
             ++point)
        {
          const Index vertex = map.vertexOf(point);
          writePoint(point, vertex, vertex != VertexMap::None);
        }
      });
  };
  write(0.0, 0.2,
    [&](vtkIdType point, Index vertex, bool isThere)
    { probabilities->SetValue(point, isThere ? samples.probability(vertex) : none.x()); });
  write(0.2, 0.5,
    [&](vtkIdType point, Index vertex, bool isThere)
    { gradientAt.col(point) = isThere ? Vector3d(samples.gradient.col(vertex)) : none; });
  write(0.5, 0.8,
    [&](vtkIdType point, Index vertex, bool isThere)
    { normalAt.col(point) = isThere ? Vector3d(samples.normal.col(vertex)) : none; });
  write(0.8, 1.0,
    [&](vtkIdType point, Index vertex, bool isThere)
    {
      const CriticalType type = isThere ? samples.type[vertex] : CriticalType::Excluded;
      types->SetValue(point, static_cast<int>(type));
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

void writeModelCriticalPoints(const std::vector<ModelCriticalPoint>& points, vtkPolyData* output)
{
  std::vector<CriticalPoint> places;
  Values residuals(static_cast<Eigen::Index>(points.size()));
  std::vector<int> iterations;
  std::vector<int> refined;
  std::vector<int> ends;
  for (const ModelCriticalPoint& point : points)
  {
    residuals[static_cast<Eigen::Index>(places.size())] = point.point.residual;
    places.push_back(point.point);
    iterations.push_back(point.iterations);
    refined.push_back(point.isRefined() ? 1 : 0);
    ends.push_back(static_cast<int>(point.end));
  }
  writeCriticalPoints(places, output);
  output->GetPointData()->AddArray(makeDoubles("Residual", residuals));
  output->GetPointData()->AddArray(makeInts("Iterations", iterations));
  output->GetPointData()->AddArray(makeInts("Refined", refined));
  output->GetPointData()->AddArray(makeInts("RefinementEnd", ends));
}

} // namespace SurfaceScalars
