#pragma once

#include "FilterTest.h"

#include "vtkPointSetScalarFunction.h"

#include "Sampling.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
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

constexpr int Side = 21; // points of a grid's side

/// A grid in the plane, its cells as quads or as the triangles or strips that they consist of.
inline vtkSmartPointer<vtkPolyData> meshedGrid(int cornersOfCell)
{
  const auto mesh = makeCloud(Truth::squareGrid(Side, 0.05));
  vtkNew<vtkCellArray> cells;
  for (vtkIdType row = 0; row + 1 < Side; ++row)
  {
    if (cornersOfCell == 2 * Side)
    {
      cells->InsertNextCell(cornersOfCell);
    }
    for (vtkIdType column = 0; column + 1 < Side; ++column)
    {
      const vtkIdType a = row * Side + column;
      if (cornersOfCell == 4)
      {
        cells->InsertNextCell({ a, a + 1, a + Side + 1, a + Side });
      }
      else if (cornersOfCell == 3)
      {
        cells->InsertNextCell({ a, a + 1, a + Side });
        cells->InsertNextCell({ a + 1, a + Side + 1, a + Side });
      }
      else
      {
        cells->InsertCellPoint(a);
        cells->InsertCellPoint(a + Side);
      }
    }
    if (cornersOfCell == 2 * Side)
    {
      cells->InsertCellPoint(row * Side + Side - 1);
      cells->InsertCellPoint(row * Side + 2 * Side - 1);
    }
  }
  cornersOfCell == 2 * Side ? mesh->SetStrips(cells) : mesh->SetPolys(cells);
  return mesh;
}

} // namespace SurfaceScalars::FilterTest
