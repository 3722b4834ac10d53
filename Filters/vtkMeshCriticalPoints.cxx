#include "vtkMeshCriticalPoints.h"

#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "ListedPoints.h"
#include "MeshInput.h"
#include "MeshOutput.h"
#include "ModelOnMesh.h"
#include "OutputArrays.h"
#include "PropertyChoice.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMeshCriticalPoints);

using namespace SurfaceScalars;

namespace
{

constexpr int ModelPort = 1;
constexpr int TablePort = 3;

/// The shares of the whole that end with a model, reading, topology and critical vertices.
struct Shares
{
  double model;
  double read;
  double topology;
  double vertices;
};
constexpr Shares WithoutModel{ 0.0, 0.2, 0.4, 1.0 };
constexpr Shares WithModel{ 0.05, 0.7, 0.75, 0.9 };

// Of finding critical vertices.
constexpr double TypeShare = 0.2;
constexpr double DeltaShare = 0.4;

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

/// The critical vertices that reach both thresholds, and how all of them vanish.
struct Found
{
  MeshCriticalPoints critical;
  SimplificationCurve curve; ///< of all but those that another piece lists
};

Found findCriticalPoints(vtkMeshCriticalPoints& filter, const MeshInput& mesh,
  const OtherVertices& others, const MeshTopology& topology, const Execution& execution)
{
  const VertexTypes types = classifyVertices(topology, mesh.values, execution.part(0.0, TypeShare));
  const Values deltas =
    deltaThresholds(topology, mesh.values, types, execution.part(TypeShare, DeltaShare));
  const MeshCriticalPoints all = meshCriticalPoints(
    mesh.surface.vertices, topology, mesh.values, execution.part(DeltaShare, 1.0));
  const double range = mesh.values.maxCoeff() - mesh.values.minCoeff();
  const double persistence = filter.GetPersistenceThreshold() * range;

  Found found;
  found.curve = simplificationCurve(others.without(all), deltas, range, curveThresholds());
  found.critical.points = all.points;
  removeBelow(found.critical.points, all.pairs, persistence);
  removeUpToDelta(found.critical.points, deltas, filter.GetDelta() * range);
  found.critical.pairs = pairsAmong(found.critical.points, all, persistence);
  return found;
}

/// The values of a model at the points, NaN at those that are not part of the surface.
/// @returns the array's name
std::string writeValues(const FilterRun& run, const MeshInput& mesh, vtkPolyData* output)
{
  std::string name = freeName(run, mesh.valueName, { "CriticalType", "Multiplicity" });
  makeRoom(run, output->GetPointData(), name);
  output->GetPointData()->AddArray(makeDoubles(name, mesh.surface.map.atPoints(mesh.values)));
  return name;
}

/// Ports 1 and 2, and the field data of ports 0 and 1.
void writeRefined(FilterRun& run, ModelCriticalPoints refined, const NamedField& model,
  const MeshInput& mesh, const OtherVertices& others, const MeshTopology& topology,
  const MeshCriticalPoints& candidates, vtkInformationVector* outputs)
{
  writeRefinement(run, refined, candidates.points.size(), model.field, topology, outputs);
  others.removeFrom(refined.points);
  const std::vector<CriticalPair> pairs = pairsAmong(refined.points, candidates, 0.0);
  std::vector<CriticalPoint> places;
  for (ModelCriticalPoint& point : refined.points)
  {
    point.point.input = static_cast<std::size_t>(mesh.surface.map.pointOfVertex[point.point.input]);
    places.push_back(point.point);
  }
  writeModelCriticalPoints(refined.points, vtkPolyData::GetData(outputs, 1));
  writeSummary(run, places, topology, outputs);
  writePairs(places, pairs, vtkPolyData::GetData(outputs, 2));
}

} // namespace

vtkMeshCriticalPoints::vtkMeshCriticalPoints()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(TablePort + 1);
}

vtkMeshCriticalPoints::~vtkMeshCriticalPoints() = default;

void vtkMeshCriticalPoints::SetModelConnection(vtkAlgorithmOutput* connection)
{
  this->SetInputConnection(ModelPort, connection);
}

void vtkMeshCriticalPoints::SetModelData(vtkDataObject* data)
{
  this->SetInputDataInternal(ModelPort, data);
}

void vtkMeshCriticalPoints::RemoveModel()
{
  this->SetModelConnection(nullptr);
}

int vtkMeshCriticalPoints::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port != ModelPort)
  {
    return this->Superclass::FillInputPortInformation(port, information);
  }
  // Of any type: RequestData() says better what is wrong with others.
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

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
      vtkDataObject* modelData = vtkDataObject::GetData(inputs[ModelPort]);
      const Shares& shares = modelData ? WithModel : WithoutModel;
      const auto model = modelOfPort(modelData, execution.part(0.0, shares.model));
      const Execution reading = execution.part(shares.model, shares.read);
      const MeshInput mesh = model ? readMesh(run, reading, input, placeFunctionOf(run, *model))
                                   : readMesh(run, reading, input);
      const MeshTopology topology =
        topologyOf(run, mesh, execution.part(shares.read, shares.topology));
      const OtherVertices others(input, mesh.surface.map);
      const Found found = findCriticalPoints(
        *this, mesh, others, topology, execution.part(shares.topology, shares.vertices));

      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      output->ShallowCopy(input);
      const std::vector<CriticalPoint> marked =
        namedByPoints(found.critical.points, mesh.surface.map);
      if (model)
      {
        const std::string name = writeValues(run, mesh, output);
        writeTypes(marked, mesh.surface.map, name, run, output);
        ModelCriticalPoints refined = refineOnModel(mesh.surface.vertices, topology, mesh.values,
          model->field, found.critical, execution.part(shares.vertices, 1.0));
        writeRefined(
          run, std::move(refined), *model, mesh, others, topology, found.critical, outputs);
      }
      else
      {
        writeTypes(marked, mesh.surface.map, mesh.valueName, run, output);
        std::vector<CriticalPoint> listed = found.critical.points;
        others.removeFrom(listed);
        const std::vector<CriticalPair> pairs = pairsAmong(listed, found.critical, 0.0);
        listed = namedByPoints(std::move(listed), mesh.surface.map);
        writeCriticalPoints(listed, vtkPolyData::GetData(outputs, 1));
        writeSummary(run, listed, topology, outputs);
        writePairs(listed, pairs, vtkPolyData::GetData(outputs, 2));
      }
      writeSimplification(found.curve, vtkTable::GetData(outputs, TablePort));
    });
}

void vtkMeshCriticalPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "Delta: " << this->Delta << "\n";
}
