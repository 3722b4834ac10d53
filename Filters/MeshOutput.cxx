#include "MeshOutput.h"

#include "CriticalPointOutput.h"
#include "OutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <utility>

namespace SurfaceScalars
{
namespace
{

void addCounts(
  const std::string& prefix, const std::vector<CriticalCounts>& counts, vtkTable* output)
{
  const auto addColumn = [&](const char* name, Index CriticalCounts::*count)
  {
    std::vector<int> numbers(counts.size());
    std::transform(counts.begin(), counts.end(), numbers.begin(),
      [count](const CriticalCounts& step) { return static_cast<int>(step.*count); });
    output->AddColumn(makeInts(prefix + name, numbers));
  };
  addColumn("Minima", &CriticalCounts::minima);
  addColumn("Saddles", &CriticalCounts::saddles);
  addColumn("Maxima", &CriticalCounts::maxima);
}

} // namespace

std::vector<CriticalPoint> namedByPoints(std::vector<CriticalPoint> points, const VertexMap& map)
{
  for (CriticalPoint& point : points)
  {
    point.input = static_cast<std::size_t>(map.pointOfVertex[point.input]);
  }
  return points;
}

void writeTypes(const std::vector<CriticalPoint>& points, const VertexMap& map,
  const std::string& valueName, const FilterRun& run, vtkPolyData* output)
{
  const vtkIdType count = map.pointCount();
  const auto types = makeInts("CriticalType", count);
  const auto multiplicities = makeInts("Multiplicity", count);
  for (vtkIdType point = 0; point < count; ++point)
  {
    const bool isThere = map.vertexOf(point) != VertexMap::None;
    types->SetValue(
      point, static_cast<int>(isThere ? CriticalType::Regular : CriticalType::Excluded));
    multiplicities->SetValue(point, 0);
  }
  for (const CriticalPoint& point : points)
  {
    types->SetValue(static_cast<vtkIdType>(point.input), static_cast<int>(point.type));
    multiplicities->SetValue(static_cast<vtkIdType>(point.input), point.multiplicity);
  }
  vtkPointData* data = output->GetPointData();
  const std::string name = makeRoom(run, data, { "CriticalType", "Multiplicity" }, valueName);
  data->AddArray(types);
  data->AddArray(multiplicities);
  data->SetActiveScalars(name.c_str());
}

vtkSmartPointer<vtkIntArray> makeCounts(const std::string& name, const CriticalCounts& counts)
{
  return makeInts(name,
    { static_cast<int>(counts.minima), static_cast<int>(counts.saddles),
      static_cast<int>(counts.maxima) });
}

vtkSmartPointer<vtkIntArray> makeEulerCharacteristic(const MeshTopology& topology)
{
  return makeInt("EulerCharacteristic", static_cast<int>(topology.eulerCharacteristic()));
}

void writeSummary(const FilterRun& run, const std::vector<CriticalPoint>& points,
  const MeshTopology& topology, vtkInformationVector* outputs)
{
  vtkFieldData* first = vtkPolyData::GetData(outputs, 0)->GetFieldData();
  vtkFieldData* second = vtkPolyData::GetData(outputs, 1)->GetFieldData();
  for (const auto& array :
    { makeCounts("CriticalCounts", countsOf(points)), makeEulerCharacteristic(topology) })
  {
    addFieldData(run, array, first);
    second->AddArray(array);
  }
}

void writePairs(const std::vector<CriticalPoint>& points, const std::vector<CriticalPair>& pairs,
  vtkPolyData* output)
{
  writeCriticalPoints(points, output);
  const auto lines = vtkSmartPointer<vtkCellArray>::New();
  const auto count = static_cast<vtkIdType>(pairs.size());
  const auto persistences = makeDoubles("Persistence", count);
  const auto types = makeInts("PairType", count);
  for (vtkIdType line = 0; line < count; ++line)
  {
    const CriticalPair& pair = pairs[static_cast<std::size_t>(line)];
    lines->InsertNextCell(
      { static_cast<vtkIdType>(pair.extremum), static_cast<vtkIdType>(pair.saddle) });
    persistences->SetValue(line, pair.persistence);
    types->SetValue(line, points[pair.extremum].type == CriticalType::Minimum ? 0 : 1);
  }
  output->SetVerts(nullptr);
  output->SetLines(lines);
  output->GetCellData()->SetScalars(persistences);
  output->GetCellData()->AddArray(types);
}

void writeSimplification(const SimplificationCurve& curve, vtkTable* output)
{
  output->AddColumn(makeDoubles("Threshold",
    Eigen::Map<const Values>(
      curve.thresholds.data(), static_cast<Eigen::Index>(curve.thresholds.size()))));
  addCounts("Delta", curve.byDelta, output);
  addCounts("Persistence", curve.byPersistence, output);
}

void writeParameterCurve(const ParameterCurve& curve, vtkTable* output)
{
  output->AddColumn(makeDoubles("Epsilon", curve.epsilons));
  output->AddColumn(makeDoubles("Residual", curve.residuals));
  output->AddColumn(makeDoubles("Seminorm", curve.seminorms));
  output->AddColumn(makeDoubles("GCV", curve.gcv));
  output->AddColumn(makeDoubles("Curvature", curve.curvatures));
}

} // namespace SurfaceScalars
