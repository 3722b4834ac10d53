// What vtkPointSetContour cannot work on: one clear sentence, empty outputs, failed status.

#include "FilterTest.h"

#include "vtkPointSetContour.h"

#include "Sampling.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

double x(const Vector3d& p)
{
  return p.x();
}

vtkSmartPointer<vtkPolyData> planeCloud(int count = 1000)
{
  return makeCloud(Truth::randomPlane(count, 1), x);
}

/// Chooses f by name, as ParaView does.
void chooseArray(vtkPointSetContour* filter, const char* name,
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS)
{
  filter->SetInputArrayToProcess(0, 0, 0, association, name);
}

void expectRefusal(vtkPointSetContour* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Point Set Contour", parts);
}

void expectRefusal(vtkDataObject* input, std::initializer_list<const char*> parts)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputDataObject(input);
  expectRefusal(filter, parts);
}

/// Success with no curve and not a word.
void expectNoCurves(vtkPointSetContour* filter)
{
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput(0)->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 0);
}

} // namespace

TEST(ContourRefusal, noPoints)
{
  expectRefusal(vtkNew<vtkPolyData>(), { "needs points, found none." });
  expectRefusal(vtkNew<vtkMultiBlockDataSet>(), { "needs points, found none." });
}

TEST(ContourRefusal, fewerPointsThanTheFitNeeds)
{
  expectRefusal(planeCloud(1), { "needs at least", "found 1." });
  expectRefusal(planeCloud(3), { "needs at least", "found 3." });
}

TEST(ContourRefusal, fewerPointsThanTheFitNeedsBecauseSomeAreMissing)
{
  const Points points = Truth::randomPlane(5, 1);
  expectRefusal(makeCloud(points, (Values(5) << 1, NaN, 2, NaN, 3).finished()),
    { "needs at least", "found 3.", "Left out 2 of 5 points" });
}

TEST(ContourRefusal, everyPointMissing)
{
  expectRefusal(makeCloud(Truth::randomPlane(50, 1), Values::Constant(50, NaN)),
    { "needs points with a finite position and value, found none among 50." });
}

TEST(ContourRefusal, noScalars)
{
  expectRefusal(makeCloud(Truth::randomPlane(100, 1)),
    { "no active scalars", "has no point array of one component", "Cell Data to Point Data" });
}

TEST(ContourRefusal, noActiveScalarsButArraysToChooseFrom)
{
  const auto cloud = makeCloud(Truth::randomPlane(100, 1));
  addArray<vtkDoubleArray>(cloud, "temperature", Values::Zero(100));
  addArray<vtkFloatArray>(cloud, "height", Values::Zero(100));
  vtkNew<vtkDoubleArray> normals; // no function: not offered
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  cloud->GetPointData()->AddArray(normals);
  expectRefusal(
    cloud, { "no active scalars", "Choose one of the point arrays 'height', 'temperature'." });
}

TEST(ContourRefusal, anArrayThatIsNotThere)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(planeCloud());
  chooseArray(filter, "g");
  expectRefusal(filter, { "needs the point array 'g'", "Choose the point array 'f'." });
}

TEST(ContourRefusal, aCellArray)
{
  const auto cloud = planeCloud();
  vtkNew<vtkDoubleArray> array;
  array->SetName("quality");
  cloud->GetCellData()->AddArray(array);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(cloud);
  chooseArray(filter, "quality", vtkDataObject::FIELD_ASSOCIATION_CELLS);
  expectRefusal(filter,
    { "needs a point array, found the cell array 'quality'.", "Apply Cell Data to Point Data" });
}

TEST(ContourRefusal, aVector)
{
  const auto cloud = planeCloud();
  vtkNew<vtkDoubleArray> array;
  array->SetName("velocity");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(cloud->GetNumberOfPoints());
  array->Fill(1.0);
  cloud->GetPointData()->AddArray(array);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(cloud);
  chooseArray(filter, "velocity");
  expectRefusal(filter, { "needs an array with one component, found 'velocity' with 3." });
}

TEST(ContourRefusal, words)
{
  const auto cloud = planeCloud();
  vtkNew<vtkStringArray> array;
  array->SetName("label");
  array->SetNumberOfValues(cloud->GetNumberOfPoints());
  cloud->GetPointData()->AddArray(array);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(cloud);
  chooseArray(filter, "label");
  expectRefusal(filter, { "needs an array of numbers, found 'label', a vtkStringArray." });
}

TEST(ContourRefusal, anArrayOfAnotherLength)
{
  const auto cloud = makeCloud(Truth::randomPlane(100, 1));
  addArray<vtkDoubleArray>(cloud, "f", Values::Zero(99));
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(cloud);
  chooseArray(filter, "f");
  expectRefusal(filter, { "needs one value per point, found 'f' with 99 values for 100 points." });
}

TEST(ContourRefusal, allPointsEqual)
{
  const Points points = Vector3d(1, 2, 3).replicate(1, 50);
  expectRefusal(
    makeCloud(points, x), { "needs at least 2 different points, found 50 points at one place." });
}

TEST(ContourRefusal, collinearPoints)
{
  Points points = Truth::randomPlane(200, 1);
  points.row(1) = 2.0 * points.row(0);
  expectRefusal(makeCloud(points, x), { "needs", "found", "points on one line" });
}

TEST(ContourRefusal, aBlockThatIsNoPointSet)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  blocks->SetBlock(0, planeCloud());
  blocks->SetBlock(1, image);
  expectRefusal(blocks, { "found a block of type vtkImageData" });
}

TEST(ContourRefusal, isoValuesThatAreNotFinite)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(planeCloud());
  filter->SetContourValues(0, 0.0);
  filter->SetContourValues(1, NaN);
  expectRefusal(filter, { "needs finite numbers as ContourValues, found nan at index 1." });
  filter->SetContourValues(1, std::numeric_limits<double>::infinity());
  expectRefusal(filter, { "needs finite numbers as ContourValues, found inf at index 1." });
}

TEST(ContourRefusal, choicesThatDoNotExist)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(planeCloud());
  filter->SetScheme(99);
  expectRefusal(filter,
    { "needs Scheme 0 (Linear), 1 (ExplicitMLS), 2 (ParameterizedMLS), 3 (LocalRBF) or 4 "
      "(Hybrid), found 99." });
  filter->SetScheme(2);
  filter->SetSurfaceModel(3);
  expectRefusal(filter, { "needs SurfaceModel 0 (MLS), 1 (RBF) or 2 (Unprojected), found 3." });
  filter->SetSurfaceModel(0);
  filter->SetKernel(9);
  expectRefusal(
    filter, { "needs Kernel from 0 (Gaussian) to 8 (Wu), such as 3 (Cubic), found 9." });
  filter->SetKernel(3);
  filter->SetFit(-1);
  expectRefusal(filter, { "needs Fit 0 (Interpolate) or 1 (LeastSquares), found -1." });
}

TEST(ContourRefusal, numbersOutOfTheirRange)
{
  using Setting = std::function<void(vtkPointSetContour*)>;
  const std::vector<Setting> settings = {
    [](vtkPointSetContour* f) { f->SetPolynomialDegree(0); },
    [](vtkPointSetContour* f) { f->SetPolynomialDegree(5); },
    [](vtkPointSetContour* f) { f->SetNeighborCount(-1); },
    [](vtkPointSetContour* f) { f->SetSearchRadius(-1.0); },
    [](vtkPointSetContour* f) { f->SetSearchRadius(NaN); },
    [](vtkPointSetContour* f) { f->SetKernelWidth(-1.0); },
    [](vtkPointSetContour* f) { f->SetLinkDistance(-1.0); },
    [](vtkPointSetContour* f) { f->SetTolerance(-1.0); },
    [](vtkPointSetContour* f) { f->SetMaximumIterations(-1); },
    [](vtkPointSetContour* f) { f->SetSampleSpacing(-1.0); },
    [](vtkPointSetContour* f) { f->SetSampleSpacing(NaN); },
  };
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    SCOPED_TRACE(i);
    vtkNew<vtkPointSetContour> filter;
    filter->SetInputData(planeCloud());
    settings[i](filter);
    expectRefusal(filter, { "needs", "found" });
  }
}

// After a refusal, a corrected filter works; after a success, a refusal leaves nothing of it.
TEST(ContourRefusal, leavesNoTraces)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(planeCloud());
  expectSilentSuccess(update(filter));
  filter->SetScheme(99);
  expectRefusal(filter, { "Scheme" });
  filter->SetScheme(2);
  expectSilentSuccess(update(filter));
  EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(1));
}

// What follows is unusual but right: no curve, no error.

TEST(ContourNoCurve, isoValuesOutsideTheRange)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(planeCloud());
  filter->SetContourValues(0, 17.0);
  filter->SetContourValues(1, -17.0);
  expectNoCurves(filter);
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("f"), nullptr);
  EXPECT_NE(filter->GetOutput()->GetCellData()->GetArray("IsoValue"), nullptr);
}

TEST(ContourNoCurve, constantFunction)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(makeCloud(Truth::randomPlane(1000, 1), [](const Vector3d&) { return 3.0; }));
  expectNoCurves(filter);
}
