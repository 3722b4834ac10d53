#include "vtkRBFEvaluate.h"

#include "FieldModelData.h"
#include "FieldTarget.h"
#include "FilterRun.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkRBFEvaluate);

using namespace SurfaceScalars;

namespace
{

constexpr double FitShare = 0.2; // of the whole, to prepare the model

} // namespace

vtkRBFEvaluate::vtkRBFEvaluate()
{
  this->SetNumberOfInputPorts(2);
}

vtkRBFEvaluate::~vtkRBFEvaluate()
{
  this->SetResultArrayName(nullptr);
}

void vtkRBFEvaluate::SetTargetConnection(vtkAlgorithmOutput* connection)
{
  this->SetInputConnection(1, connection);
}

void vtkRBFEvaluate::SetTargetData(vtkDataObject* data)
{
  this->SetInputDataInternal(1, data);
}

int vtkRBFEvaluate::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port == 0)
  {
    information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  }
  else
  {
    acceptTargets(information);
  }
  return 1;
}

int vtkRBFEvaluate::FillOutputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject"); // the target's
  return 1;
}

int vtkRBFEvaluate::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* target = vtkDataObject::GetData(inputs[1]);
  if (!target)
  {
    return 0;
  }
  giveType(outputs->GetInformationObject(0), target->GetClassName());
  return 1;
}

int vtkRBFEvaluate::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  describeAsTarget(inputs[1]->GetInformationObject(0), outputs->GetInformationObject(0));
  return 1;
}

int vtkRBFEvaluate::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "RBF Evaluate", outputs,
    [&](FilterRun& run)
    {
      NamedModel named = readModel(vtkPolyData::GetData(inputs[0]));
      const Execution& execution = run.execution();
      const Field field(std::move(named.model), execution.part(0.0, FitShare));
      writeOnTarget(field, targetRequestOf(*this, named.valueName),
        vtkDataObject::GetData(inputs[1]), run, execution.part(FitShare, 1.0),
        vtkDataObject::GetData(outputs, 0));
    });
}

void vtkRBFEvaluate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ComputeGradient: " << this->ComputeGradient << "\n";
  os << indent << "ComputeHessian: " << this->ComputeHessian << "\n";
  os << indent << "ClampToRange: " << this->ClampToRange << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "NullValue: " << this->NullValue << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
