#pragma once

#include "MeshTest.h"

#include "vtkScalarFunctionDesign.h"

#include <vector>

namespace SurfaceScalars::FilterTest
{

/// A row of a table of critical points.
struct Asked
{
  Vector3d place;
  double type;
  double multiplicity = 1.0;
  double value = NaN;
};

/// As points with the arrays that the filter reads.
inline vtkSmartPointer<vtkPolyData> criticalPoints(const std::vector<Asked>& list)
{
  const auto count = static_cast<Eigen::Index>(list.size());
  Points places(3, count);
  Values types(count);
  Values multiplicities(count);
  Values values(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Asked& asked = list[static_cast<std::size_t>(i)];
    places.col(i) = asked.place;
    types(i) = asked.type;
    multiplicities(i) = asked.multiplicity;
    values(i) = asked.value;
  }
  const auto points = makeCloud(places);
  addArray<vtkDoubleArray>(points, "CriticalType", types);
  addArray<vtkDoubleArray>(points, "Multiplicity", multiplicities);
  addArray<vtkDoubleArray>(points, "ScalarValue", values);
  return points;
}

/// The torus without a function, which the filter does not need.
inline vtkSmartPointer<vtkPolyData> plainTorus()
{
  const auto mesh = torusMesh(torusHeight());
  mesh->GetPointData()->Initialize();
  return mesh;
}

/// Where the torus has a point.
inline Vector3d torusPlace(int column, int row)
{
  return TorusGrid::points().col(row * TorusGrid::Columns + column);
}

/// What a height along x has on the torus: a minimum, two saddles and a maximum.
inline std::vector<Asked> naturalRequests()
{
  return { { torusPlace(0, 0), 3 }, { torusPlace(0, 12), 1 }, { torusPlace(24, 12), 1 },
    { torusPlace(24, 0), 0 } };
}

inline vtkSmartPointer<vtkScalarFunctionDesign> design(vtkDataObject* mesh, vtkDataObject* points)
{
  auto filter = vtkSmartPointer<vtkScalarFunctionDesign>::New();
  filter->SetInputDataObject(mesh);
  filter->SetCriticalPointsData(points);
  return filter;
}

inline vtkSmartPointer<vtkScalarFunctionDesign> design(
  vtkDataObject* mesh, const std::vector<Asked>& list)
{
  return design(mesh, criticalPoints(list));
}

inline Values designedValues(vtkPolyDataAlgorithm* filter, const char* name = "DesignedScalars")
{
  const auto numbers = numbersOf(pointArray(filter, name));
  return Eigen::Map<const Values>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

} // namespace SurfaceScalars::FilterTest
