#include "vtkMeshlessContour.h"

#include "ContourOutput.h"
#include "ContourValueList.h"
#include "FieldModelData.h"
#include "FilterRun.h"
#include "ListProperty.h"
#include "MeshInput.h"
#include "MeshlessContour.h"
#include "NumberText.h"
#include "OutputArrays.h"
#include "Require.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkMeshlessContour);

using namespace SurfaceScalars;

namespace
{

constexpr int SurfacePort = 1;

// The shares of the whole that end with reading and with the model.
constexpr double ReadShare = 0.05;
constexpr double ModelShare = 0.1;

std::string percentOf(double share)
{
  return textOf(1e-2 * std::max(1.0, std::round(1e4 * share))) + "%";
}

/// What the curves are not, in warnings.
void noteLimits(
  const FilterRun& run, const MeshlessContours& contours, const FieldModel& model, int refinement)
{
  const bool isLocal = model.parameters.scheme != Scheme::GlobalRBF;
  if (contours.sets.curves.empty())
  {
    run.warn("The model takes none of the values on the surface; at its centers it is from " +
      textOf(model.lowest) + " to " + textOf(model.highest) + ".");
  }
  if (contours.largestDeviation > contours.tolerance)
  {
    run.warn("Curves are up to " + textOf(contours.largestDeviation) +
      " away from the model's level sets, farther than the Tolerance of " +
      textOf(contours.tolerance) + ": " +
      (isLocal ? std::string("models of local schemes jump a little, where finer curves come no "
                             "closer.")
               : "raise it, or MaximumRefinement (" + std::to_string(refinement) +
            ") unless the model is all but constant at the value."));
  }
  if (contours.farShare > 0.0)
  {
    run.warn(percentOf(contours.farShare) + " of the curves' length is farther than " +
      textOf(contours.farDistance) +
      ", twice the widest spacing of the model's centers, from every center: the function is "
      "extrapolated there.");
  }
  if (contours.undefinedCount > 0)
  {
    run.warn("The model is not defined at corners of " + std::to_string(contours.undefinedCount) +
      " triangles or parts of these: curves end there.");
  }
}

void addNumber(const char* name, double number, vtkFieldData* data)
{
  data->AddArray(makeDoubles(name, Values::Constant(1, number)));
}

} // namespace

vtkMeshlessContour::vtkMeshlessContour()
{
  this->SetNumberOfInputPorts(2);
}

vtkMeshlessContour::~vtkMeshlessContour() = default;

void vtkMeshlessContour::SetSurfaceConnection(vtkAlgorithmOutput* connection)
{
  this->SetInputConnection(SurfacePort, connection);
}

void vtkMeshlessContour::SetSurfaceData(vtkDataObject* data)
{
  this->SetInputDataInternal(SurfacePort, data);
}

void vtkMeshlessContour::SetNumberOfContourValues(int number)
{
  setListSize(*this, this->ContourValues, number);
}

int vtkMeshlessContour::GetNumberOfContourValues()
{
  return static_cast<int>(this->ContourValues.size());
}

void vtkMeshlessContour::SetContourValues(int i, double value)
{
  setListEntry(*this, "ContourValues", this->ContourValues, i, value);
}

double vtkMeshlessContour::GetContourValues(int i)
{
  return listEntry(*this, "ContourValues", this->ContourValues, i);
}

int vtkMeshlessContour::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == SurfacePort)
  {
    information->Set(
      vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // it is not: RequestData() says so better
  }
  return 1;
}

/// The time steps of the surface, if the model has none.
int vtkMeshlessContour::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* surface = inputs[SurfacePort]->GetInformationObject(0); // null if there is none
  vtkInformation* output = outputs->GetInformationObject(0);
  if (surface && !output->Has(Pipeline::TIME_RANGE()))
  {
    output->CopyEntry(surface, Pipeline::TIME_STEPS());
    output->CopyEntry(surface, Pipeline::TIME_RANGE());
  }
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

int vtkMeshlessContour::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Meshless Contour", outputs,
    [&](FilterRun& run)
    {
      vtkPolyData* input = vtkPolyData::GetData(inputs[SurfacePort]);
      require(input != nullptr, "a Surface of triangles, which is polydata",
        "none, or a block of another type", "Choose a mesh, or apply Extract Surface to it.");
      MeshlessContourParameters parameters{ listOfContourValues(*this), this->Tolerance,
        this->MaximumRefinement };
      NamedModel named = readModel(vtkPolyData::GetData(inputs[0]));
      if (parameters.isoValues.empty())
      {
        parameters.isoValues = { 0.5 * named.model.lowest + 0.5 * named.model.highest };
      }
      const Execution& execution = run.execution();
      const MeshedSurface surface = readOwnSurface(run, execution.part(0.0, ReadShare), input);
      const Field field(std::move(named.model), execution.part(ReadShare, ModelShare));
      const MeshlessContours contours = traceMeshlessContours(
        field, surface.vertices, surface.triangles, parameters, execution.part(ModelShare, 1.0));
      noteLimits(run, contours, field.model(), this->MaximumRefinement);

      vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
      vtkFieldData* data = output->GetFieldData();
      data->Initialize(); // the pipeline has passed on the model's
      writeContours(contours.sets, isoValueName(run, named.valueName), output);
      addNumber("Tolerance", contours.tolerance, data);
      addNumber("LargestDeviation", contours.largestDeviation, data);
      addNumber("EvaluatedShare",
        static_cast<double>(contours.evaluatedVertices) /
          static_cast<double>(surface.vertices.cols()),
        data);
      addNumber("Evaluations", static_cast<double>(contours.evaluations), data);
    });
}

void vtkMeshlessContour::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ContourValues:";
  for (const double value : this->ContourValues)
  {
    os << " " << value;
  }
  os << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumRefinement: " << this->MaximumRefinement << "\n";
}
