#include "vtkRBFExtend.h"

#include "Error.h"
#include "ExplicitPoints.h"
#include "FieldModelData.h"
#include "FieldTarget.h"
#include "FilterRun.h"
#include "OutputArrays.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkRBFExtend);

using namespace SurfaceScalars;

namespace
{

// The shares of the whole that reading and fitting take.
constexpr double ReadShare = 0.05;
constexpr double FitShare = 0.4;

void checkGrid(vtkRBFExtend& filter)
{
  checkGridDimensions(filter.GetGridDimensions(), 1, "64 64 64 shows most functions.");
  if (!(filter.GetGridPadding() >= 0.0) || !std::isfinite(filter.GetGridPadding()))
  {
    throw InvalidInput("a GridPadding of at least 0", std::to_string(filter.GetGridPadding()),
      "It is a fraction of the samples' extent.");
  }
}

/// The uniform grid around the samples.
void makeGrid(vtkRBFExtend& filter, const Points& points, vtkImageData* grid)
{
  const Vector3d lowest = points.rowwise().minCoeff();
  const Vector3d size = points.rowwise().maxCoeff() - lowest;
  const double longest = size.maxCoeff();
  // Flat samples get a slab a tenth as thick as they are wide, a single place a unit cube.
  const double thickness = longest > 0.0 ? 0.1 * longest : 1.0;
  Vector3d origin;
  Vector3d spacing;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool flat = size[axis] <= 1e-6 * longest;
    const double margin = flat ? 0.5 * thickness : filter.GetGridPadding() * size[axis];
    const double extent = size[axis] + 2.0 * margin;
    const int count = filter.GetGridDimensions()[axis];
    // A single layer lies in the middle.
    origin[axis] = lowest[axis] + (count > 1 ? -margin : 0.5 * size[axis]);
    spacing[axis] = extent / std::max(count - 1, 1);
  }
  grid->SetDimensions(filter.GetGridDimensions());
  grid->SetOrigin(origin.data());
  grid->SetSpacing(spacing.data());
}

vtkInformation* targetOf(vtkInformationVector** inputs)
{
  return inputs[1]->GetInformationObject(0); // null if there is none
}

} // namespace

vtkRBFExtend::vtkRBFExtend()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

vtkRBFExtend::~vtkRBFExtend()
{
  this->SetResultArrayName(nullptr);
}

void vtkRBFExtend::SetTargetConnection(vtkAlgorithmOutput* connection)
{
  this->SetInputConnection(1, connection);
}

void vtkRBFExtend::SetTargetData(vtkDataObject* data)
{
  this->SetInputDataInternal(1, data);
}

void vtkRBFExtend::RemoveTarget()
{
  this->SetTargetConnection(nullptr);
}

int vtkRBFExtend::FillInputPortInformation(int port, vtkInformation* information)
{
  acceptTargets(information);
  if (port == 1)
  {
    information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkRBFExtend::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

int vtkRBFExtend::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  giveTypes(*this, vtkDataObject::GetData(targetOf(inputs)), "vtkImageData", outputs);
  return 1;
}

int vtkRBFExtend::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* output = outputs->GetInformationObject(0);
  if (vtkInformation* target = targetOf(inputs))
  {
    describeAsTarget(target, output);
    return 1;
  }
  const int* size = this->GridDimensions;
  const int extent[6] = { 0, std::max(size[0], 1) - 1, 0, std::max(size[1], 1) - 1, 0,
    std::max(size[2], 1) - 1 };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(output, VTK_DOUBLE, 1);
  return 1;
}

// All samples count, whatever part of the output is wanted: that part is the target's.
int vtkRBFExtend::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector*)
{
  askForAll(inputs[0]->GetInformationObject(0));
  vtkInformation* target = targetOf(inputs);
  if (target && request->Get(vtkExecutive::FROM_OUTPUT_PORT()) != 0)
  {
    askForAll(target);
  }
  return 1;
}

int vtkRBFExtend::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "RBF Extend", outputs,
    [&](FilterRun& run)
    {
      const Execution& execution = run.execution();
      const auto input = withExplicitPoints(vtkDataObject::GetData(inputs[0]));
      refuseModel(input);
      Samples samples = readSamples(run, execution.part(0.0, ReadShare), input);
      const std::string valueName = samples.valueName;
      vtkSmartPointer<vtkDataObject> target = vtkDataObject::GetData(targetOf(inputs));
      if (!target)
      {
        checkGrid(*this);
        const vtkNew<vtkImageData> grid;
        makeGrid(*this, samples.points, grid);
        target = grid;
      }

      const Field& field =
        this->FieldOf(std::move(samples), run, execution.part(ReadShare, FitShare));
      const bool leaveOneOut = this->ComputeLeaveOneOutErrors && this->GetScheme() == GLOBAL_RBF;
      const Values leaveOneOutErrors =
        leaveOneOut ? field.leaveOneOutErrors(execution.part(FitShare, FitShare)) : Values();
      writeOnTarget(field, targetRequestOf(*this, valueName), target, run,
        execution.part(FitShare, 1.0), vtkDataObject::GetData(outputs, 0));
      vtkPolyData* model = vtkPolyData::GetData(outputs, 1);
      writeModel({ field.model(), valueName }, model);
      if (leaveOneOut)
      {
        const auto array = makeDoubles("LeaveOneOutError", leaveOneOutErrors.size());
        std::copy_n(leaveOneOutErrors.data(), leaveOneOutErrors.size(), array->GetPointer(0));
        model->GetPointData()->AddArray(array);
      }
    });
}

void vtkRBFExtend::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "GridDimensions: " << this->GridDimensions[0] << " " << this->GridDimensions[1]
     << " " << this->GridDimensions[2] << "\n";
  os << indent << "GridPadding: " << this->GridPadding << "\n";
  os << indent << "ComputeGradient: " << this->ComputeGradient << "\n";
  os << indent << "ComputeHessian: " << this->ComputeHessian << "\n";
  os << indent << "ClampToRange: " << this->ClampToRange << "\n";
  os << indent << "ComputeLeaveOneOutErrors: " << this->ComputeLeaveOneOutErrors << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "NullValue: " << this->NullValue << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
