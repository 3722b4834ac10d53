#pragma once

#include "Basics.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkPointSetContour;

/// What the tests of the filters share: clouds as VTK data, filters run with their messages caught,
/// curves read back.
namespace SurfaceScalars::FilterTest
{

/// Points without cells.
vtkSmartPointer<vtkPolyData> makeCloud(const PointsRef& points);

/// The same with a point array of double as active scalars.
vtkSmartPointer<vtkPolyData> makeCloud(
  const PointsRef& points, const Values& values, const char* name = "f");
vtkSmartPointer<vtkPolyData> makeCloud(
  const PointsRef& points, const std::function<double(const Vector3d&)>& function);

/// Adds a point array of any VTK type.
template <typename Array>
void addArray(vtkPointSet* cloud, const char* name, const Values& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    array->SetComponent(i, 0, values[i]);
  }
  cloud->GetPointData()->AddArray(array);
}

/// What a filter did.
struct Outcome
{
  bool succeeded = false;
  std::vector<std::string> errors;
  std::vector<std::string> warnings;
  std::vector<std::string> pipeline; ///< what the executive says: inputs refused, filters that fail
};

/// Updates a filter and catches what it and its executive say.
Outcome update(vtkAlgorithm* filter);

/// Expects success without a word.
void expectSilentSuccess(const Outcome& outcome);

/// Expects success and one warning that holds all the parts.
void expectWarning(const Outcome& outcome, std::initializer_list<const char*> parts);

/// Expects failure with one error that begins with `speaker`, holds all the parts, and leaves all
/// outputs empty.
void expectFailure(vtkAlgorithm* filter, const Outcome& outcome, const std::string& speaker,
  std::initializer_list<const char*> parts);

/// Stops the filter as soon as its progress reaches the fraction and expects that it leaves nothing
/// and says nothing; afterwards it can run again.
void expectNothingWhenStopped(vtkAlgorithm* filter, double fraction);

/// Expects that no output of the filter has points, cells or arrays.
void expectEmptyOutputs(vtkAlgorithm* filter);

/// A polyline of the port Contours.
struct Curve
{
  double isoValue;
  int component;
  bool closed;
  double length;
  std::vector<Vector3d> points; ///< the first one is repeated if closed
};

std::vector<Curve> curvesOf(vtkPointSetContour* filter);

} // namespace SurfaceScalars::FilterTest
