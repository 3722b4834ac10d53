#include "vtkConstrainedSmoothing.h"

#include "ConstrainedSmoothing.h"
#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "MeshInput.h"
#include "MeshMemory.h"
#include "MeshOutput.h"
#include "OutputArrays.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"
#include "Require.h"
#include "ScalarChoice.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkConstrainedSmoothing);

using namespace SurfaceScalars;

namespace
{

constexpr int TablePort = 2;
constexpr int ConstraintIndex = 1; // of SetInputArrayToProcess()

// The shares of the whole that end with reading and with what is kept of the mesh.
constexpr double ReadShare = 0.05;
constexpr double MeshShare = 0.15;

void checkChoices(vtkConstrainedSmoothing& filter)
{
  checkChoice("Method", filter.GetMethod(), { 0, 1, 2, 3 },
    "0 (FeaturePreserving), 1 (Tikhonov), 2 (InterpolatingConstraints) or "
    "3 (LeastSquaresConstraints)");
  checkChoice("Weights", filter.GetWeights(), { 3, 4, 5 },
    "3 (Cotangent), 4 (NormalizedCotangent) or 5 (MeanValue)");
  checkChoice(
    "Metric", filter.GetMetric(), { 0, 1, 2 }, "0 (Identity), 1 (MassMatrix) or 2 (LumpedMass)");
  checkChoice("Energy", filter.GetEnergy(), { 0, 1 }, "0 (Harmonic) or 1 (Biharmonic)");
  checkChoice(
    "EpsilonChoice", filter.GetEpsilonChoice(), { 0, 1, 2 }, "0 (GCV), 1 (LCurve) or 2 (Manual)");
  checkChoice("Constraints", filter.GetConstraints(), { 0, 1, 2, 3 },
    "0 (AllCriticalPoints), 1 (DeltaSimplified), 2 (Persistent) or 3 (MaskArray)");
}

bool usesMask(vtkConstrainedSmoothing& filter)
{
  return filter.GetConstraints() == vtkConstrainedSmoothing::MASK_ARRAY &&
    filter.GetMethod() != vtkConstrainedSmoothing::TIKHONOV;
}

/// Which vertices are marked. NaN marks none.
std::vector<char> readMask(vtkConstrainedSmoothing& filter, vtkPolyData* input,
  const std::string& valueName, const VertexMap& map, const Execution& execution)
{
  const char* name = filter.GetConstraintArray();
  require(name && *name, "a ConstraintArray, a point array that marks points", "none",
    "Choose one, or other Constraints.");
  require(name != valueName, "a ConstraintArray other than the function's own array",
    "'" + valueName + "'", "Choose one, or other Constraints.");
  const ScalarChoice choice = chooseScalars(filter, { input }, ConstraintIndex);
  Values marks(input->GetNumberOfPoints());
  copyNumbers(choice.arrays.front(), marks.data(), execution);
  std::vector<char> mask;
  for (const vtkIdType point : map.pointOfVertex)
  {
    mask.push_back(marks(point) != 0.0 && !std::isnan(marks(point)));
  }
  return mask;
}

SmoothingParameters parametersOf(vtkConstrainedSmoothing& filter)
{
  checkChoices(filter);
  SmoothingParameters parameters;
  parameters.method = static_cast<SmoothingMethod>(filter.GetMethod());
  parameters.norms.weights = static_cast<LaplacianWeights>(filter.GetWeights());
  parameters.norms.metric = static_cast<DataMetric>(filter.GetMetric());
  parameters.norms.energy = static_cast<SmoothingEnergy>(filter.GetEnergy());
  parameters.epsilonChoice = static_cast<EpsilonChoice>(filter.GetEpsilonChoice());
  parameters.epsilon = filter.GetEpsilon();
  parameters.constraints = static_cast<ConstraintChoice>(filter.GetConstraints());
  parameters.persistenceThreshold = filter.GetPersistenceThreshold();
  parameters.delta = filter.GetDelta();
  parameters.includeOneStars = filter.GetIncludeOneStars();
  parameters.smoothedStars = filter.GetSmoothedStars();
  return parameters;
}

/// Says at which points f's features were lost.
void noteLost(FilterRun& run, const std::vector<Index>& lost, const VertexMap& map)
{
  constexpr std::size_t most = 10; // points to be named
  if (lost.empty())
  {
    return;
  }
  std::string points;
  for (std::size_t i = 0; i < std::min(most, lost.size()); ++i)
  {
    points += (i > 0 ? ", " : "") + std::to_string(map.pointOfVertex[lost[i]]);
  }
  const bool isOne = lost.size() == 1;
  run.note((isOne ? "A persistent minimum or maximum"
                  : std::to_string(lost.size()) + " persistent minima and maxima") +
    std::string(" of the input ") + (isOne ? "has" : "have") +
    " no counterpart in the result: at point" + (isOne ? " " : "s ") + points +
    (lost.size() > most ? " and others" : "") +
    ". Raise Epsilon, or PersistenceThreshold if this is noise.");
}

void writeValues(const FilterRun& run, const Values& values, vtkPolyData* output)
{
  const char* given = static_cast<vtkConstrainedSmoothing&>(run.filter()).GetResultArrayName();
  const std::string name = given && *given ? given : "SmoothedScalars";
  vtkPointData* data = output->GetPointData();
  makeRoom(run, data, name);
  data->AddArray(makeDoubles(name, values));
  data->SetActiveScalars(name.c_str());
}

void writeMeasures(const FilterRun& run, const SmoothedFunction& smoothed,
  const MeshTopology& topology, vtkFieldData* data)
{
  const auto addNumber = [&](const char* name, double number)
  { addFieldData(run, makeDoubles(name, Values::Constant(1, number)), data); };
  addFieldData(run, makeCounts("InputCriticalCounts", smoothed.inputCounts), data);
  addFieldData(run, makeCounts("OutputCriticalCounts", smoothed.outputCounts), data);
  addFieldData(run, makeEulerCharacteristic(topology), data);
  addNumber("LInfinityError", smoothed.largestError);
  addNumber("SobolevSeminorm", smoothed.seminorm);
  addNumber("Epsilon", smoothed.epsilon);
}

} // namespace

vtkConstrainedSmoothing::vtkConstrainedSmoothing()
  : Memory(std::make_unique<MeshMemory<SmoothingMesh>>())
{
  this->SetNumberOfOutputPorts(TablePort + 1);
  this->SetResultArrayName("SmoothedScalars");
}

vtkConstrainedSmoothing::~vtkConstrainedSmoothing()
{
  this->SetResultArrayName(nullptr);
}

void vtkConstrainedSmoothing::SetConstraintArray(const char* name)
{
  this->SetInputArrayToProcess(
    ConstraintIndex, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name ? name : "");
}

const char* vtkConstrainedSmoothing::GetConstraintArray()
{
  return this->GetInputArrayInformation(ConstraintIndex)->Get(vtkDataObject::FIELD_NAME());
}

int vtkConstrainedSmoothing::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == TablePort ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkConstrainedSmoothing::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Constrained Smoothing", outputs,
    [&](FilterRun& run)
    {
      SmoothingParameters parameters = parametersOf(*this);
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      const Execution& execution = run.execution();
      const MeshInput mesh = readMesh(run, execution.part(0.0, ReadShare), input);
      const VertexMap& map = mesh.surface.map;
      if (usesMask(*this))
      {
        parameters.mask =
          readMask(*this, input, mesh.valueName, map, execution.part(ReadShare, ReadShare));
      }
      const SmoothingMesh& known =
        this->Memory->meshOf(mesh.surface, execution.part(ReadShare, MeshShare));
      noteSeams(run, mesh.surface, known.topology(), mesh.values);
      const SmoothedFunction smoothed =
        smoothFunction(known, mesh.values, parameters, execution.part(MeshShare, 1.0));
      noteLost(run, smoothed.lost, map);

      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      output->ShallowCopy(input);
      writeValues(run, map.atPoints(smoothed.values), output);
      writeMeasures(run, smoothed, known.topology(), output->GetFieldData());
      writeCriticalPoints(
        namedByPoints(smoothed.critical.points, map), vtkPolyData::GetData(outputs, 1));
      writeParameterCurve(smoothed.curve, vtkTable::GetData(outputs, TablePort));
    });
}

void vtkConstrainedSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* mask = this->GetConstraintArray();
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "Metric: " << this->Metric << "\n";
  os << indent << "Energy: " << this->Energy << "\n";
  os << indent << "EpsilonChoice: " << this->EpsilonChoice << "\n";
  os << indent << "Epsilon: " << this->Epsilon << "\n";
  os << indent << "Constraints: " << this->Constraints << "\n";
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "Delta: " << this->Delta << "\n";
  os << indent << "ConstraintArray: " << (mask ? mask : "(none)") << "\n";
  os << indent << "IncludeOneStars: " << this->IncludeOneStars << "\n";
  os << indent << "SmoothedStars: " << this->SmoothedStars << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
