#include "vtkRBFEvaluate.h"

#include "Error.h"
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
    information->Set(
      vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // it is not: RequestData() says so better
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
  giveTypes(*this, vtkDataObject::GetData(inputs[1]), "vtkPolyData", outputs);
  return 1;
}

int vtkRBFEvaluate::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (vtkInformation* target = inputs[1]->GetInformationObject(0))
  {
    describeAsTarget(target, outputs->GetInformationObject(0));
  }
  return 1;
}

int vtkRBFEvaluate::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "RBF Evaluate", outputs,
    [&](FilterRun& run)
    {
      vtkDataObject* target = vtkDataObject::GetData(inputs[1]);
      if (!target)
      {
        throw InvalidInput("a Target", "none", "Choose where the function is wanted.");
      }
      NamedModel named = readModel(vtkPolyData::GetData(inputs[0]));
      const Execution& execution = run.execution();
      const Field field(std::move(named.model), execution.part(0.0, FitShare));
      writeOnTarget(field, targetRequestOf(*this, named.valueName), target, run,
        execution.part(FitShare, 1.0), vtkDataObject::GetData(outputs, 0));
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
