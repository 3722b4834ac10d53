#include "vtkPointSetScalarFunction.h"

#include "FilterRun.h"
#include "ListProperty.h"
#include "OutputArrays.h"
#include "PassThrough.h"
#include "PointSetInput.h"
#include "PositionFunctions.h"
#include "PropertyChoice.h"
#include "SurfaceFunctions.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"

#include <string>

vtkStandardNewMacro(vtkPointSetScalarFunction);

using namespace SurfaceScalars;

namespace
{

constexpr double ReadShare = 0.05; // of the whole

std::string nameOf(int function)
{
  checkChoice("Function", function, { 0, 1, 2, 3, 4, 5, 6 },
    "0 (Height), 1 (DistanceToPoint), 2 (DistanceToPlane), 3 (Geodesic), 4 (Harmonic), "
    "5 (LaplacianEigenfunction) or 6 (Diffusion)");
  constexpr const char* names[] = { "Height", "DistanceToPoint", "DistanceToPlane", "Geodesic",
    "Harmonic", "LaplacianEigenfunction", "Diffusion" };
  return names[function];
}

void noteMissing(FilterRun& run, const Points& points)
{
  Eigen::Index missing = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    missing += points.col(i).allFinite() ? 0 : 1;
  }
  if (missing > 0)
  {
    run.note(std::to_string(missing) + " of " + std::to_string(points.cols()) +
      " points have a NaN or infinite coordinate and get NaN.");
  }
}

void addResult(
  const FilterRun& run, const std::string& name, const Values& values, vtkPointData* data)
{
  makeRoom(run, data, name);
  data->AddArray(makeDoubles(name, values));
  data->SetActiveScalars(name.c_str());
}

void addEigenvalue(const FilterRun& run, double eigenvalue, vtkFieldData* data)
{
  makeRoom(run, data, "Eigenvalue");
  data->AddArray(makeDoubles("Eigenvalue", Values::Constant(1, eigenvalue)));
}

} // namespace

vtkPointSetScalarFunction::vtkPointSetScalarFunction()
{
  this->SetNumberOfInputPorts(2);
}

vtkPointSetScalarFunction::~vtkPointSetScalarFunction()
{
  this->SetResultArrayName(nullptr);
}

void vtkPointSetScalarFunction::SetNumberOfSourceIds(int number)
{
  setListSize(*this, this->SourceIds, number);
}

int vtkPointSetScalarFunction::GetNumberOfSourceIds()
{
  return static_cast<int>(this->SourceIds.size());
}

void vtkPointSetScalarFunction::SetSourceIds(int i, vtkIdType id)
{
  setListEntry(*this, "SourceIds", this->SourceIds, i, id);
}

vtkIdType vtkPointSetScalarFunction::GetSourceIds(int i)
{
  return listEntry(*this, "SourceIds", this->SourceIds, i);
}

void vtkPointSetScalarFunction::SetNumberOfConstraintIds(int number)
{
  setListSize(*this, this->ConstraintIds, number);
}

int vtkPointSetScalarFunction::GetNumberOfConstraintIds()
{
  return static_cast<int>(this->ConstraintIds.size());
}

void vtkPointSetScalarFunction::SetConstraintIds(int i, vtkIdType id)
{
  setListEntry(*this, "ConstraintIds", this->ConstraintIds, i, id);
}

vtkIdType vtkPointSetScalarFunction::GetConstraintIds(int i)
{
  return listEntry(*this, "ConstraintIds", this->ConstraintIds, i);
}

void vtkPointSetScalarFunction::SetNumberOfConstraintValues(int number)
{
  setListSize(*this, this->ConstraintValues, number);
}

int vtkPointSetScalarFunction::GetNumberOfConstraintValues()
{
  return static_cast<int>(this->ConstraintValues.size());
}

void vtkPointSetScalarFunction::SetConstraintValues(int i, double value)
{
  setListEntry(*this, "ConstraintValues", this->ConstraintValues, i, value);
}

double vtkPointSetScalarFunction::GetConstraintValues(int i)
{
  return listEntry(*this, "ConstraintValues", this->ConstraintValues, i);
}

void vtkPointSetScalarFunction::SetSelectionConnection(vtkAlgorithmOutput* connection)
{
  this->SetInputConnection(1, connection);
}

void vtkPointSetScalarFunction::SetSelectionData(vtkDataObject* selection)
{
  this->SetInputDataInternal(1, selection);
}

void vtkPointSetScalarFunction::RemoveSelection()
{
  this->SetSelectionConnection(nullptr);
}

int vtkPointSetScalarFunction::FillInputPortInformation(int port, vtkInformation* information)
{
  if (port == 0)
  {
    acceptPointSets(information);
    return 1;
  }
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkSelection");
  information->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkPointSetScalarFunction::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Point Set Scalar Function", outputs,
    [&](FilterRun& run)
    {
      const std::string name = nameOf(this->Function);
      vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      passThrough(pointSetsOf(input), output);
      const Points points = readPoints(output->GetPoints(), run.execution().part(0.0, ReadShare));
      noteMissing(run, points);

      SurfaceFunction function;
      const Execution execution = run.execution().part(ReadShare, 1.0);
      if (this->Function < GEODESIC)
      {
        function.values = positionFunction(*this, points, execution);
      }
      else
      {
        const PointChoice choice{ *this, input, vtkSelection::GetData(inputs[1]), points };
        function = surfaceFunction(choice, output, run, execution);
      }

      const bool named = this->ResultArrayName && *this->ResultArrayName;
      addResult(run, named ? this->ResultArrayName : name, function.values, output->GetPointData());
      if (this->Function == LAPLACIAN_EIGENFUNCTION)
      {
        addEigenvalue(run, function.eigenvalue, output->GetFieldData());
      }
    });
}

void vtkPointSetScalarFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printVector = [&](const char* name, const double* vector) {
    os << indent << name << ": (" << vector[0] << ", " << vector[1] << ", " << vector[2] << ")\n";
  };
  const auto printList = [&](const char* name, const auto& list)
  {
    os << indent << name << ":";
    for (const auto& entry : list)
    {
      os << " " << entry;
    }
    os << "\n";
  };
  os << indent << "Function: " << this->Function << "\n";
  printVector("Direction", this->Direction);
  printVector("Center", this->Center);
  printVector("Origin", this->Origin);
  printVector("Normal", this->Normal);
  os << indent << "SourceType: " << this->SourceType << "\n";
  printList("SourceIds", this->SourceIds);
  printVector("SourcePoint", this->SourcePoint);
  printList("ConstraintIds", this->ConstraintIds);
  printList("ConstraintValues", this->ConstraintValues);
  printVector("ConstraintPoint1", this->ConstraintPoint1);
  printVector("ConstraintPoint2", this->ConstraintPoint2);
  os << indent << "EigenIndex: " << this->EigenIndex << "\n";
  os << indent << "DiffusionTime: " << this->DiffusionTime << "\n";
  os << indent << "Weights: " << this->Weights << "\n";
  os << indent << "NeighborCount: " << this->NeighborCount << "\n";
  os << indent << "SearchRadius: " << this->SearchRadius << "\n";
  os << indent << "KernelWidth: " << this->KernelWidth << "\n";
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
