#pragma once

#include "CriticalPointReading.h"
#include "FilterTest.h"

#include "CriticalPoint.h"
#include "Torus.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

/// What the tests of the mesh filters share.
namespace SurfaceScalars::FilterTest
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// The corners of a grid's cells, by row and column; modulo its sizes.
struct GridCorners
{
  int columns;
  int rows;

  vtkIdType operator()(int column, int row) const
  {
    return (row % this->rows) * this->columns + column % this->columns;
  }
};

/// The cells as triangles, two for each.
inline vtkSmartPointer<vtkCellArray> gridTriangles(const GridCorners& corner, int columns, int rows)
{
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      cells->InsertNextCell({ corner(i, j), corner(i + 1, j), corner(i + 1, j + 1) });
      cells->InsertNextCell({ corner(i, j), corner(i + 1, j + 1), corner(i, j + 1) });
    }
  }
  return cells;
}

/// The closed torus.
struct TorusGrid
{
  static constexpr int Columns = 48;
  static constexpr int Rows = 24;

  static Points points()
  {
    Points points(3, Columns * Rows);
    for (int j = 0; j < Rows; ++j)
    {
      for (int i = 0; i < Columns; ++i)
      {
        points.col(j * Columns + i) =
          Truth::torusPoint({ 2.0 * Pi * i / Columns, 2.0 * Pi * j / Rows });
      }
    }
    return points;
  }

  /// A height that has a minimum, two saddles and a maximum there.
  static double height(const Vector3d& p) { return Vector3d(0.9, 0.2, 0.4).normalized().dot(p); }
};

/// The torus with a function on it.
inline vtkSmartPointer<vtkPolyData> torusMesh(const Values& values)
{
  const auto mesh = makeCloud(TorusGrid::points(), values);
  mesh->SetPolys(
    gridTriangles({ TorusGrid::Columns, TorusGrid::Rows }, TorusGrid::Columns, TorusGrid::Rows));
  return mesh;
}

inline Values torusHeight()
{
  const Points points = TorusGrid::points();
  Values values(points.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    values(i) = TorusGrid::height(points.col(i));
  }
  return values;
}

/// Uniform noise of a range of 1.
inline Values noise(Eigen::Index count, unsigned seed = 1)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  return Values::NullaryExpr(count, [&]() { return uniform(generator); });
}

inline vtkSmartPointer<vtkPolyData> noisyTorus(unsigned seed = 1)
{
  return torusMesh(noise(TorusGrid::Columns * TorusGrid::Rows, seed));
}

/// A square of size x size points in the plane, in triangles, with x + 0.1 y on it.
inline vtkSmartPointer<vtkPolyData> squareMesh(int size = 8)
{
  Points points(3, size * size);
  Values values(size * size);
  for (int i = 0; i < size * size; ++i)
  {
    points.col(i) << i % size, i / size, 0.0;
    values(i) = points(0, i) + 0.1 * points(1, i);
  }
  const auto mesh = makeCloud(points, values);
  mesh->SetPolys(gridTriangles({ size, size }, size - 1, size - 1));
  return mesh;
}

inline vtkSmartPointer<vtkPolyData> noisySquare(int size = 30)
{
  auto mesh = squareMesh(size);
  addArray<vtkDoubleArray>(mesh, "f", noise(mesh->GetNumberOfPoints(), 3));
  mesh->GetPointData()->SetActiveScalars("f");
  return mesh;
}

/// A point array of an output.
inline vtkDataArray* pointArray(vtkPolyDataAlgorithm* filter, const char* name, int port = 0)
{
  return filter->GetOutput(port)->GetPointData()->GetArray(name);
}

/// All numbers of an array.
inline std::vector<double> numbersOf(vtkDataArray* array)
{
  std::vector<double> numbers;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    numbers.push_back(array->GetComponent(i, 0));
  }
  return numbers;
}

inline std::vector<double> fieldData(vtkPolyDataAlgorithm* filter, const char* name, int port = 0)
{
  return numbersOf(filter->GetOutput(port)->GetFieldData()->GetArray(name));
}

} // namespace SurfaceScalars::FilterTest
