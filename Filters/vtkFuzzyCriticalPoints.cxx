#include "vtkFuzzyCriticalPoints.h"

#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "FuzzyCriticalPoints.h"
#include "ImplicitFunction.h"
#include "NeighborGraph.h"
#include "NumberText.h"
#include "OutputArrays.h"
#include "PassThrough.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImplicitFunction.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkFuzzyCriticalPoints);

using namespace SurfaceScalars;

namespace
{

// The shares of the whole that end with reading, with the neighbor graph and with the search.
constexpr double ReadShare = 0.02;
constexpr double GraphShare = 0.4;
constexpr double SearchShare = 0.96;

CriticalPointParameters parametersOf(vtkFuzzyCriticalPoints& filter)
{
  checkChoice("Scheme", filter.GetScheme(), { 1, 2, 3, 4 },
    "1 (ExplicitMLS), 2 (ParameterizedMLS), 3 (LocalRBF) or 4 (Hybrid)");
  checkChoice("Kernel", filter.GetKernel(), { 0, 1, 2, 3, 4, 5, 6, 7, 8 },
    "from 0 (Gaussian) to 8 (Wu), such as 3 (Cubic)");
  checkChoice(
    "ProbabilityModel", filter.GetProbabilityModel(), { 0, 1 }, "0 (Gradient) or 1 (NormalAngle)");

  CriticalPointParameters parameters;
  parameters.scheme = static_cast<Scheme>(filter.GetScheme());
  parameters.polynomialDegree = filter.GetPolynomialDegree();
  parameters.neighborCount = filter.GetNeighborCount();
  parameters.searchRadius = filter.GetSearchRadius();
  parameters.kernel = static_cast<KernelType>(filter.GetKernel());
  parameters.kernelWidth = filter.GetKernelWidth();
  parameters.probabilityModel = static_cast<ProbabilityModel>(filter.GetProbabilityModel());
  parameters.volumeFunction = volumeFunctionOf(filter.GetVolumeFunction());
  parameters.probabilityThreshold = filter.GetProbabilityThreshold();
  parameters.persistenceThreshold = filter.GetPersistenceThreshold();
  parameters.refine = filter.GetRefine();
  return parameters;
}

void noteConstant(FilterRun& run, const Samples& samples, const Values& values)
{
  if (values.minCoeff() == values.maxCoeff())
  {
    run.note("'" + samples.valueName + "' is " + textOf(values(0)) +
      " everywhere: a constant function has no critical points.");
  }
}

void writeSummary(const FuzzyCriticalPoints& found, vtkFieldData* data)
{
  data->AddArray(makeInt("IndexSum", found.indexSum));
  data->AddArray(makeInt("NeighborCount", found.neighborCount));
}

} // namespace

vtkFuzzyCriticalPoints::vtkFuzzyCriticalPoints()
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkFuzzyCriticalPoints::~vtkFuzzyCriticalPoints() = default;

void vtkFuzzyCriticalPoints::SetVolumeFunction(vtkImplicitFunction* function)
{
  if (this->VolumeFunction != function)
  {
    this->VolumeFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkFuzzyCriticalPoints::GetVolumeFunction()
{
  return this->VolumeFunction;
}

vtkMTimeType vtkFuzzyCriticalPoints::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->VolumeFunction ? std::max(time, this->VolumeFunction->GetMTime()) : time;
}

int vtkFuzzyCriticalPoints::FillInputPortInformation(int, vtkInformation* information)
{
  acceptPointSets(information);
  return 1;
}

int vtkFuzzyCriticalPoints::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Fuzzy Critical Points", outputs,
    [&](FilterRun& run)
    {
      const CriticalPointParameters parameters = parametersOf(*this);
      vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
      const Execution& execution = run.execution();
      Samples samples = readSamples(run, execution.part(0.0, ReadShare), input);
      const NeighborGraph graph(
        samples.points, NeighborQuery(), execution.part(ReadShare, GraphShare));
      samples.points = Points(); // the graph has its own
      samples.values = graph.average(samples.values);
      noteConstant(run, samples, samples.values);

      FuzzyCriticalPoints found = findCriticalPoints(
        graph, samples.values, parameters, execution.part(GraphShare, SearchShare));
      for (CriticalPoint& point : found.points)
      {
        point.input = static_cast<std::size_t>(samples.idOf(point.input));
      }
      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      passThrough(pointSetsOf(input), output);
      writeSampleCriticality(found.samples,
        vertexMap(graph, samples.ids, output->GetNumberOfPoints()), samples.valueName, run,
        execution.part(SearchShare, 1.0), output);
      makeRoom(run, output->GetFieldData(), "IndexSum");
      makeRoom(run, output->GetFieldData(), "NeighborCount");
      writeSummary(found, output->GetFieldData());
      vtkPolyData* criticalPoints = vtkPolyData::GetData(outputs, 1);
      writeFuzzyCriticalPoints(found.points, criticalPoints);
      writeSummary(found, criticalPoints->GetFieldData());
    });
}

void vtkFuzzyCriticalPoints::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "PolynomialDegree: " << this->PolynomialDegree << "\n";
  os << indent << "NeighborCount: " << this->NeighborCount << "\n";
  os << indent << "SearchRadius: " << this->SearchRadius << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "KernelWidth: " << this->KernelWidth << "\n";
  os << indent << "ProbabilityModel: " << this->ProbabilityModel << "\n";
  os << indent << "VolumeFunction: " << this->VolumeFunction.Get() << "\n";
  os << indent << "ProbabilityThreshold: " << this->ProbabilityThreshold << "\n";
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "Refine: " << this->Refine << "\n";
}
