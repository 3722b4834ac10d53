#include "vtkPointSetContour.h"

#include "ContourOutput.h"
#include "ContourValueList.h"
#include "FilterRun.h"
#include "ImplicitFunction.h"
#include "LevelSets.h"
#include "ListProperty.h"
#include "NeighborGraph.h"
#include "OutputArrays.h"
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

vtkStandardNewMacro(vtkPointSetContour);

namespace
{

using namespace SurfaceScalars;

// The shares of the whole that reading, the neighbor graph and the curves take.
constexpr double ReadShare = 0.05;
constexpr double GraphShare = 0.5;

ContourParameters parametersOf(vtkPointSetContour& filter)
{
  checkChoice("Scheme", filter.GetScheme(), { 0, 1, 2, 3, 4 },
    "0 (Linear), 1 (ExplicitMLS), 2 (ParameterizedMLS), 3 (LocalRBF) or 4 (Hybrid)");
  checkChoice(
    "SurfaceModel", filter.GetSurfaceModel(), { 0, 1, 2 }, "0 (MLS), 1 (RBF) or 2 (Unprojected)");
  checkChoice("Kernel", filter.GetKernel(), { 0, 1, 2, 3, 4, 5, 6, 7, 8 },
    "from 0 (Gaussian) to 8 (Wu), such as 3 (Cubic)");
  checkChoice("Fit", filter.GetFit(), { 0, 1 }, "0 (Interpolate) or 1 (LeastSquares)");

  ContourParameters parameters;
  parameters.isoValues = listOfContourValues(filter);
  parameters.scheme = static_cast<Scheme>(filter.GetScheme());
  parameters.surface = static_cast<SurfaceModel>(filter.GetSurfaceModel());
  parameters.volumeFunction = volumeFunctionOf(filter.GetCutFunction());
  parameters.polynomialDegree = filter.GetPolynomialDegree();
  parameters.neighborCount = filter.GetNeighborCount();
  parameters.searchRadius = filter.GetSearchRadius();
  parameters.kernel = static_cast<KernelType>(filter.GetKernel());
  parameters.kernelWidth = filter.GetKernelWidth();
  parameters.linkDistance = filter.GetLinkDistance();
  parameters.tolerance = filter.GetTolerance();
  parameters.maximumIterations = filter.GetMaximumIterations();
  parameters.fit = static_cast<CurveFit>(filter.GetFit());
  parameters.sampleSpacing = filter.GetSampleSpacing();
  return parameters;
}

Samples read(FilterRun& run, vtkDataObject* input, vtkImplicitFunction* cutFunction)
{
  const Execution execution = run.execution().part(0.0, ReadShare);
  return cutFunction ? readSamples(run, execution, input, *cutFunction)
                     : readSamples(run, execution, input);
}

double midRange(const Values& values)
{
  // Halves first: the sum of huge values could overflow.
  return 0.5 * values.minCoeff() + 0.5 * values.maxCoeff();
}

} // namespace

vtkPointSetContour::vtkPointSetContour()
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkPointSetContour::~vtkPointSetContour() = default;

void vtkPointSetContour::SetNumberOfContourValues(int number)
{
  setListSize(*this, this->ContourValues, number);
}

int vtkPointSetContour::GetNumberOfContourValues()
{
  return static_cast<int>(this->ContourValues.size());
}

void vtkPointSetContour::SetContourValues(int i, double value)
{
  setListEntry(*this, "ContourValues", this->ContourValues, i, value);
}

double vtkPointSetContour::GetContourValues(int i)
{
  return listEntry(*this, "ContourValues", this->ContourValues, i);
}

void vtkPointSetContour::SetCutFunction(vtkImplicitFunction* function)
{
  if (this->CutFunction != function)
  {
    this->CutFunction = function;
    this->Modified();
  }
}

vtkImplicitFunction* vtkPointSetContour::GetCutFunction()
{
  return this->CutFunction;
}

vtkMTimeType vtkPointSetContour::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->CutFunction ? std::max(time, this->CutFunction->GetMTime()) : time;
}

int vtkPointSetContour::FillInputPortInformation(int, vtkInformation* information)
{
  acceptPointSets(information);
  return 1;
}

int vtkPointSetContour::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Point Set Contour", outputs,
    [&](FilterRun& run)
    {
      ContourParameters parameters = parametersOf(*this);
      Samples samples = read(run, vtkDataObject::GetData(inputs[0]), this->CutFunction);
      const Execution& execution = run.execution();
      const NeighborGraph graph(
        samples.points, NeighborQuery(), execution.part(ReadShare, GraphShare));
      samples.points = Points(); // the graph has its own
      samples.values = graph.average(samples.values);
      if (parameters.isoValues.empty())
      {
        parameters.isoValues = { midRange(samples.values) };
      }

      const LevelSets sets =
        traceLevelSets(graph, samples.values, parameters, execution.part(GraphShare, 1.0));
      const std::string valueName = isoValueName(run, samples.valueName);
      vtkPolyData* contours = vtkPolyData::GetData(outputs, 0);
      writeContours(sets, valueName, contours);
      contours->GetFieldData()->AddArray(makeInt("NeighborCount", sets.neighborCount));
      writeSamples(sets, valueName, vtkPolyData::GetData(outputs, 1));
    });
}

void vtkPointSetContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContourValues:";
  for (const double value : this->ContourValues)
  {
    os << " " << value;
  }
  os << "\n";
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "SurfaceModel: " << this->SurfaceModel << "\n";
  os << indent << "PolynomialDegree: " << this->PolynomialDegree << "\n";
  os << indent << "NeighborCount: " << this->NeighborCount << "\n";
  os << indent << "SearchRadius: " << this->SearchRadius << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "KernelWidth: " << this->KernelWidth << "\n";
  os << indent << "CutFunction: " << this->CutFunction.Get() << "\n";
  os << indent << "LinkDistance: " << this->LinkDistance << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Fit: " << this->Fit << "\n";
  os << indent << "SampleSpacing: " << this->SampleSpacing << "\n";
}
