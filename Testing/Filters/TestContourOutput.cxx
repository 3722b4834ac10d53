// What vtkPointSetContour writes: every array, on surfaces whose curves are known.

#include "FilterTest.h"

#include "vtkPointSetContour.h"

#include "Sampling.h"
#include "Torus.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSphere.h"

#include <Eigen/Geometry> // cross product
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double HeightOfTwoCurves = 0.2; // the torus at this height: two circles

double x(const Vector3d& p)
{
  return p.x();
}

double z(const Vector3d& p)
{
  return p.z();
}

vtkSmartPointer<vtkPolyData> torusCloud(int count = 20000)
{
  return makeCloud(Truth::randomTorus(count, Truth::Torus::Closed, 1), z);
}

/// The radii of the two circles of the torus at a height.
std::pair<double, double> circleRadii(double height)
{
  const double half = std::sqrt(Truth::MinorRadius * Truth::MinorRadius - height * height);
  return { Truth::MajorRadius - half, Truth::MajorRadius + half };
}

std::set<std::string> arrayNames(vtkFieldData* data)
{
  std::set<std::string> names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    names.insert(data->GetAbstractArray(i)->GetName());
  }
  return names;
}

void expectPointArrays(vtkPolyData* output, const char* valueName, double isoValue)
{
  vtkPointData* data = output->GetPointData();
  ASSERT_NE(vtkDoubleArray::SafeDownCast(data->GetArray(valueName)), nullptr);
  ASSERT_NE(vtkDoubleArray::SafeDownCast(data->GetArray("Residual")), nullptr);
  auto* normals = vtkDoubleArray::SafeDownCast(data->GetNormals());
  ASSERT_NE(normals, nullptr);
  EXPECT_STREQ(normals->GetName(), "Normals");
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(data->GetArray(valueName)->GetTuple1(i), isoValue);
    EXPECT_NEAR(Vector3d(normals->GetTuple3(i)).norm(), 1.0, 1e-12);
  }
}

} // namespace

// On a plane, x = 0.25 is one straight line from boundary to boundary.
TEST(ContourOutput, isALineOnAPlane)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(Truth::randomPlane(5000, 1), x));
  filter->SetContourValues(0, 0.25);
  expectSilentSuccess(update(filter));

  const std::vector<Curve> curves = curvesOf(filter);
  ASSERT_THAT(curves, ::testing::SizeIs(1));
  const Curve& line = curves.front();
  EXPECT_EQ(line.isoValue, 0.25);
  EXPECT_EQ(line.component, 0);
  EXPECT_FALSE(line.closed);
  EXPECT_NEAR(line.length, 2.0, 0.1);
  EXPECT_NEAR((line.points.back() - line.points.front()).norm(), line.length, 1e-6);
  for (const Vector3d& p : line.points)
  {
    EXPECT_NEAR(p.x(), 0.25, 1e-8);
    EXPECT_NEAR(p.z(), 0.0, 1e-12);
  }
  expectPointArrays(filter->GetOutput(), "f", 0.25);
  vtkDataArray* normals = filter->GetOutput()->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(std::abs(normals->GetComponent(i, 2)), 1.0, 1e-12);
  }
}

// On the torus, a height between the middle and the top gives two circles of known radii.
TEST(ContourOutput, isTwoCirclesOnATorus)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetContourValues(0, HeightOfTwoCurves);
  expectSilentSuccess(update(filter));

  const std::vector<Curve> curves = curvesOf(filter);
  ASSERT_THAT(curves, ::testing::SizeIs(2));
  const auto [inner, outer] = circleRadii(HeightOfTwoCurves);
  for (const Curve& curve : curves)
  {
    const bool isInner = curve.length < Pi * (inner + outer);
    const double radius = isInner ? inner : outer;
    EXPECT_TRUE(curve.closed);
    EXPECT_NEAR(curve.length, 2.0 * Pi * radius, 1e-3 * 2.0 * Pi * radius);
    EXPECT_EQ(curve.points.front(), curve.points.back());
    for (const Vector3d& p : curve.points)
    {
      EXPECT_NEAR(p.z(), HeightOfTwoCurves, 1e-3);
      EXPECT_NEAR(p.head<2>().norm(), radius, 1e-3);
    }
  }
  EXPECT_EQ(std::set<int>({ curves[0].component, curves[1].component }), std::set<int>({ 0, 1 }));
  expectPointArrays(filter->GetOutput(), "f", HeightOfTwoCurves);
}

// A closed polyline ends with the id it starts with; every point belongs to exactly one polyline.
TEST(ContourOutput, closesPolylinesById)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetContourValues(0, HeightOfTwoCurves);
  update(filter);

  vtkIdType used = 0;
  vtkNew<vtkIdList> ids;
  vtkCellArray* lines = filter->GetOutput()->GetLines();
  for (lines->InitTraversal(); lines->GetNextCell(ids);)
  {
    EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1));
    used += ids->GetNumberOfIds() - 1;
  }
  EXPECT_EQ(used, filter->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), filter->GetOutput()->GetNumberOfLines());
}

// The length in the array is that of the polyline.
TEST(ContourOutput, givesThePolylinesLength)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetContourValues(0, HeightOfTwoCurves);
  update(filter);

  for (const Curve& curve : curvesOf(filter))
  {
    double length = 0.0;
    for (std::size_t i = 1; i < curve.points.size(); ++i)
    {
      length += (curve.points[i] - curve.points[i - 1]).norm();
    }
    EXPECT_NEAR(curve.length, length, 1e-9);
  }
}

// Walking along a polyline with the normal up, f grows to the left.
TEST(ContourOutput, hasLargerValuesToTheLeft)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetContourValues(0, HeightOfTwoCurves);
  update(filter);

  vtkPolyData* output = filter->GetOutput();
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  vtkNew<vtkIdList> ids;
  vtkCellArray* lines = output->GetLines();
  for (lines->InitTraversal(); lines->GetNextCell(ids);)
  {
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      const Vector3d from(output->GetPoint(ids->GetId(i - 1)));
      const Vector3d to(output->GetPoint(ids->GetId(i)));
      const Vector3d normal(normals->GetTuple3(ids->GetId(i)));
      EXPECT_GT(normal.cross(to - from).z(), 0.0);
    }
  }
}

// The arrays are those of the public interface, no more and no less.
TEST(ContourOutput, hasTheArraysOfTheInterface)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud(5000));
  filter->SetContourValues(0, HeightOfTwoCurves);
  update(filter);

  using Names = std::set<std::string>;
  vtkPolyData* contours = filter->GetOutput(0);
  vtkPolyData* samples = filter->GetOutput(1);
  EXPECT_EQ(arrayNames(contours->GetPointData()), Names({ "f", "Normals", "Residual" }));
  EXPECT_EQ(
    arrayNames(contours->GetCellData()), Names({ "IsoValue", "ComponentId", "Closed", "Length" }));
  EXPECT_EQ(arrayNames(contours->GetFieldData()),
    Names({ "IsoValues", "ComponentCounts", "NeighborCount" }));
  EXPECT_EQ(
    arrayNames(samples->GetPointData()), Names({ "f", "Normals", "Residual", "Converged" }));
  EXPECT_NE(vtkDoubleArray::SafeDownCast(contours->GetCellData()->GetArray("IsoValue")), nullptr);
  EXPECT_NE(vtkDoubleArray::SafeDownCast(contours->GetCellData()->GetArray("Length")), nullptr);
  EXPECT_EQ(contours->GetCellData()->GetArray("ComponentId")->GetDataType(), VTK_INT);
  EXPECT_EQ(contours->GetPointData()->GetScalars(), contours->GetPointData()->GetArray("f"));
}

// Field data tell how the number of curves grows with the iso-value, for duplicate and unsorted
// values and those out of range.
TEST(ContourOutput, countsComponentsByAscendingIsoValue)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(Truth::randomTorus(20000, Truth::Torus::Closed, 1), x));
  const std::vector<double> given = { 1.2, 0.3, 7.0, 0.3 };
  for (int i = 0; i < 4; ++i)
  {
    filter->SetContourValues(i, given[static_cast<std::size_t>(i)]);
  }
  expectSilentSuccess(update(filter));

  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  vtkDataArray* values = data->GetArray("IsoValues");
  vtkDataArray* counts = data->GetArray("ComponentCounts");
  ASSERT_EQ(values->GetNumberOfTuples(), 3);
  ASSERT_EQ(counts->GetNumberOfTuples(), 3);
  const std::vector<std::pair<double, int>> expected = { { 0.3, 2 }, { 1.2, 1 }, { 7.0, 0 } };
  for (vtkIdType i = 0; i < 3; ++i)
  {
    EXPECT_EQ(values->GetTuple1(i), expected[static_cast<std::size_t>(i)].first);
    EXPECT_EQ(counts->GetTuple1(i), expected[static_cast<std::size_t>(i)].second);
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 3);
}

// The samples are vertices on the curves, and nearly all of them converge.
TEST(ContourOutput, hasTheSamplesOnTheSecondPort)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetContourValues(0, HeightOfTwoCurves);
  update(filter);

  vtkPolyData* samples = filter->GetOutput(1);
  const vtkIdType count = samples->GetNumberOfPoints();
  ASSERT_GT(count, 100);
  EXPECT_EQ(samples->GetNumberOfVerts(), count);
  EXPECT_EQ(samples->GetNumberOfCells(), count);
  expectPointArrays(samples, "f", HeightOfTwoCurves);
  vtkDataArray* converged = samples->GetPointData()->GetArray("Converged");
  vtkIdType good = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Vector3d place(samples->GetPoint(i));
    if (converged->GetTuple1(i) != 0.0)
    {
      ++good;
      EXPECT_NEAR(place.z(), HeightOfTwoCurves, 1e-3);
      EXPECT_NEAR(Truth::torusDistance(place), 0.0, 1e-3);
    }
  }
  EXPECT_GT(static_cast<double>(good), 0.98 * static_cast<double>(count));
}

// With no iso-value given there is one, in the middle of the range.
TEST(ContourOutput, isMidRangeByDefault)
{
  const Points points = Truth::randomPlane(3000, 1);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(points, [](const Vector3d& p) { return 10.0 + p.x(); }));
  expectSilentSuccess(update(filter));

  const std::vector<Curve> curves = curvesOf(filter);
  ASSERT_THAT(curves, ::testing::SizeIs(1));
  EXPECT_DOUBLE_EQ(
    curves.front().isoValue, 10.0 + 0.5 * (points.row(0).minCoeff() + points.row(0).maxCoeff()));
}

// An implicit function is used exactly; the input needs no array.
TEST(ContourOutput, followsACutFunctionExactly)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetCenter(1.0, 0.0, 0.0);
  sphere->SetRadius(0.7);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(Truth::randomTorus(20000, Truth::Torus::Closed, 1)));
  filter->SetCutFunction(sphere);
  filter->SetContourValues(0, 0.0);
  expectSilentSuccess(update(filter));

  EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(2));
  expectPointArrays(filter->GetOutput(), "CutFunctionValue", 0.0);
  expectPointArrays(filter->GetOutput(1), "CutFunctionValue", 0.0);
  for (const Curve& curve : curvesOf(filter))
  {
    for (const Vector3d& p : curve.points)
    {
      EXPECT_NEAR((p - Vector3d::UnitX()).norm(), 0.7, 1e-6);
    }
  }
}

// The cut function sees the coordinates of the input, wherever they are.
TEST(ContourOutput, cutsInTheCoordinatesOfTheInput)
{
  const Vector3d offset(4e6, 1e6, 300.0);
  Points points = Truth::randomTorus(20000, Truth::Torus::Closed, 1);
  points.colwise() += offset;
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(offset.x(), offset.y(), offset.z() + HeightOfTwoCurves);
  plane->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetCutFunction(plane);
  filter->SetContourValues(0, 0.0);
  expectSilentSuccess(update(filter));

  EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(2));
  for (const Curve& curve : curvesOf(filter))
  {
    for (const Vector3d& p : curve.points)
    {
      EXPECT_NEAR(p.z() - offset.z(), HeightOfTwoCurves, 1e-6);
      EXPECT_NEAR(Truth::torusDistance(p - offset), 0.0, 1e-3);
    }
  }
}
