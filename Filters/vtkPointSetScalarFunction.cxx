#include "vtkPointSetScalarFunction.h"

#include "Basics.h"
#include "Error.h"
#include "FilterRun.h"
#include "OutputArrays.h"
#include "PointSetInput.h"

#include "vtkAppendPolyData.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkPointSetScalarFunction);

namespace
{

using namespace SurfaceScalars;

constexpr std::size_t Grain = 1 << 14; // points per block of a parallel loop

/// A function of position and its name.
struct PositionFunction
{
  std::string name;
  std::function<double(const Vector3d& place)> value;
};

std::string textOf(const Vector3d& vector)
{
  std::ostringstream text;
  text << "(" << vector.x() << ", " << vector.y() << ", " << vector.z() << ")";
  return text.str();
}

Vector3d place(const std::string& property, const double* numbers)
{
  Vector3d position(numbers);
  if (!position.allFinite())
  {
    throw InvalidInput("a finite " + property, textOf(position), "Correct it.");
  }
  return position;
}

Vector3d unitVector(const std::string& property, const double* numbers)
{
  const Vector3d vector(numbers);
  Vector3d unit = vector.stableNormalized(); // tiny and huge ones too
  if (!unit.allFinite() || std::abs(unit.squaredNorm() - 1.0) > 1e-6)
  {
    throw InvalidInput("a finite " + property + " other than the zero vector", textOf(vector),
      "(0, 0, 1) is the z axis.");
  }
  return unit;
}

PositionFunction functionOf(vtkPointSetScalarFunction& filter)
{
  switch (filter.GetFunction())
  {
    case vtkPointSetScalarFunction::HEIGHT:
      return { "Height",
        [direction = unitVector("Direction", filter.GetDirection())](const Vector3d& p)
        { return p.dot(direction); } };
    case vtkPointSetScalarFunction::DISTANCE_TO_POINT:
      return { "DistanceToPoint",
        [center = place("Center", filter.GetCenter())](const Vector3d& p)
        { return (p - center).norm(); } };
    case vtkPointSetScalarFunction::DISTANCE_TO_PLANE:
      return { "DistanceToPlane",
        [origin = place("Origin", filter.GetOrigin()),
          normal = unitVector("Normal", filter.GetNormal())](const Vector3d& p)
        { return std::abs((p - origin).dot(normal)); } };
    default:
      throw InvalidInput("Function 0 (Height), 1 (DistanceToPoint) or 2 (DistanceToPlane)",
        std::to_string(filter.GetFunction()), "Choose one of these.");
  }
}

/// The block itself if it is polydata, else its points and point arrays with a vertex each.
void passThrough(vtkPointSet* block, vtkPolyData* output)
{
  if (vtkPolyData::SafeDownCast(block))
  {
    output->ShallowCopy(block);
    return;
  }
  output->SetPoints(block->GetPoints());
  output->SetVerts(makeVertices(block->GetNumberOfPoints()));
  output->GetPointData()->ShallowCopy(block->GetPointData());
  output->GetFieldData()->ShallowCopy(block->GetFieldData());
}

void mergeBlocks(const std::vector<vtkPointSet*>& blocks, vtkPolyData* output)
{
  vtkNew<vtkAppendPolyData> append;
  for (vtkPointSet* block : blocks)
  {
    vtkNew<vtkPolyData> part;
    passThrough(block, part);
    append->AddInputData(part);
  }
  append->Update();
  output->ShallowCopy(append->GetOutput());
}

Points readPoints(vtkPoints* points, const Execution& execution)
{
  Points read(3, points->GetNumberOfPoints());
  copyNumbers(points->GetData(), read.data(), execution);
  return read;
}

/// The values at all points, NaN where the position is not finite.
Values evaluate(const PositionFunction& function, const Points& points, const Execution& execution)
{
  Values values(points.cols());
  parallelFor(static_cast<std::size_t>(points.cols()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
      {
        const Vector3d p = points.col(i);
        values(i) = p.allFinite() ? function.value(p) : std::numeric_limits<double>::quiet_NaN();
      }
    });
  return values;
}

void noteMissing(FilterRun& run, const Values& values)
{
  const Eigen::Index missing = values.array().isNaN().count();
  if (missing > 0)
  {
    run.note(std::to_string(missing) + " of " + std::to_string(values.size()) +
      " points have a NaN or infinite coordinate and get NaN.");
  }
}

void addResult(
  const FilterRun& run, const std::string& name, const Values& values, vtkPointData* data)
{
  const std::string renamed = renameTaken(data, name);
  if (!renamed.empty())
  {
    run.warn("The result is called '" + name + "'; the input's array of this name is now '" +
      renamed + "'.");
  }
  const auto result = makeDoubles(name, values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    result->SetValue(i, values(i));
  }
  data->SetScalars(result);
}

} // namespace

vtkPointSetScalarFunction::vtkPointSetScalarFunction() = default;

vtkPointSetScalarFunction::~vtkPointSetScalarFunction()
{
  this->SetResultArrayName(nullptr);
}

int vtkPointSetScalarFunction::FillInputPortInformation(int, vtkInformation* information)
{
  acceptPointSets(information);
  return 1;
}

int vtkPointSetScalarFunction::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Point Set Scalar Function", outputs,
    [&](FilterRun& run)
    {
      const PositionFunction function = functionOf(*this);
      const std::vector<vtkPointSet*> blocks = pointSetsOf(vtkDataObject::GetData(inputs[0]));
      vtkPolyData* output = vtkPolyData::GetData(outputs);
      if (blocks.size() == 1)
      {
        passThrough(blocks.front(), output);
      }
      else
      {
        mergeBlocks(blocks, output);
      }

      const Points points = readPoints(output->GetPoints(), run.execution().part(0.0, 0.5));
      const Values values = evaluate(function, points, run.execution().part(0.5, 1.0));
      noteMissing(run, values);
      const bool named = this->ResultArrayName && *this->ResultArrayName;
      addResult(run, named ? this->ResultArrayName : function.name, values, output->GetPointData());
    });
}

void vtkPointSetScalarFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* vector)
  { os << indent << name << ": " << textOf(Vector3d(vector)) << "\n"; };
  os << indent << "Function: " << this->Function << "\n";
  print("Direction", this->Direction);
  print("Center", this->Center);
  print("Origin", this->Origin);
  print("Normal", this->Normal);
  os << indent << "ResultArrayName: " << (this->ResultArrayName ? this->ResultArrayName : "(none)")
     << "\n";
}
