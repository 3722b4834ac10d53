#pragma once

#include "FieldTest.h"
#include "MeshTest.h"

#include "vtkMeshlessApproximation.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMeshCriticalPoints.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

/// What the tests of vtkMeshlessApproximation share.
namespace SurfaceScalars::FilterTest
{

/// Rises along x, y and z: on a box it has a minimum, a maximum and no other critical point.
inline double slope(const Vector3d& p)
{
  return p.x() + 0.7 * p.y() + 0.4 * p.z() +
    0.2 * std::sin(2.0 * p.x()) * std::cos(3.0 * p.y() + p.z());
}

/// Samples of slope(), named f, on a grid in the cube from -1 to 1.
inline vtkSmartPointer<vtkImageData> slopeImage(int x, int y, int z)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(x, y, z);
  image->SetOrigin(-1.0, -1.0, z > 1 ? -1.0 : 0.0);
  image->SetSpacing(2.0 / (x - 1), 2.0 / (y - 1), z > 1 ? 2.0 / (z - 1) : 1.0);
  auto values = vtkSmartPointer<vtkDoubleArray>::New();
  values->SetName("f");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(slope(Vector3d(image->GetPoint(i))));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// The voxels of an image, each in six tetrahedra.
inline vtkSmartPointer<vtkUnstructuredGrid> tetrahedraOf(vtkImageData* image)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(image->GetPoint(i));
  }
  grid->SetPoints(points);
  grid->Allocate(6 * image->GetNumberOfCells());
  constexpr std::array<std::array<vtkIdType, 2>, 6> between{ { { 1, 3 }, { 1, 5 }, { 2, 3 },
    { 2, 6 }, { 4, 5 }, { 4, 6 } } }; // of the ways from corner 0 to corner 7
  const vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    image->GetCellPoints(cell, corners);
    for (const auto& [a, b] : between)
    {
      const std::array<vtkIdType, 4> ids{ corners->GetId(0), corners->GetId(a), corners->GetId(b),
        corners->GetId(7) };
      grid->InsertNextCell(VTK_TETRA, 4, ids.data());
    }
  }
  grid->GetPointData()->ShallowCopy(image->GetPointData());
  return grid;
}

/// A function on the torus that is no polynomial.
inline Values torusHills()
{
  Values values = torusHeight();
  const Points points = TorusGrid::points();
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    values(i) += 0.2 * std::sin(3.0 * points(0, i) + 1.0) * std::cos(2.0 * points(1, i));
  }
  return values;
}

inline vtkSmartPointer<vtkMeshlessApproximation> approximation(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<vtkMeshlessApproximation>::New();
  filter->SetInputDataObject(input);
  filter->SetSampleFraction(0.25);
  return filter;
}

inline vtkPolyData* model(vtkMeshlessApproximation* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

inline vtkPolyData* critical(vtkMeshlessApproximation* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
}

/// A number of the field data of port 0; NaN if it is not there.
inline double figure(vtkMeshlessApproximation* filter, const char* name)
{
  const auto numbers = numbersOf(filter->GetOutputDataObject(0)->GetFieldData()->GetArray(name));
  return numbers.size() == 1 ? numbers[0] : NaN;
}

} // namespace SurfaceScalars::FilterTest
