#include "FieldModelData.h"

#include "Error.h"
#include "OutputArrays.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"
#include "Require.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr int Version = 1;
constexpr const char* VersionName = "ModelVersion";
constexpr const char* ValueNameName = "ValueName";
constexpr const char* CoefficientName = "Coefficient";
constexpr const char* Remedy =
  "Connect the output Model of RBF Extend or Meshless Approximation, or a file of it saved with "
  "DataMode Binary.";

/// Puts numbers into field data.
class FieldWriter
{
public:
  explicit FieldWriter(vtkFieldData* data)
    : data_(data)
  {
  }

  void add(const char* name, int number) const
  {
    const auto array = vtkSmartPointer<vtkIntArray>::New();
    array->SetName(name);
    array->InsertNextValue(number);
    this->data_->AddArray(array);
  }

  void add(const char* name, double number) const { this->add(name, Values::Constant(1, number)); }

  void add(const char* name, const Values& numbers) const
  {
    const auto array = makeDoubles(name, numbers.size());
    std::copy_n(numbers.data(), numbers.size(), array->GetPointer(0));
    this->data_->AddArray(array);
  }

  void add(const char* name, const std::string& text) const
  {
    const auto array = vtkSmartPointer<vtkStringArray>::New();
    array->SetName(name);
    array->InsertNextValue(text);
    this->data_->AddArray(array);
  }

private:
  vtkFieldData* data_;
};

/// Gets numbers out of field data. @throws InvalidInput if they are not there, not as many as
/// expected or not finite
class FieldReader
{
public:
  explicit FieldReader(vtkFieldData* data)
    : data_(data)
  {
  }

  void get(const char* name, int& number) const
  {
    const double read = this->numbers(name, 1)[0];
    number = static_cast<int>(std::clamp(read, static_cast<double>(std::numeric_limits<int>::min()),
      static_cast<double>(std::numeric_limits<int>::max())));
    if (number != read)
    {
      throw InvalidInput(
        "a Model with a whole number as " + std::string(name), std::to_string(read), Remedy);
    }
  }

  void get(const char* name, double& number) const { number = this->numbers(name, 1)[0]; }

  void get(const char* name, std::string& text) const
  {
    auto* array = vtkStringArray::SafeDownCast(this->data_->GetAbstractArray(name));
    if (!array || array->GetNumberOfValues() != 1)
    {
      throw InvalidInput(
        "a Model with the field data '" + std::string(name) + "'", "none of this name", Remedy);
    }
    text = array->GetValue(0);
  }

  Values numbers(const char* name, vtkIdType count) const
  {
    vtkDataArray* array = this->data_->GetArray(name);
    const std::string expected = "a Model with the field data '" + std::string(name) + "'";
    if (!array)
    {
      throw InvalidInput(expected, "none of this name", Remedy);
    }
    if (array->GetNumberOfValues() != count)
    {
      throw InvalidInput(expected + " of " + std::to_string(count) + " numbers",
        std::to_string(array->GetNumberOfValues()), Remedy);
    }
    Values numbers(count);
    copyNumbers(array, numbers.data(), Execution());
    if (!numbers.allFinite())
    {
      throw InvalidInput(expected + " of finite numbers", "NaN or infinity", Remedy);
    }
    return numbers;
  }

private:
  vtkFieldData* data_;
};

/// Every parameter by name, for writing and reading alike.
template <typename Parameters, typename Action>
void forEachParameter(Parameters& parameters, const Action& action)
{
  action("KernelWidth", parameters.kernelWidth);
  action("NeighborCount", parameters.neighborCount);
  action("SearchRadius", parameters.searchRadius);
  action("PolynomialDegree", parameters.polynomialDegree);
  action("Regularization", parameters.regularization);
  action("HybridThreshold", parameters.hybridThreshold);
}

void writeCenters(const FieldModel& model, vtkPolyData* output)
{
  const Eigen::Index count = model.centers.cols();
  const auto positions = makeDoubles("Points", count, 3);
  std::copy_n(model.centers.data(), 3 * count, positions->GetPointer(0));
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(positions);
  output->SetPoints(points);
  output->SetVerts(makeVertices(count));

  const auto coefficients = makeDoubles(CoefficientName, count);
  std::copy_n(model.coefficients.data(), count, coefficients->GetPointer(0));
  output->GetPointData()->SetScalars(coefficients);
}

void readCenters(vtkPolyData* input, FieldModel& model)
{
  const vtkIdType count = input->GetNumberOfPoints();
  vtkDataArray* coefficients = input->GetPointData()->GetArray(CoefficientName);
  if (!coefficients)
  {
    throw InvalidInput("a Model with the point array 'Coefficient'", "none of this name", Remedy);
  }
  if (count == 0 || coefficients->GetNumberOfValues() != count)
  {
    throw InvalidInput("a Model with one Coefficient at each center",
      std::to_string(coefficients->GetNumberOfValues()) + " for " + std::to_string(count) +
        " centers",
      Remedy);
  }
  model.centers.resize(3, count);
  model.coefficients.resize(count);
  copyNumbers(input->GetPoints()->GetData(), model.centers.data(), Execution());
  copyNumbers(coefficients, model.coefficients.data(), Execution());
}

void checkVersion(const FieldReader& reader)
{
  int version = 0;
  reader.get(VersionName, version);
  if (version != Version)
  {
    throw InvalidInput("a Model of version " + std::to_string(Version),
      "version " + std::to_string(version), "Make it again with this version of RBF Extend.");
  }
}

void readChoices(const FieldReader& reader, FieldParameters& parameters)
{
  int scheme = 0;
  int kernel = 0;
  reader.get("Scheme", scheme);
  reader.get("Kernel", kernel);
  checkChoice("a Model with Scheme", scheme, { 1, 2, 3, 4, 5 }, "1 to 5");
  checkChoice("a Model with Kernel", kernel, { 0, 1, 2, 3, 4, 5, 6, 7, 8 }, "0 to 8");
  parameters.scheme = static_cast<Scheme>(scheme);
  parameters.kernel = static_cast<KernelType>(kernel);
}

} // namespace

void writeModel(const NamedModel& named, vtkPolyData* output)
{
  const FieldModel& model = named.model;
  writeCenters(model, output);
  const FieldWriter writer(output->GetFieldData());
  writer.add(VersionName, Version);
  writer.add("Scheme", static_cast<int>(model.parameters.scheme));
  writer.add("Kernel", static_cast<int>(model.parameters.kernel));
  forEachParameter(
    model.parameters, [&](const char* name, auto number) { writer.add(name, number); });
  writer.add("Tail", Values(model.tail));
  writer.add("TailOrigin", Values(model.tailOrigin));
  writer.add("ValueRange", Values(Vector2d(model.lowest, model.highest)));
  writer.add(ValueNameName, named.valueName);
}

void refuseModel(vtkDataObject* input)
{
  if (input->GetFieldData()->HasArray(VersionName) && vtkPolyData::SafeDownCast(input) &&
    vtkPolyData::SafeDownCast(input)->GetPointData()->HasArray(CoefficientName))
  {
    throw InvalidInput("samples of a function", "a Model", "RBF Evaluate computes its values.");
  }
}

NamedModel readModel(vtkPolyData* input)
{
  NamedModel named;
  FieldModel& model = named.model;
  require(input != nullptr, "a Model, which is polydata", "data of another type", Remedy);
  const FieldReader reader(input->GetFieldData());
  checkVersion(reader);
  readChoices(reader, model.parameters);
  forEachParameter(
    model.parameters, [&](const char* name, auto& number) { reader.get(name, number); });
  model.tail = reader.numbers("Tail", 4);
  model.tailOrigin = reader.numbers("TailOrigin", 3);
  const Vector2d range = reader.numbers("ValueRange", 2);
  model.lowest = range[0];
  model.highest = range[1];
  reader.get(ValueNameName, named.valueName);
  readCenters(input, model);
  return named;
}

} // namespace SurfaceScalars
