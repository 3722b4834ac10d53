// What vtkPointSetContour can work on: every kind of data set, number and place.

#include "ContourInputTest.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

double x(const Vector3d& p)
{
  return p.x();
}

/// The square root of x: NaN on one side of the plane x = 0.
class RootOfX : public vtkImplicitFunction
{
public:
  static RootOfX* New();
  vtkTypeMacro(RootOfX, vtkImplicitFunction);
  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double place[3]) override { return std::sqrt(place[0]); }
  void EvaluateGradient(double place[3], double gradient[3]) override
  {
    gradient[0] = 0.5 / std::sqrt(place[0]);
    gradient[1] = gradient[2] = 0.0;
  }
};
vtkStandardNewMacro(RootOfX);

/// A plane whose function moves with the time: x - t.
class MovingPlane : public vtkPolyDataAlgorithm
{
public:
  static MovingPlane* New();
  vtkTypeMacro(MovingPlane, vtkPolyDataAlgorithm);

protected:
  MovingPlane() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    const double steps[] = { 0.0, 0.25, 0.5 };
    const double range[] = { 0.0, 0.5 };
    information->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), steps, 3);
    information->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* information = outputs->GetInformationObject(0);
    const double time = information->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    vtkPolyData::GetData(information)
      ->ShallowCopy(
        makeCloud(Truth::randomPlane(2000, 1), [time](const Vector3d& p) { return p.x() - time; }));
    return 1;
  }
};
vtkStandardNewMacro(MovingPlane);

} // namespace

// Missing samples are left out: the curves are those of the rest, and one warning counts them.
TEST(ContourInput, leavesMissingSamplesOut)
{
  Points points = torusPoints();
  const auto clean = makeCloud(Points(points.rightCols(points.cols() - 3)), z);
  Values values = heights(points);
  points(1, 0) = NaN;
  points(0, 1) = Infinity;
  values[2] = -Infinity;

  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(points, values));
  filter->SetContourValues(0, 0.2);
  expectWarning(update(filter), { "Point Set Contour: Left out 3 of 10000 points" });
  expectSame(curvesOf(filter), contour(clean, 0.2));
}

// The same for a place where an implicit function has no value.
TEST(ContourInput, leavesOutWhereACutFunctionIsNotDefined)
{
  const Points points = Truth::randomPlane(5000, 1);
  const std::string missing = std::to_string((points.row(0).array() < 0.0).count());
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(points));
  filter->SetCutFunction(vtkNew<RootOfX>());
  filter->SetContourValues(0, 0.5);
  expectWarning(update(filter), { "Left out ", missing.c_str(), " of 5000 points" });
  const std::vector<Curve> curves = curvesOf(filter);
  ASSERT_THAT(curves, ::testing::SizeIs(1));
  for (const Vector3d& p : curves.front().points)
  {
    EXPECT_NEAR(p.x(), 0.25, 1e-6);
  }
}

// Exact duplicates are one sample.
TEST(ContourInput, countsDuplicatesOnce)
{
  const Points points = torusPoints();
  Points doubled(3, 2 * points.cols());
  doubled << points, points;
  expectSame(contour(makeCloud(doubled, z), 0.2), contour(makeCloud(points, z), 0.2));
}

// Where f has the iso-value on a whole region, the curve is the region's border.
TEST(ContourInput, survivesPlateausAtTheIsoValue)
{
  const auto plateau = [](const Vector3d& p) { return std::max(0.0, std::abs(p.x()) - 0.5); };
  EXPECT_THAT(contour(makeCloud(Truth::randomPlane(5000, 1), plateau), 0.0), ::testing::IsEmpty());
  const auto steps = [](const Vector3d& p) { return std::floor(2.0 * p.x()); };
  for (const Curve& curve : contour(makeCloud(Truth::randomPlane(5000, 1), steps), 0.0))
  {
    for (const Vector3d& p : curve.points)
    {
      EXPECT_NEAR(p.x(), 0.0, 0.2);
    }
  }
}

// Coplanar points are a surface like any other.
TEST(ContourInput, acceptsCoplanarPoints)
{
  Points points = Truth::randomPlane(3000, 1);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto f = [turn](const Vector3d& p) { return (turn.transpose() * p).x(); };
  const std::vector<Curve> curves = contour(makeCloud(Points(turn * points), f), 0.1);
  ASSERT_THAT(curves, ::testing::SizeIs(1));
  EXPECT_NEAR(curves.front().length, 2.0, 0.15); // two steps at either end
}

// Regular sampling is full of ties and coplanar neighborhoods.
TEST(ContourInput, acceptsARegularGrid)
{
  const std::vector<Curve> curves = contour(makeCloud(Truth::squareGrid(60, 1.0), x), 20.5);
  ASSERT_THAT(curves, ::testing::SizeIs(1));
  EXPECT_FALSE(curves.front().closed);
  EXPECT_NEAR(curves.front().length, 59.0, 3.0); // a step and a half at either end
}

// An array with a name that the outputs need is written under another.
TEST(ContourInput, renamesAnArrayWhoseNameIsNeeded)
{
  const Points points = torusPoints(5000);
  for (const std::string name : { "Normals", "Residual", "Converged" })
  {
    vtkNew<vtkPointSetContour> filter;
    filter->SetInputData(makeCloud(points, heights(points), name.c_str()));
    filter->SetContourValues(0, 0.2);
    const std::string renamed = name + "Input";
    expectWarning(update(filter), { "Point Set Contour: ", name.c_str(), renamed.c_str() });
    for (int port = 0; port < 2; ++port)
    {
      vtkPointData* data = filter->GetOutput(port)->GetPointData();
      ASSERT_NE(data->GetArray(renamed.c_str()), nullptr);
      EXPECT_EQ(data->GetArray(renamed.c_str())->GetTuple1(0), 0.2);
      EXPECT_EQ(data->GetArray("Normals")->GetNumberOfComponents(), 3);
    }
  }
}

// Numbers of every type are read as they are.
TEST(ContourInput, readsEveryTypeOfNumber)
{
  const Points points = torusPoints();
  const Values tenths =
    (heights(points) * 100.0).array().round(); // whole numbers: the same in every type
  const auto expected = contour(makeCloud(points, tenths), 20.5);
  const auto cloudOf = [&](auto array)
  {
    const auto cloud = makeCloud(points);
    addArray<std::remove_pointer_t<decltype(array)>>(cloud, "f", tenths);
    cloud->GetPointData()->SetActiveScalars("f");
    return cloud;
  };
  expectSame(contour(cloudOf(static_cast<vtkFloatArray*>(nullptr)), 20.5), expected);
  expectSame(contour(cloudOf(static_cast<vtkIntArray*>(nullptr)), 20.5), expected);
  expectSame(
    contour(cloudOf(static_cast<vtkSOADataArrayTemplate<double>*>(nullptr)), 20.5), expected);
}

// Points of float give what the same points of double give.
TEST(ContourInput, readsPointsOfFloat)
{
  const Points points = torusPoints().cast<float>().cast<double>();
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  const auto cloud = makeCloud(points, z);
  floats->DeepCopy(cloud->GetPoints());
  const auto expected = contour(cloud, 0.2);
  cloud->SetPoints(floats);
  ASSERT_EQ(floats->GetDataType(), VTK_FLOAT);
  expectSame(contour(cloud, 0.2), expected);
}

// Other point sets than polydata are clouds too, and their cells do not matter.
TEST(ContourInput, readsEveryPointSet)
{
  const auto cloud = makeCloud(Truth::squareGrid(50, 0.02), x);
  const auto expected = contour(cloud, 0.413);
  vtkNew<vtkUnstructuredGrid> unstructured;
  unstructured->SetPoints(cloud->GetPoints());
  unstructured->GetPointData()->ShallowCopy(cloud->GetPointData());
  expectSame(contour(unstructured, 0.413), expected);
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(50, 50, 1);
  structured->SetPoints(cloud->GetPoints());
  structured->GetPointData()->ShallowCopy(cloud->GetPointData());
  expectSame(contour(structured, 0.413), expected);
}

// Surfaces that are not connected have curves of their own.
TEST(ContourInput, contoursSeveralSurfaces)
{
  Points points(3, 12000);
  for (int i = 0; i < 3; ++i)
  {
    points.middleCols(4000 * i, 4000) = Truth::randomSphere(4000, 1);
    points.row(0).segment(4000 * i, 4000).array() += 3.0 * i;
  }
  const std::vector<Curve> curves = contour(makeCloud(points, z), 0.5);
  ASSERT_THAT(curves, ::testing::SizeIs(3));
  for (const Curve& curve : curves)
  {
    EXPECT_TRUE(curve.closed);
    EXPECT_NEAR(curve.length, 2.0 * Pi * std::sqrt(0.75), 0.02);
  }
}

// A scan in map coordinates, offset 4,000,000 with steps of a millimetre, has the curves of the
// centered one of unit size.
TEST(ContourInput, worksInMapCoordinates)
{
  const Points points = torusPoints();
  const auto expected = contour(makeCloud(points, z), 0.2);
  const double step = std::sqrt(4.0 * Pi * Pi * Truth::MinorRadius / 10000.0);
  const double scale = 1e-3 / step;
  Points map = scale * points;
  map.colwise() += Vector3d(4e6, 4e6, 4e6);
  std::vector<Curve> curves = contour(makeCloud(map, heights(points)), 0.2);
  ASSERT_EQ(curves.size(), expected.size());
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    EXPECT_TRUE(curves[i].closed);
    EXPECT_NEAR(curves[i].length / scale, expected[i].length, 1e-3);
    for (const Vector3d& p : curves[i].points)
    {
      const Vector3d centered = (p - Vector3d(4e6, 4e6, 4e6)) / scale;
      EXPECT_NEAR(centered.z(), 0.2, 0.01 * step);
      EXPECT_NEAR(Truth::torusDistance(centered), 0.0, 0.01 * step);
    }
  }
}

// The unit does not matter: an object of 1e-9 has the curves of one of unit size, and so has one of
// 1e9.
TEST(ContourInput, worksInEveryUnit)
{
  const Points points = torusPoints();
  const auto expected = contour(makeCloud(points, z), 0.2);
  for (const double scale : { 1e-9, 1e9 })
  {
    SCOPED_TRACE(scale);
    const std::vector<Curve> curves =
      contour(makeCloud(Points(scale * points), heights(points)), 0.2);
    ASSERT_EQ(curves.size(), expected.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      EXPECT_EQ(curves[i].closed, expected[i].closed);
      EXPECT_NEAR(curves[i].length / scale, expected[i].length, 1e-6);
    }
  }
}

// Nor does the unit of f.
TEST(ContourInput, worksInEveryUnitOfTheFunction)
{
  const Points points = torusPoints();
  const auto expected = contour(makeCloud(points, z), 0.2);
  for (const double scale : { 1e-30, 1e30 })
  {
    SCOPED_TRACE(scale);
    const Values values = 3.0 * scale * Values::Ones(points.cols()) + scale * heights(points);
    const std::vector<Curve> curves = contour(makeCloud(points, values), 3.2 * scale);
    ASSERT_EQ(curves.size(), expected.size());
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      EXPECT_NEAR(curves[i].length, expected[i].length, 1e-6);
    }
  }
}

// Every time step is contoured on its own, forwards and back.
TEST(ContourInput, followsTime)
{
  vtkNew<MovingPlane> source;
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetContourValues(0, 0.0);
  for (const double time : { 0.0, 0.5, 0.25, 0.0 })
  {
    filter->UpdateTimeStep(time);
    const std::vector<Curve> curves = curvesOf(filter);
    ASSERT_THAT(curves, ::testing::SizeIs(1));
    for (const Vector3d& p : curves.front().points)
    {
      EXPECT_NEAR(p.x(), time, 1e-8);
    }
  }
}
