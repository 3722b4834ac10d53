#include "vtkMeshCriticalPoints.h"

#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "MeshInput.h"
#include "MeshOutput.h"
#include "PropertyChoice.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMeshCriticalPoints);

using namespace SurfaceScalars;

namespace
{

constexpr int TablePort = 3;

// The shares of the whole that end with reading, topology, types and thresholds.
constexpr double ReadShare = 0.2;
constexpr double TopologyShare = 0.4;
constexpr double TypeShare = 0.5;
constexpr double DeltaShare = 0.6;

/// Fractions of the range, 0 and then 1e-4 to 1, evenly on a logarithmic axis: noise is near 0.
std::vector<double> curveThresholds()
{
  constexpr int decades = 4;
  constexpr int stepsPerDecade = 25;
  std::vector<double> thresholds{ 0.0 };
  for (int step = -decades * stepsPerDecade; step <= 0; ++step)
  {
    thresholds.push_back(std::pow(10.0, static_cast<double>(step) / stepsPerDecade));
  }
  return thresholds;
}

/// All critical points, how they vanish, and what is to be shown of them.
struct Found
{
  std::vector<CriticalPoint> points; ///< that reach both thresholds
  std::vector<CriticalPair> pairs;   ///< of these
  SimplificationCurve curve;         ///< of all
};

/// The pairs both of whose points are left. @param all by vertex, as are the points left
std::vector<CriticalPair> pairsAmong(
  const std::vector<CriticalPoint>& left, const MeshCriticalPoints& all, double threshold)
{
  const auto positionOf = [&](std::size_t index)
  {
    const std::size_t vertex = all.points[index].input;
    const auto found = std::lower_bound(left.begin(), left.end(), vertex,
      [](const CriticalPoint& point, std::size_t input) { return point.input < input; });
    const bool isThere = found != left.end() && found->input == vertex;
    return isThere ? static_cast<std::size_t>(found - left.begin()) : left.size();
  };
  std::vector<CriticalPair> pairs;
  for (const CriticalPair& pair : all.pairs)
  {
    const CriticalPair renamed{ positionOf(pair.extremum), positionOf(pair.saddle),
      pair.persistence };
    if (pair.persistence >= threshold && renamed.extremum < left.size() &&
      renamed.saddle < left.size())
    {
      pairs.push_back(renamed);
    }
  }
  return pairs;
}

Found findCriticalPoints(vtkMeshCriticalPoints& filter, const MeshInput& mesh,
  const MeshTopology& topology, const Execution& execution)
{
  const VertexTypes types =
    classifyVertices(topology, mesh.values, execution.part(TopologyShare, TypeShare));
  const Values deltas =
    deltaThresholds(topology, mesh.values, types, execution.part(TypeShare, DeltaShare));
  const MeshCriticalPoints all = meshCriticalPoints(
    mesh.surface.vertices, topology, mesh.values, execution.part(DeltaShare, 1.0));
  const double range = mesh.values.maxCoeff() - mesh.values.minCoeff();
  const double persistence = filter.GetPersistenceThreshold() * range;

  Found found;
  found.curve = simplificationCurve(all, deltas, range, curveThresholds());
  found.points = all.points;
  removeBelow(found.points, all.pairs, persistence);
  removeUpToDelta(found.points, deltas, filter.GetDelta() * range);
  found.pairs = pairsAmong(found.points, all, persistence);
  found.points = namedByPoints(std::move(found.points), mesh.surface.map);
  return found;
}

} // namespace

vtkMeshCriticalPoints::vtkMeshCriticalPoints()
{
  this->SetNumberOfOutputPorts(TablePort + 1);
}

vtkMeshCriticalPoints::~vtkMeshCriticalPoints() = default;

int vtkMeshCriticalPoints::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == TablePort ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkMeshCriticalPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Mesh Critical Points", outputs,
    [&](FilterRun& run)
    {
      checkFraction("PersistenceThreshold", this->PersistenceThreshold);
      checkFraction("Delta", this->Delta);
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      const Execution& execution = run.execution();
      const MeshInput mesh = readMesh(run, execution.part(0.0, ReadShare), input);
      const MeshTopology topology = topologyOf(run, mesh, execution.part(ReadShare, TopologyShare));
      const Found found = findCriticalPoints(*this, mesh, topology, execution);

      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      output->ShallowCopy(input);
      writeTypes(found.points, mesh.surface.map, mesh.valueName, run, output);
      writeCriticalPoints(found.points, vtkPolyData::GetData(outputs, 1));
      writeSummary(run, found.points, topology, outputs);
      writePairs(found.points, found.pairs, vtkPolyData::GetData(outputs, 2));
      writeSimplification(found.curve, vtkTable::GetData(outputs, TablePort));
    });
}

void vtkMeshCriticalPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "Delta: " << this->Delta << "\n";
}
