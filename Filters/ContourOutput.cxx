#include "ContourOutput.h"

#include "OutputArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <numeric>

namespace SurfaceScalars
{
namespace
{

constexpr const char* NormalsName = "Normals";
constexpr const char* ResidualName = "Residual";
constexpr const char* ConvergedName = "Converged";

/// Points of level sets with the arrays that both ports have.
class LevelSetPoints
{
public:
  LevelSetPoints(const std::string& valueName, vtkIdType count)
    : values_(makeDoubles(valueName, count))
    , normals_(makeDoubles(NormalsName, count, 3))
    , residuals_(makeDoubles(ResidualName, count))
  {
    this->points_->SetDataTypeToDouble();
    this->points_->SetNumberOfPoints(count);
  }

  void set(vtkIdType id, const LevelSetPoint& point, double isoValue)
  {
    this->points_->SetPoint(id, point.position.data());
    this->values_->SetValue(id, isoValue);
    this->normals_->SetTypedTuple(id, point.normal.data());
    this->residuals_->SetValue(id, point.residual);
  }

  void giveTo(vtkPolyData* output) const
  {
    output->SetPoints(this->points_);
    vtkPointData* data = output->GetPointData();
    data->SetScalars(this->values_);
    data->SetNormals(this->normals_);
    data->AddArray(this->residuals_);
  }

private:
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkDoubleArray> values_;
  vtkSmartPointer<vtkDoubleArray> normals_;
  vtkSmartPointer<vtkDoubleArray> residuals_;
};

vtkIdType pointCount(const std::vector<LevelSetCurve>& curves)
{
  return std::accumulate(curves.begin(), curves.end(), vtkIdType{ 0 },
    [](vtkIdType sum, const LevelSetCurve& curve)
    { return sum + static_cast<vtkIdType>(curve.points.size()); });
}

/// The polyline of a curve whose points have the ids from `first` on.
void insertPolyline(const LevelSetCurve& curve, vtkIdType first, vtkCellArray* lines)
{
  const auto count = static_cast<vtkIdType>(curve.points.size());
  lines->InsertNextCell(static_cast<int>(count + (curve.closed ? 1 : 0)));
  for (vtkIdType id = first; id < first + count; ++id)
  {
    lines->InsertCellPoint(id);
  }
  if (curve.closed)
  {
    lines->InsertCellPoint(first);
  }
}

void writeCurveArrays(const LevelSets& sets, vtkCellData* data)
{
  const auto count = static_cast<vtkIdType>(sets.curves.size());
  const auto isoValues = makeDoubles("IsoValue", count);
  const auto components = makeInts("ComponentId", count);
  const auto closed = makeInts("Closed", count);
  const auto lengths = makeDoubles("Length", count);
  vtkIdType cell = 0;
  for (const LevelSetCurve& curve : sets.curves)
  {
    isoValues->SetValue(cell, sets.isoValues[curve.level]);
    components->SetValue(cell, curve.component);
    closed->SetValue(cell, curve.closed ? 1 : 0);
    lengths->SetValue(cell, curve.length);
    ++cell;
  }
  data->AddArray(isoValues);
  data->AddArray(components);
  data->AddArray(closed);
  data->AddArray(lengths);
}

/// How many curves each iso-value has: the evolution of the level sets.
void writeEvolution(const LevelSets& sets, vtkFieldData* data)
{
  const auto count = static_cast<vtkIdType>(sets.isoValues.size());
  const auto isoValues = makeDoubles("IsoValues", count);
  const auto components = makeInts("ComponentCounts", count);
  for (std::size_t level = 0; level < sets.isoValues.size(); ++level)
  {
    isoValues->SetValue(static_cast<vtkIdType>(level), sets.isoValues[level]);
    components->SetValue(static_cast<vtkIdType>(level), sets.componentCounts[level]);
  }
  data->AddArray(isoValues);
  data->AddArray(components);
}

} // namespace

std::string isoValueName(const FilterRun& run, const std::string& valueName)
{
  return freeName(run, valueName, { NormalsName, ResidualName, ConvergedName });
}

void writeContours(const LevelSets& sets, const std::string& valueName, vtkPolyData* output)
{
  LevelSetPoints points(valueName, pointCount(sets.curves));
  const auto lines = vtkSmartPointer<vtkCellArray>::New();
  vtkIdType id = 0;
  for (const LevelSetCurve& curve : sets.curves)
  {
    insertPolyline(curve, id, lines);
    for (const LevelSetPoint& point : curve.points)
    {
      points.set(id++, point, sets.isoValues[curve.level]);
    }
  }
  points.giveTo(output);
  output->SetLines(lines);
  writeCurveArrays(sets, output->GetCellData());
  writeEvolution(sets, output->GetFieldData());
}

void writeSamples(const LevelSets& sets, const std::string& valueName, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(sets.samples.size());
  LevelSetPoints points(valueName, count);
  const auto converged = makeInts(ConvergedName, count);
  vtkIdType id = 0;
  for (const LevelSetSample& sample : sets.samples)
  {
    points.set(id, sample.point, sets.isoValues[sample.level]);
    converged->SetValue(id++, sample.point.converged ? 1 : 0);
  }
  points.giveTo(output);
  output->GetPointData()->AddArray(converged);
  output->SetVerts(makeVertices(count));
}

} // namespace SurfaceScalars
