#include "vtkMeshlessApproximation.h"

#include "CriticalPointOutput.h"
#include "DomainInput.h"
#include "FieldModelData.h"
#include "FieldTarget.h"
#include "FilterRun.h"
#include "MeshOutput.h"
#include "MeshlessApproximation.h"
#include "OutputArrays.h"
#include "PropertyChoice.h"
#include "VolumeDomain.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMeshlessApproximation);

using namespace SurfaceScalars;

namespace
{

constexpr int ModelPort = 1;
constexpr int CriticalPort = 2;
constexpr const char* ErrorName = "ApproximationError";

// The shares of the whole that end with reading and with the topology.
constexpr double ReadShare = 0.05;
constexpr double TopologyShare = 0.1;

ApproximationParameters parametersOf(vtkMeshlessApproximation& filter)
{
  checkChoice(
    "CentreSelection", filter.GetCentreSelection(), { 0, 1 }, "0 (Greedy) or 1 (LevelSets)");
  checkChoice("LevelSetConstraints", filter.GetLevelSetConstraints(), { 0, 1, 2 },
    "0 (Interpolating), 1 (LeastSquares) or 2 (Minimax)");
  checkChoice("Kernel", filter.GetKernel(), { 0, 1, 2, 3, 4, 5, 6, 7, 8 },
    "0 (Gaussian), 1 (Exponential), 2 (Linear), 3 (Cubic), 4 (ThinPlate), 5 (Multiquadric), 6 "
    "(InverseMultiquadric), 7 (Wendland) or 8 (Wu)");
  checkFraction("PersistenceThreshold", filter.GetPersistenceThreshold());
  ApproximationParameters parameters;
  parameters.centerSelection = static_cast<CenterSelection>(filter.GetCentreSelection());
  parameters.levelSetConstraints =
    static_cast<LevelSetConstraints>(filter.GetLevelSetConstraints());
  parameters.kernel = static_cast<KernelType>(filter.GetKernel());
  parameters.kernelWidth = filter.GetKernelWidth();
  parameters.regularization = filter.GetRegularization();
  parameters.sampleFraction = filter.GetSampleFraction();
  parameters.coverageTolerance = filter.GetCoverageTolerance();
  parameters.persistenceThreshold = filter.GetPersistenceThreshold();
  return parameters;
}

MeshlessApproximation approximate(FilterRun& run, DomainInput& domain,
  const ApproximationParameters& parameters, const Execution& execution)
{
  const Execution ofTopology = execution.part(0.0, TopologyShare);
  const Execution rest = execution.part(TopologyShare, 1.0);
  if (domain.isVolume())
  {
    const VolumeTopology volume(static_cast<Index>(domain.vertices().cols()),
      std::move(domain.tetrahedra), ofTopology, domain.map().names());
    return approximateMeshless(
      volumeDomain(domain.vertices(), volume), domain.mesh.values, parameters, rest);
  }
  const MeshTopology mesh = topologyOf(run, domain.mesh, ofTopology);
  return approximateMeshless(
    surfaceDomain(domain.vertices(), mesh), domain.mesh.values, parameters, rest);
}

/// @param name of u
void writeValues(const FilterRun& run, const MeshlessApproximation& result,
  const DomainInput& domain, const std::string& name, vtkDataSet* output)
{
  vtkPointData* data = output->GetPointData();
  makeRoom(run, data, name);
  makeRoom(run, data, ErrorName);
  data->AddArray(makeDoubles(name, domain.map().atPoints(result.values)));
  data->AddArray(makeDoubles(ErrorName, domain.map().atPoints(domain.mesh.values - result.values)));
  data->SetActiveScalars(name.c_str());
}

/// @param scalarBytes of f's array
void writeFigures(
  const FilterRun& run, const MeshlessApproximation& result, double scalarBytes, vtkFieldData* data)
{
  const auto add = [&](const char* name, double figure)
  { addFieldData(run, makeDoubles(name, Values::Constant(1, figure)), data); };
  const auto modelBytes = static_cast<double>(bytesOf(result.model));
  add("LInfinityError", result.largestError);
  add("MeanError", result.meanError);
  add("ModelBytes", modelBytes);
  add("ScalarBytes", scalarBytes);
  add("SpaceSaving", 1.0 - modelBytes / scalarBytes);
  add("ConditionNumber", result.condition);
  const auto addCount = [&](const char* name, std::size_t count)
  { addFieldData(run, makeInt(name, static_cast<int>(count)), data); };
  addCount("CentreCount", static_cast<std::size_t>(result.model.centers.cols()));
  addCount("StarCount", static_cast<std::size_t>(result.starCount));
  addCount("Missing", result.lost.size());
}

void writeCritical(const MeshlessApproximation& result, const VertexMap& map, vtkPolyData* output)
{
  writeCriticalPoints(namedByPoints(result.critical.points, map), output);
  output->GetPointData()->AddArray(
    makeInts("Prescribed", { result.prescribed.begin(), result.prescribed.end() }));
}

/// Of the point array f. @param name f's, which may be a stand-in for none
double bytesOfScalars(vtkDataSet* input, const std::string& name)
{
  vtkPointData* data = input->GetPointData();
  vtkDataArray* array = data->GetArray(name.c_str());
  array = array ? array : data->GetScalars();
  return static_cast<double>(array->GetDataTypeSize()) *
    static_cast<double>(array->GetNumberOfTuples());
}

} // namespace

vtkMeshlessApproximation::vtkMeshlessApproximation()
{
  this->SetNumberOfOutputPorts(CriticalPort + 1);
}

vtkMeshlessApproximation::~vtkMeshlessApproximation()
{
  this->SetResultArrayName(nullptr);
}

int vtkMeshlessApproximation::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  return 1;
}

int vtkMeshlessApproximation::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  giveTypes(*this, vtkDataObject::GetData(inputs[0]), "vtkPolyData", outputs);
  return 1;
}

int vtkMeshlessApproximation::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  askForAll(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkMeshlessApproximation::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Meshless Approximation", outputs,
    [&](FilterRun& run)
    {
      const ApproximationParameters parameters = parametersOf(*this);
      vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
      const Execution& execution = run.execution();
      DomainInput domain = readDomain(run, execution.part(0.0, ReadShare), input);
      MeshlessApproximation result =
        approximate(run, domain, parameters, execution.part(ReadShare, 1.0));
      result.persistent = namedByPoints(std::move(result.persistent), domain.map());
      for (const std::string& remark : remarksOn(result))
      {
        run.note(remark);
      }

      const std::string& valueName = domain.mesh.valueName;
      const bool isNamed = this->ResultArrayName && *this->ResultArrayName;
      const std::string name =
        freeName(run, isNamed ? this->ResultArrayName : valueName + "Approximation", { ErrorName });
      vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
      output->ShallowCopy(input);
      writeValues(run, result, domain, name, output);
      writeFigures(run, result, bytesOfScalars(input, valueName), output->GetFieldData());
      writeModel({ result.model, valueName }, vtkPolyData::GetData(outputs, ModelPort));
      writeCritical(result, domain.map(), vtkPolyData::GetData(outputs, CriticalPort));
    });
}

void vtkMeshlessApproximation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CentreSelection: " << this->CentreSelection << "\n";
  os << indent << "LevelSetConstraints: " << this->LevelSetConstraints << "\n";
  os << indent << "SampleFraction: " << this->SampleFraction << "\n";
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "KernelWidth: " << this->KernelWidth << "\n";
  os << indent << "Regularization: " << this->Regularization << "\n";
  os << indent << "CoverageTolerance: " << this->CoverageTolerance << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
