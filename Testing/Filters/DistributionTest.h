#pragma once

#include "ApproximationTest.h"

#include "vtkLevelSetDistribution.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkTable.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

/// What the tests of vtkLevelSetDistribution share.
namespace SurfaceScalars::FilterTest
{

using Distribution = vtkSmartPointer<vtkLevelSetDistribution>;

inline Distribution distribution(vtkDataObject* input)
{
  auto filter = Distribution::New();
  filter->SetInputDataObject(input);
  return filter;
}

inline std::vector<double> column(vtkLevelSetDistribution* filter, int port, const char* name)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
  return numbersOf(vtkDataArray::SafeDownCast(table->GetColumnByName(name)));
}

inline std::vector<double> field(vtkLevelSetDistribution* filter, const char* name)
{
  return numbersOf(filter->GetOutputDataObject(0)->GetFieldData()->GetArray(name));
}

inline std::vector<double> covered(vtkLevelSetDistribution* filter)
{
  return numbersOf(filter->GetOutput()->GetCellData()->GetArray("Covered"));
}

/// Area of a triangle, volume of a tetrahedron; 1 for the cells of images, which are all equal.
inline double sizeOf(vtkCell* cell)
{
  const auto place = [&](vtkIdType i)
  {
    Vector3d result;
    cell->GetPoints()->GetPoint(i, result.data());
    return result;
  };
  const auto side = [&](vtkIdType i) -> Vector3d { return place(i) - place(0); };
  switch (cell->GetCellType())
  {
    case VTK_TRIANGLE:
      return 0.5 * side(1).cross(side(2)).norm();
    case VTK_TETRA:
      return std::abs(side(1).cross(side(2)).dot(side(3))) / 6.0;
    default:
      return 1.0;
  }
}

/// The share of the area or volume of the cells that are covered.
inline double shareOfCovered(vtkLevelSetDistribution* filter)
{
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const auto is = covered(filter);
  double whole = 0.0;
  double share = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const double size = sizeOf(output->GetCell(cell));
    whole += size;
    share += is[static_cast<std::size_t>(cell)] * size;
  }
  return share / whole;
}

/// A square whose values are flat but for a strip in the middle, a quarter of it.
inline vtkSmartPointer<vtkPolyData> stepMesh()
{
  const auto mesh = squareMesh(33);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double x = mesh->GetPoint(i)[0];
    mesh->GetPointData()->GetScalars()->SetComponent(i, 0, std::clamp(x, 12.0, 20.0) + 0.3);
  }
  return mesh;
}

inline void expectRefusal(vtkLevelSetDistribution* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Level Set Distribution", parts);
}

} // namespace SurfaceScalars::FilterTest
