#pragma once

#include "FilterTest.h"

#include "vtkPointSetContour.h"

#include "Sampling.h"
#include "Torus.h"

#include "vtkNew.h"

#include <gtest/gtest.h>

#include <vector>

/// What the tests of inputs of vtkPointSetContour share.
namespace SurfaceScalars::FilterTest
{

inline double z(const Vector3d& p)
{
  return p.z();
}

inline Values heights(const Points& points)
{
  return points.row(2).transpose();
}

inline Points torusPoints(int count = 10000)
{
  return Truth::randomTorus(count, Truth::Torus::Closed, 1);
}

/// The curves of an input at one iso-value, expecting no complaint.
inline std::vector<Curve> contour(vtkDataObject* input, double isoValue)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputDataObject(input);
  filter->SetContourValues(0, isoValue);
  expectSilentSuccess(update(filter));
  return curvesOf(filter);
}

/// Expects the same curves, point by point.
inline void expectSame(
  const std::vector<Curve>& found, const std::vector<Curve>& expected, double tolerance = 0.0)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].closed, expected[i].closed);
    ASSERT_EQ(found[i].points.size(), expected[i].points.size());
    for (std::size_t j = 0; j < found[i].points.size(); ++j)
    {
      EXPECT_LE((found[i].points[j] - expected[i].points[j]).norm(), tolerance);
    }
  }
}

} // namespace SurfaceScalars::FilterTest
