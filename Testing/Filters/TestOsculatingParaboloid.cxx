// vtkOsculatingParaboloid: the surface on which the extended function has the value of a sample.

#include "FieldTest.h"

#include "vtkOsculatingParaboloid.h"

#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkMultiBlockDataSet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

double linear(const Vector3d& p)
{
  return 1.0 + Vector3d(1.0, -2.0, 2.0).dot(p);
}

void expectRefusal(vtkOsculatingParaboloid* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Osculating Paraboloid", parts);
}

/// Area of the triangles, counted negative where they turn their back to the direction.
double areaAlong(vtkPolyData* surface, const Vector3d& direction)
{
  double area = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    surface->GetCellPoints(cell, corners);
    const Vector3d first(surface->GetPoint(corners->GetId(0)));
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
    {
      const Vector3d second(surface->GetPoint(corners->GetId(i - 1)));
      const Vector3d third(surface->GetPoint(corners->GetId(i)));
      area += 0.5 * (second - first).cross(third - first).dot(direction);
    }
  }
  return area;
}

} // namespace

// Of a linear function it is the plane through the sample across the gradient, cut to the ball;
// also far from the origin, and for every scheme that reproduces linear functions.
TEST(OsculatingParaboloid, isAPlaneForLinearFunctions)
{
  for (const double offset : { 0.0, 1e6 })
  {
    Points points = randomCube(500, 1);
    points.array() += offset;
    vtkNew<vtkOsculatingParaboloid> filter;
    filter->SetInputData(makeCloud(points, linear));
    filter->SetPointId(17);
    filter->SetRadius(0.25);
    expectSilentSuccess(update(filter));
    vtkPolyData* output = filter->GetOutput();
    ASSERT_GT(output->GetNumberOfPolys(), 100);
    const Vector3d center = points.col(17);
    const Vector3d normal = Vector3d(1.0, -2.0, 2.0) / 3.0;
    const Eigen::MatrixXd normals = numbersOf(output, "Normals");
    double farthest = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Vector3d difference = Vector3d(output->GetPoint(i)) - center;
      EXPECT_NEAR(difference.dot(normal), 0.0, 1e-6);
      EXPECT_LT((normals.col(i) - normal).norm(), 1e-6);
      farthest = std::max(farthest, difference.norm());
    }
    EXPECT_NEAR(farthest, 0.25, 0.005);
    EXPECT_NEAR(areaAlong(output, normal), Pi * 0.25 * 0.25, 0.01); // the front sides, of a disc
    const Eigen::MatrixXd values = numbersOf(output, "f");
    EXPECT_LT((values.array() - linear(center)).abs().maxCoeff(), 1e-8 * (1.0 + offset));
    EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  }
}

// Near the sample it is the level set of the function itself: for densely sampled f, its error is
// far below its size.
TEST(OsculatingParaboloid, isCloseToTheLevelSet)
{
  for (const int scheme : { 1, 3, 4 })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkOsculatingParaboloid> filter;
    filter->SetInputData(waveSamples(20000));
    filter->SetPointId(5);
    filter->SetScheme(scheme);
    expectSilentSuccess(update(filter));
    vtkPolyData* output = filter->GetOutput();
    ASSERT_GT(output->GetNumberOfPolys(), 100);
    const double isoValue = numbersOf(output, "f")(0);
    const double tolerance = scheme == 1 ? 0.05 : 0.002;
    EXPECT_NEAR(isoValue, wave(Vector3d(randomCube(20000, 1).col(5))), tolerance);
    EXPECT_TRUE((numbersOf(output, "f").array() == isoValue).all());
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR(wave(Vector3d(output->GetPoint(i))), isoValue, 10.0 * tolerance);
    }
  }
}

// In blocks the points are counted one block after the other.
TEST(OsculatingParaboloid, countsThroughBlocks)
{
  const Points points = randomCube(500, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(points.leftCols(200), wave));
  blocks->SetBlock(1, makeCloud(points.rightCols(300), wave));
  vtkNew<vtkOsculatingParaboloid> filter;
  filter->SetInputData(makeCloud(points, wave));
  filter->SetPointId(321);
  expectSilentSuccess(update(filter));
  const Points expected = numbersOf(filter->GetOutput(), "Normals");
  filter->SetInputData(blocks);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(expected, numbersOf(filter->GetOutput(), "Normals"));
}

// Where the function is constant there is no surface, and a warning says so.
TEST(OsculatingParaboloid, noSurfaceOfConstantFunctions)
{
  vtkNew<vtkOsculatingParaboloid> filter;
  filter->SetInputData(makeCloud(randomCube(500, 1), Values::Constant(500, 0.1)));
  expectWarning(
    update(filter), { "Osculating Paraboloid: The function is constant around point 0" });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("f"));
}

TEST(OsculatingParaboloid, namesOfItsOwn)
{
  vtkNew<vtkOsculatingParaboloid> filter;
  const Points points = randomCube(100, 1);
  filter->SetInputData(makeCloud(points, points.row(0).transpose(), "Normals"));
  expectWarning(update(filter), { "'NormalsInput'" });
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Normals").rows(), 3);
  EXPECT_EQ(numbersOf(filter->GetOutput(), "NormalsInput").rows(), 1);
}

TEST(OsculatingParaboloid, refusesPointsThatAreNotThere)
{
  vtkNew<vtkOsculatingParaboloid> filter;
  filter->SetInputData(waveSamples(100));
  for (const vtkIdType id : { -1, 100 })
  {
    filter->SetPointId(id);
    expectRefusal(filter, { "needs a PointId from 0 to 99, found", std::to_string(id).c_str() });
  }
}

// The error says why the point is missing: the note about left-out points ends it.
TEST(OsculatingParaboloid, refusesPointsThatAreLeftOut)
{
  const auto samples = waveSamples(100);
  samples->GetPointData()->GetScalars()->SetTuple1(3, NaN);
  samples->GetPoints()->SetPoint(4, NaN, 0.0, 0.0);
  vtkNew<vtkOsculatingParaboloid> filter;
  filter->SetInputData(samples);
  for (const vtkIdType id : { 3, 4 })
  {
    filter->SetPointId(id);
    expectRefusal(filter,
      { "needs a PointId of a point with a finite position and value",
        "Left out 2 of 100 points" });
  }
}

TEST(OsculatingParaboloid, refusesWhatCannotBeDone)
{
  vtkNew<vtkOsculatingParaboloid> filter;
  filter->SetInputData(waveSamples(100));
  filter->SetGridDimensions(10, 1, 10);
  expectRefusal(filter, { "GridDimensions of at least 2, found 10 1 10." });
  filter->SetGridDimensions(10, 10, 10);
  filter->SetRadius(-1.0);
  expectRefusal(filter, { "Radius" });
  filter->SetRadius(0.0);
  filter->SetInputData(makeCloud(Points::Constant(3, 5, 1.0), Values::Ones(5)));
  expectRefusal(filter, { "at least 2 different points" });
}
