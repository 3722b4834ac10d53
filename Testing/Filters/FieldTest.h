#pragma once

#include "FilterTest.h"

#include "vtkRBFExtend.h"

#include "Sampling.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// What the tests of the filters that extend functions share.
namespace SurfaceScalars::FilterTest
{

inline double wave(const Vector3d& p)
{
  return 2.0 + std::sin(p.x()) * std::cos(2.0 * p.y()) + 0.3 * p.z() * p.z();
}

/// Random places in the cube from -1 to 1.
inline Points randomCube(int count, unsigned seed)
{
  Truth::Random random(seed);
  Points points(3, count);
  std::generate_n(points.data(), points.size(), [&] { return random.uniform(-1.0, 1.0); });
  return points;
}

/// Samples of wave(), named f.
inline vtkSmartPointer<vtkPolyData> waveSamples(int count = 500, unsigned seed = 1)
{
  return makeCloud(randomCube(count, seed), wave);
}

template <typename PointSet>
vtkSmartPointer<PointSet> pointSetTarget(unsigned seed)
{
  const auto target = vtkSmartPointer<PointSet>::New();
  target->SetPoints(makeCloud(0.8 * randomCube(60, seed))->GetPoints());
  return target;
}

/// The numbers of a point array, one tuple per column.
inline Eigen::MatrixXd numbersOf(vtkDataObject* data, const char* name)
{
  auto* dataset = vtkDataSet::SafeDownCast(data);
  vtkDataArray* array = dataset ? dataset->GetPointData()->GetArray(name) : nullptr;
  if (!array)
  {
    return {};
  }
  Eigen::MatrixXd numbers(array->GetNumberOfComponents(), array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, numbers.col(i).data());
  }
  return numbers;
}

/// The same bits in all arrays that a filter adds.
inline void expectSameResult(vtkDataObject* one, vtkDataObject* other)
{
  for (const char* name : { "f", "fGradient", "fHessian", "Valid" })
  {
    const Eigen::MatrixXd expected = numbersOf(one, name);
    const Eigen::MatrixXd found = numbersOf(other, name);
    ASSERT_GT(expected.size(), 0) << name;
    ASSERT_EQ(expected.cols(), found.cols()) << name;
    EXPECT_TRUE(expected == found) << name;
  }
}

} // namespace SurfaceScalars::FilterTest
