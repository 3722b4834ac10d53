#include "DesignOutput.h"

#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "MeshOutput.h"
#include "OutputArrays.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <vector>

namespace SurfaceScalars
{
namespace
{

void writeValues(
  const FilterRun& run, const Values& values, const std::string& name, vtkPolyData* output)
{
  vtkPointData* data = output->GetPointData();
  makeRoom(run, data, name);
  data->AddArray(makeDoubles(name, values));
  data->SetActiveScalars(name.c_str());
}

void addToBoth(const FilterRun& run, vtkDataArray* array, vtkInformationVector* outputs)
{
  addFieldData(run, array, vtkPolyData::GetData(outputs, 0)->GetFieldData());
  vtkPolyData::GetData(outputs, 1)->GetFieldData()->AddArray(array);
}

} // namespace

void noteMissing(FilterRun& run, const DesignedFunction& designed, const PlaceName& nameOf)
{
  constexpr std::size_t most = 10; // to be named
  const std::size_t count = designed.missing.size();
  if (count == 0)
  {
    return;
  }
  std::string names;
  for (std::size_t i = 0; i < std::min(most, count); ++i)
  {
    names += (i > 0 ? ", " : "") + nameOf(designed.missing[i]);
  }
  run.note(std::to_string(count) +
    (count == 1 ? " critical point that was asked for is"
                : " critical points that were asked for are") +
    " not there in the result: " + names + (count > most ? " and others" : "") + ".");
}

void writeDesign(const FilterRun& run, const DesignedFunction& designed, const OutputMesh& mesh,
  const std::string& name, vtkInformationVector* outputs)
{
  writeValues(run, mesh.map.atPoints(designed.values), name, vtkPolyData::GetData(outputs, 0));
  const std::vector<CriticalPoint> points = namedByPoints(designed.critical.points, mesh.map);
  const std::vector<int> prescribed(designed.prescribed.begin(), designed.prescribed.end());
  vtkPolyData* found = vtkPolyData::GetData(outputs, 1);
  writeCriticalPoints(points, found);
  found->GetPointData()->AddArray(makeInts("Prescribed", prescribed));
  writeSummary(run, points, mesh.topology, outputs);
  const auto added = std::count(prescribed.begin(), prescribed.end(), 0);
  addToBoth(run, makeInt("Missing", static_cast<int>(designed.missing.size())), outputs);
  addToBoth(run, makeInt("Added", static_cast<int>(added)), outputs);
  addToBoth(run, makeDoubles("Epsilon", Values::Constant(1, designed.epsilon)), outputs);
}

} // namespace SurfaceScalars
