#pragma once

#include "CriticalPointReading.h"
#include "FilterTest.h"

#include "vtkFuzzyCriticalPoints.h"

#include "CriticalPoint.h"
#include "Sampling.h"
#include "Torus.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <vector>

/// What the tests of the critical points share.
namespace SurfaceScalars::FilterTest
{

/// The height of a tilted torus, which has a minimum, two saddles and a maximum.
inline double tiltedHeight(const Vector3d& p)
{
  return Vector3d(0.9, 0.2, 0.4).normalized().dot(p);
}

inline vtkSmartPointer<vtkPolyData> tiltedTorus(int count = 10000)
{
  return makeCloud(Truth::randomTorus(count, Truth::Torus::Closed, 1), tiltedHeight);
}

/// The types of the critical points, by ascending value.
inline std::vector<CriticalType> typesOf(vtkFuzzyCriticalPoints* filter)
{
  std::vector<CriticalType> types;
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    types.push_back(point.type);
  }
  return types;
}

/// What the tilted torus has.
inline const std::vector<CriticalType> TorusTypes = { CriticalType::Minimum, CriticalType::Saddle,
  CriticalType::Saddle, CriticalType::Maximum };

/// An array of the first output.
inline vtkDataArray* sampleArray(vtkFuzzyCriticalPoints* filter, const char* name)
{
  return filter->GetOutput()->GetPointData()->GetArray(name);
}

} // namespace SurfaceScalars::FilterTest
