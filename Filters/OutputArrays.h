#pragma once

#include "Basics.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <initializer_list>
#include <string>
#include <vector>

class vtkCellArray;
class vtkDataArray;
class vtkDoubleArray;
class vtkFieldData;
class vtkIntArray;

namespace SurfaceScalars
{

class FilterRun;

/// An array of doubles, allocated and not set.
vtkSmartPointer<vtkDoubleArray> makeDoubles(
  const std::string& name, vtkIdType tuples, int components = 1);

/// An array of ints, allocated and not set.
vtkSmartPointer<vtkIntArray> makeInts(const std::string& name, vtkIdType tuples);

/// These numbers as an array.
vtkSmartPointer<vtkDoubleArray> makeDoubles(const std::string& name, const Values& values);
vtkSmartPointer<vtkIntArray> makeInts(const std::string& name, const std::vector<int>& values);

/// Field data of one number.
vtkSmartPointer<vtkIntArray> makeInt(const std::string& name, int number);

/// One vertex for each of the first `count` points.
vtkSmartPointer<vtkCellArray> makeVertices(vtkIdType count);

/**
 * Makes room for an output array: an array called `name` becomes `<name>Input` and keeps its values
 * and its role as attribute. The array itself, which may belong to the filter's input, is not
 * touched.
 *
 * @returns the new name, empty if there was no such array
 */
std::string renameTaken(vtkFieldData* data, const std::string& name);

/// The same with a warning.
std::string makeRoom(const FilterRun& run, vtkFieldData* data, const std::string& name);

/// The same for all arrays of a filter's own. @returns where f, called `valueName`, is then
std::string makeRoom(const FilterRun& run, vtkFieldData* data,
  std::initializer_list<const char*> own, const std::string& valueName);

/// Adds field data. An array of the same name and other values becomes `<name>Input`, with a
/// warning.
void addFieldData(const FilterRun& run, vtkDataArray* array, vtkFieldData* data);

/// The name under which values called `name` are written: that, or `<name>Input` and a warning if
/// it is among the arrays of the filter's own.
std::string freeName(
  const FilterRun& run, const std::string& name, std::initializer_list<const char*> own);

} // namespace SurfaceScalars
