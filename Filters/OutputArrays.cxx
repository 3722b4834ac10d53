#include "OutputArrays.h"

#include "FilterRun.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace SurfaceScalars
{
namespace
{

vtkSmartPointer<vtkIdTypeArray> countUp(vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkIdTypeArray>::New();
  numbers->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->SetValue(i, i);
  }
  return numbers;
}

/// The same values, shared where the type of array allows it.
vtkSmartPointer<vtkAbstractArray> copyOf(vtkAbstractArray* array)
{
  auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  if (auto* numbers = vtkDataArray::SafeDownCast(copy))
  {
    numbers->ShallowCopy(vtkDataArray::SafeDownCast(array));
  }
  else
  {
    copy->DeepCopy(array);
  }
  return copy;
}

bool equalNumbers(vtkDataArray* a, vtkDataArray* b)
{
  bool equal = a->GetNumberOfComponents() == b->GetNumberOfComponents() &&
    a->GetNumberOfTuples() == b->GetNumberOfTuples();
  for (vtkIdType i = 0; equal && i < a->GetNumberOfValues(); ++i)
  {
    const auto component = static_cast<int>(i % a->GetNumberOfComponents());
    const vtkIdType tuple = i / a->GetNumberOfComponents();
    equal = a->GetComponent(tuple, component) == b->GetComponent(tuple, component);
  }
  return equal;
}

} // namespace

vtkSmartPointer<vtkDoubleArray> makeDoubles(
  const std::string& name, vtkIdType tuples, int components)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  // Allocated here: where VTK finds too little memory it ends the program.
  const auto numbers = static_cast<std::size_t>(tuples) * static_cast<std::size_t>(components);
  auto* memory =
    static_cast<double*>(std::malloc(std::max<std::size_t>(numbers, 1) * sizeof(double)));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  array->SetArray(memory, static_cast<vtkIdType>(numbers), 0, vtkDoubleArray::VTK_DATA_ARRAY_FREE);
  return array;
}

vtkSmartPointer<vtkIntArray> makeInts(const std::string& name, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfValues(tuples);
  return array;
}

vtkSmartPointer<vtkDoubleArray> makeDoubles(const std::string& name, const Values& values)
{
  auto array = makeDoubles(name, values.size());
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkIntArray> makeInts(const std::string& name, const std::vector<int>& values)
{
  auto array = makeInts(name, static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkIntArray> makeInt(const std::string& name, int number)
{
  return makeInts(name, std::vector<int>{ number });
}

vtkSmartPointer<vtkCellArray> makeVertices(vtkIdType count)
{
  auto vertices = vtkSmartPointer<vtkCellArray>::New();
  vertices->SetData(countUp(count + 1), countUp(count));
  return vertices;
}

std::string renameTaken(vtkFieldData* data, const std::string& name)
{
  int index = -1;
  vtkAbstractArray* taken = data->GetAbstractArray(name.c_str(), index);
  if (!taken)
  {
    return {};
  }
  std::string free = name + "Input";
  while (data->HasArray(free.c_str()))
  {
    free += "Input";
  }
  auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
  const int attribute = attributes ? attributes->IsArrayAnAttribute(index) : -1;
  const vtkSmartPointer<vtkAbstractArray> copy = copyOf(taken);
  copy->SetName(free.c_str());
  data->RemoveArray(name.c_str());
  data->AddArray(copy);
  if (attribute >= 0)
  {
    attributes->SetActiveAttribute(free.c_str(), attribute);
  }
  return free;
}

std::string makeRoom(const FilterRun& run, vtkFieldData* data, const std::string& name)
{
  std::string renamed = renameTaken(data, name);
  if (!renamed.empty())
  {
    run.warn("The output has an array '" + name + "' of its own; the input's '" + name +
      "' is now '" + renamed + "'.");
  }
  return renamed;
}

std::string makeRoom(const FilterRun& run, vtkFieldData* data,
  std::initializer_list<const char*> own, const std::string& valueName)
{
  std::string name = valueName;
  for (const char* taken : own)
  {
    const std::string renamed = makeRoom(run, data, taken);
    name = taken == valueName ? renamed : name;
  }
  return name;
}

void addFieldData(const FilterRun& run, vtkDataArray* array, vtkFieldData* data)
{
  vtkDataArray* other = data->GetArray(array->GetName());
  if (!other || !equalNumbers(other, array))
  {
    makeRoom(run, data, array->GetName());
  }
  data->AddArray(array);
}

std::string freeName(
  const FilterRun& run, const std::string& name, std::initializer_list<const char*> own)
{
  if (std::find(own.begin(), own.end(), name) == own.end())
  {
    return name;
  }
  std::string free = name + "Input";
  run.warn("The output has an array '" + name + "' of its own; the values of the input's '" + name +
    "' are in '" + free + "'.");
  return free;
}

} // namespace SurfaceScalars
