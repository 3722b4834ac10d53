#include "vtkScalarFunctionDesign.h"

#include "CriticalRequests.h"
#include "DesignOutput.h"
#include "FilterRun.h"
#include "FunctionDesign.h"
#include "MeshInput.h"
#include "MeshMemory.h"
#include "MeshOutput.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"
#include "RefinedOutput.h"
#include "Require.h"
#include "ScalarChoice.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkScalarFunctionDesign);

using namespace SurfaceScalars;

namespace
{

constexpr int CriticalPort = 1;
constexpr int TablePort = 2;

// The shares of the whole that end with reading, with what is kept of the mesh, and the requests.
constexpr double ReadShare = 0.05;
constexpr double MeshShare = 0.1;
constexpr double RequestShare = 0.2;

void checkChoices(vtkScalarFunctionDesign& filter)
{
  checkChoice("Approach", filter.GetApproach(), { 0, 1 }, "0 (MeshBased) or 1 (Meshless)");
  checkChoice("ConstraintType", filter.GetConstraintType(), { 0, 1 },
    "0 (Interpolating) or 1 (LeastSquares)");
  checkChoice("Energy", filter.GetEnergy(), { 0, 1 }, "0 (Harmonic) or 1 (Biharmonic)");
  checkChoice(
    "Metric", filter.GetMetric(), { 0, 1, 2 }, "0 (Identity), 1 (MassMatrix) or 2 (LumpedMass)");
  checkChoice("EpsilonChoice", filter.GetEpsilonChoice(), { 1, 2 }, "1 (LCurve) or 2 (Manual)");
  checkChoice("Kernel", filter.GetKernel(), { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 },
    "0 (Gaussian), 1 (Exponential), 2 (Linear), 3 (Cubic), 4 (ThinPlate), 5 (Multiquadric), "
    "6 (InverseMultiquadric), 7 (Wendland), 8 (Wu) or 9 (Harmonic)");
  checkFraction("PersistenceThreshold", filter.GetPersistenceThreshold());
}

DesignParameters parametersOf(vtkScalarFunctionDesign& filter)
{
  checkChoices(filter);
  DesignParameters parameters;
  parameters.approach = static_cast<DesignApproach>(filter.GetApproach());
  parameters.constraints = static_cast<DesignConstraints>(filter.GetConstraintType());
  parameters.energy = static_cast<SmoothingEnergy>(filter.GetEnergy());
  parameters.metric = static_cast<DataMetric>(filter.GetMetric());
  parameters.kernel = static_cast<KernelType>(filter.GetKernel());
  parameters.kernelWidth = filter.GetKernelWidth();
  parameters.epsilonChoice = static_cast<EpsilonChoice>(filter.GetEpsilonChoice());
  parameters.epsilon = filter.GetEpsilon();
  parameters.cleanUp = filter.GetCleanUp();
  return parameters;
}

bool hasTemplate(vtkScalarFunctionDesign& filter)
{
  const char* name = filter.GetTemplateArray();
  return name && *name && std::string(name) != "None"; // which is what panels say for none
}

/// @throws InvalidInput if nothing is asked for
CriticalRequests readRequests(
  FilterRun& run, vtkScalarFunctionDesign& filter, vtkInformationVector* port)
{
  CriticalRequests asked = readRequests(run, vtkDataObject::GetData(port));
  require(!asked.requests.empty() || hasTemplate(filter),
    "CriticalPoints with a minimum, saddle or maximum (CriticalType 0, 1 or 3), or a TemplateArray",
    "neither", "Choose points that have this array, or an array of the mesh.");
  return asked;
}

/// Splits the triangles around saddles that need it.
RefinedMesh refine(
  const MeshedSurface& surface, const MeshTopology& topology, const CriticalRequests& asked)
{
  std::vector<NeededLink> needed;
  for (const CriticalRequest& request : asked.requests)
  {
    needed.push_back({ request.vertex, neededLinkSize(topology, request) });
  }
  return refineStars(surface.vertices, topology, needed, surface.map.names());
}

/// The template's values at the vertices of the refined mesh.
Values templateValues(vtkScalarFunctionDesign& filter, vtkPolyData* input, const VertexMap& map,
  const RefinedMesh& refined)
{
  const ScalarChoice choice = chooseScalars(filter, { input });
  Values values(input->GetNumberOfPoints());
  copyNumbers(choice.arrays.front(), values.data(), {});
  const std::vector<vtkIdType> given(map.pointOfVertex.begin(),
    map.pointOfVertex.end() - static_cast<std::ptrdiff_t>(refined.added.size()));
  return refinedValues(values(given), refined);
}

} // namespace

vtkScalarFunctionDesign::vtkScalarFunctionDesign()
  : Given(std::make_unique<MeshMemory<DesignMesh>>())
  , Refined(std::make_unique<MeshMemory<DesignMesh>>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(TablePort + 1);
  this->SetTemplateArray(nullptr);
  this->SetResultArrayName("DesignedScalars");
}

vtkScalarFunctionDesign::~vtkScalarFunctionDesign()
{
  this->SetResultArrayName(nullptr);
}

void vtkScalarFunctionDesign::SetCriticalPointsConnection(vtkAlgorithmOutput* connection)
{
  this->SetInputConnection(CriticalPort, connection);
}

void vtkScalarFunctionDesign::SetCriticalPointsData(vtkDataObject* data)
{
  this->SetInputDataInternal(CriticalPort, data);
}

void vtkScalarFunctionDesign::RemoveCriticalPoints()
{
  this->SetCriticalPointsConnection(nullptr);
}

void vtkScalarFunctionDesign::SetTemplateArray(const char* name)
{
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name ? name : "");
}

const char* vtkScalarFunctionDesign::GetTemplateArray()
{
  return this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
}

int vtkScalarFunctionDesign::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, information);
  }
  acceptPointSets(information);
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkScalarFunctionDesign::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == TablePort ? "vtkTable" : "vtkPolyData");
  return 1;
}

/// The time steps of the critical points, if the mesh has none.
int vtkScalarFunctionDesign::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* points = inputs[CriticalPort]->GetInformationObject(0); // null if there are none
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* output = outputs->GetInformationObject(port);
    if (points && !output->Has(Pipeline::TIME_RANGE()))
    {
      output->CopyEntry(points, Pipeline::TIME_STEPS());
      output->CopyEntry(points, Pipeline::TIME_RANGE());
    }
  }
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

int vtkScalarFunctionDesign::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Scalar Function Design", outputs,
    [&](FilterRun& run)
    {
      const DesignParameters parameters = parametersOf(*this);
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      const Execution& execution = run.execution();
      CriticalRequests asked = readRequests(run, *this, inputs[CriticalPort]);
      const MeshedSurface given = readSurface(run, execution.part(0.0, ReadShare), input);
      const DesignMesh* mesh = &this->Given->meshOf(given, execution.part(ReadShare, MeshShare));
      noteSeams(run, given, mesh->topology(), {});
      snapRequests(asked, given, mesh->topology(), this->MaximumDistance);

      const RefinedMesh refined = refine(given, mesh->topology(), asked);
      const MeshedSurface surface = refinedSurface(given, refined);
      const Execution prepare = execution.part(MeshShare, RequestShare);
      if (!refined.added.empty())
      {
        mesh = &this->Refined->meshOf(surface, prepare.part(0.0, 0.5));
      }
      if (hasTemplate(*this))
      {
        const Values values = templateValues(*this, input, surface.map, refined);
        addTemplate(run, mesh->topology(),
          requestsOf(surface.vertices, mesh->topology(), values, this->PersistenceThreshold,
            prepare.part(0.5, 1.0)),
          asked);
      }
      const PlaceName names = namesOf(asked, surface.map);
      const DesignedFunction designed =
        designFunction(*mesh, asked.requests, parameters, execution.part(RequestShare, 1.0), names);
      noteMissing(run, designed, names);

      const char* name = this->ResultArrayName;
      passRefined(run, input, given, refined, vtkPolyData::GetData(outputs, 0));
      writeDesign(run, designed, { mesh->topology(), surface.map },
        name && *name ? name : "DesignedScalars", outputs);
      writeParameterCurve(designed.curve, vtkTable::GetData(outputs, TablePort));
    });
}

void vtkScalarFunctionDesign::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* array = this->GetTemplateArray();
  os << indent << "Approach: " << this->Approach << "\n";
  os << indent << "ConstraintType: " << this->ConstraintType << "\n";
  os << indent << "CleanUp: " << this->CleanUp << "\n";
  os << indent << "Energy: " << this->Energy << "\n";
  os << indent << "Metric: " << this->Metric << "\n";
  os << indent << "EpsilonChoice: " << this->EpsilonChoice << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "KernelWidth: " << this->KernelWidth << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "TemplateArray: " << (array ? array : "(none)") << "\n";
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
