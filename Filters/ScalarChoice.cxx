#include "ScalarChoice.h"

#include "Error.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <set>

namespace SurfaceScalars
{
namespace
{

/// What SetInputArrayToProcess() left: a name, or an attribute if the name is empty.
struct Request
{
  std::string name;
  int attribute = vtkDataSetAttributes::SCALARS;
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;

  vtkAbstractArray* find(vtkDataSetAttributes* data) const
  {
    return this->name.empty() ? data->GetAbstractAttribute(this->attribute)
                              : data->GetAbstractArray(this->name.c_str());
  }
};

Request requestOf(vtkAlgorithm& filter, int index)
{
  vtkInformation* information = filter.GetInputArrayInformation(index);
  Request request;
  if (const char* name = information->Get(vtkDataObject::FIELD_NAME()))
  {
    request.name = name;
  }
  if (information->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    request.attribute = information->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
  }
  if (information->Has(vtkDataObject::FIELD_ASSOCIATION()))
  {
    request.association = information->Get(vtkDataObject::FIELD_ASSOCIATION());
  }
  return request;
}

/// "Choose one of the point arrays a, b." or what to do if there are none with one component.
std::string advice(const std::vector<vtkPointSet*>& blocks)
{
  std::set<std::string> names;
  for (vtkPointSet* block : blocks)
  {
    vtkPointData* data = block->GetPointData();
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      auto* array = vtkDataArray::SafeDownCast(data->GetAbstractArray(i));
      if (array && array->GetName() && array->GetNumberOfComponents() == 1)
      {
        names.insert(array->GetName());
      }
    }
  }
  if (names.empty())
  {
    return "The input has no point array of one component: compute one, for example with Point Set "
           "Scalar Function, or apply Cell Data to Point Data.";
  }
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "'" : ", '") + name + "'";
  }
  return names.size() == 1 ? "Choose the point array " + list + "."
                           : "Choose one of the point arrays " + list + ".";
}

vtkDataArray* usable(
  vtkAbstractArray* array, vtkPointSet* block, const std::vector<vtkPointSet*>& blocks)
{
  const std::string name = array->GetName() ? array->GetName() : "";
  auto* numbers = vtkDataArray::SafeDownCast(array);
  if (!numbers)
  {
    throw InvalidInput(
      "an array of numbers", "'" + name + "', a " + array->GetClassName(), advice(blocks));
  }
  if (numbers->GetNumberOfComponents() != 1)
  {
    throw InvalidInput("an array with one component",
      "'" + name + "' with " + std::to_string(numbers->GetNumberOfComponents()),
      "Compute one number per point from it (Calculator: mag or a component) or choose another "
      "array.");
  }
  if (numbers->GetNumberOfTuples() != block->GetNumberOfPoints())
  {
    throw InvalidInput("one value per point",
      "'" + name + "' with " + std::to_string(numbers->GetNumberOfTuples()) + " values for " +
        std::to_string(block->GetNumberOfPoints()) + " points",
      "Check what made this array.");
  }
  return numbers;
}

/// Refuses arrays that are not on the points.
void checkAssociation(const Request& request, const std::vector<vtkPointSet*>& blocks)
{
  if (request.association == vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    request.association == vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    return;
  }
  const bool onCells = request.association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const std::string name = request.name.empty() ? "" : " '" + request.name + "'";
  throw InvalidInput("a point array", (onCells ? "the cell array" : "the field data array") + name,
    onCells ? "Apply Cell Data to Point Data, or choose a point array." : advice(blocks));
}

} // namespace

ScalarChoice chooseScalars(vtkAlgorithm& filter, const std::vector<vtkPointSet*>& blocks, int index)
{
  Request request = requestOf(filter, index);
  checkAssociation(request, blocks);

  ScalarChoice choice;
  bool found = false;
  for (vtkPointSet* block : blocks)
  {
    vtkAbstractArray* array = request.find(block->GetPointData());
    choice.arrays.push_back(array ? usable(array, block, blocks) : nullptr);
    if (array && !found)
    {
      found = true;
      // Every block has active scalars of its own: the first decides which array is meant.
      request.name = array->GetName() ? array->GetName() : "";
      choice.name = request.name.empty() ? "Scalars" : request.name;
    }
  }
  if (!found)
  {
    throw InvalidInput(request.name.empty() ? "a point array with the values of the function"
                                            : "the point array '" + request.name + "'",
      request.name.empty() ? "no active scalars" : "none of this name", advice(blocks));
  }
  return choice;
}

} // namespace SurfaceScalars
