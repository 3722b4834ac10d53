#pragma once

#include "FilterTest.h"

#include "vtkPointSetScalarFunction.h"

#include "Sampling.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>

/// What the tests of the functions on surfaces share.
namespace SurfaceScalars::FilterTest
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// A filter for one of the functions on surfaces.
inline vtkSmartPointer<vtkPointSetScalarFunction> functionOn(vtkDataObject* input, int function)
{
  auto filter = vtkSmartPointer<vtkPointSetScalarFunction>::New();
  filter->SetInputDataObject(input);
  filter->SetFunction(function);
  return filter;
}

inline void setSources(vtkPointSetScalarFunction* filter, std::initializer_list<vtkIdType> ids)
{
  filter->SetNumberOfSourceIds(0);
  for (const vtkIdType id : ids)
  {
    filter->SetSourceIds(filter->GetNumberOfSourceIds(), id);
  }
}

inline void setConstraints(vtkPointSetScalarFunction* filter, std::initializer_list<vtkIdType> ids,
  std::initializer_list<double> values)
{
  filter->SetNumberOfConstraintIds(0);
  filter->SetNumberOfConstraintValues(0);
  for (const vtkIdType id : ids)
  {
    filter->SetConstraintIds(filter->GetNumberOfConstraintIds(), id);
  }
  for (const double value : values)
  {
    filter->SetConstraintValues(filter->GetNumberOfConstraintValues(), value);
  }
}

/// The filter's result, as it is.
inline Values resultOf(vtkPointSetScalarFunction* filter)
{
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetScalars();
  Values values(array ? array->GetNumberOfTuples() : 0);
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetTuple1(i);
  }
  return values;
}

/// The result of a run that has nothing to say.
inline Values silentResultOf(vtkPointSetScalarFunction* filter)
{
  expectSilentSuccess(update(filter));
  return resultOf(filter);
}

inline void expectFunctionRefusal(
  vtkPointSetScalarFunction* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Point Set Scalar Function", parts);
}

/// Two spheres of 500 points each, far from each other.
inline Points twoSpheres()
{
  Points points(3, 1000);
  points << Truth::randomSphere(500, 1), Truth::randomSphere(500, 2);
  points.row(0).tail(500).array() += 10.0;
  return points;
}

} // namespace SurfaceScalars::FilterTest
