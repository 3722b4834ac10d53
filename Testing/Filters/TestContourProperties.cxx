// The properties of vtkPointSetContour: the list of iso-values, and what makes the filter run
// again.

#include "FilterTest.h"

#include "vtkPointSetContour.h"

#include "Sampling.h"
#include "Torus.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

double z(const Vector3d& p)
{
  return p.z();
}

vtkSmartPointer<vtkPolyData> torusCloud(int count = 10000)
{
  return makeCloud(Truth::randomTorus(count, Truth::Torus::Closed, 1), z);
}

} // namespace

TEST(ContourProperties, haveTheDefaultsOfTheInterface)
{
  vtkNew<vtkPointSetContour> filter;
  EXPECT_EQ(filter->GetNumberOfContourValues(), 0);
  EXPECT_EQ(filter->GetScheme(), 2);
  EXPECT_EQ(filter->GetSurfaceModel(), 0);
  EXPECT_EQ(filter->GetPolynomialDegree(), 2);
  EXPECT_EQ(filter->GetNeighborCount(), 0);
  EXPECT_EQ(filter->GetSearchRadius(), 0.0);
  EXPECT_EQ(filter->GetKernel(), 3);
  EXPECT_EQ(filter->GetKernelWidth(), 0.0);
  EXPECT_EQ(filter->GetCutFunction(), nullptr);
  EXPECT_EQ(filter->GetLinkDistance(), 0.0);
  EXPECT_EQ(filter->GetTolerance(), 1e-7);
  EXPECT_EQ(filter->GetMaximumIterations(), 20);
  EXPECT_EQ(filter->GetFit(), 0);
  EXPECT_EQ(filter->GetSampleSpacing(), 0.0);
}

// The list grows, shrinks and keeps its values as VTK's lists do.
TEST(ContourProperties, keepAListOfIsoValues)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetContourValues(1, 5.0);
  EXPECT_EQ(filter->GetNumberOfContourValues(), 2);
  EXPECT_EQ(filter->GetContourValues(0), 0.0);
  EXPECT_EQ(filter->GetContourValues(1), 5.0);
  filter->SetNumberOfContourValues(1);
  EXPECT_EQ(filter->GetNumberOfContourValues(), 1);
  filter->SetNumberOfContourValues(0);
  EXPECT_EQ(filter->GetNumberOfContourValues(), 0);
}

// Only a change makes the filter run again; a change of the cut function is one.
TEST(ContourProperties, countAsModifiedWhenTheyChange)
{
  vtkNew<vtkPointSetContour> filter;
  vtkNew<vtkPlane> plane;
  filter->SetCutFunction(plane);
  filter->SetContourValues(0, 1.0);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetCutFunction(plane);
  filter->SetContourValues(0, 1.0);
  filter->SetNumberOfContourValues(1);
  EXPECT_EQ(filter->GetMTime(), before);
  plane->SetOrigin(1.0, 0.0, 0.0);
  EXPECT_GT(filter->GetMTime(), before);
  filter->SetCutFunction(nullptr);
  EXPECT_EQ(filter->GetCutFunction(), nullptr);
}

// Moving the cut function moves the curves.
TEST(ContourProperties, letTheCutFunctionMove)
{
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.0, 0.0, 1.0);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetCutFunction(plane);
  filter->SetContourValues(0, 0.0);
  for (const double height : { 0.1, -0.3 })
  {
    plane->SetOrigin(0.0, 0.0, height);
    expectSilentSuccess(update(filter));
    const std::vector<Curve> curves = curvesOf(filter);
    ASSERT_THAT(curves, ::testing::SizeIs(2));
    EXPECT_NEAR(curves.front().points.front().z(), height, 1e-6);
  }
}

// Another array by name wins over the active scalars.
TEST(ContourProperties, chooseTheArray)
{
  const auto cloud = torusCloud();
  Values x(cloud->GetNumberOfPoints());
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    x[i] = cloud->GetPoint(i)[0];
  }
  addArray<vtkDoubleArray>(cloud, "x", x);
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(cloud);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "x");
  filter->SetContourValues(0, 1.2);
  expectSilentSuccess(update(filter));
  EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(1));
  ASSERT_NE(filter->GetOutput()->GetPointData()->GetArray("x"), nullptr);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("f"), nullptr);
}

// Every scheme finds the two circles; what differs is how exactly.
TEST(ContourProperties, offerEverySchemeAndSurface)
{
  for (const int scheme : { 0, 1, 2, 3, 4 })
  {
    for (const int surface : { 0, 1, 2 })
    {
      SCOPED_TRACE(::testing::Message() << "scheme " << scheme << ", surface " << surface);
      vtkNew<vtkPointSetContour> filter;
      filter->SetInputData(torusCloud());
      filter->SetScheme(scheme);
      filter->SetSurfaceModel(surface);
      filter->SetContourValues(0, 0.2);
      expectSilentSuccess(update(filter));
      EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(2));
    }
  }
}

// Every kernel finds them, for the function and for the surface.
TEST(ContourProperties, offerEveryKernel)
{
  for (int kernel = 0; kernel <= 8; ++kernel)
  {
    SCOPED_TRACE(kernel);
    vtkNew<vtkPointSetContour> filter;
    filter->SetInputData(torusCloud());
    filter->SetScheme(3);
    filter->SetSurfaceModel(1);
    filter->SetKernel(kernel);
    filter->SetContourValues(0, 0.2);
    expectSilentSuccess(update(filter));
    EXPECT_THAT(curvesOf(filter), ::testing::SizeIs(2));
  }
}

// The spacing of the curve's points is a length.
TEST(ContourProperties, spaceThePointsOfACurve)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(torusCloud());
  filter->SetContourValues(0, 0.2);
  for (const int fit : { 0, 1 })
  {
    SCOPED_TRACE(fit);
    filter->SetFit(fit);
    filter->SetSampleSpacing(0.02);
    expectSilentSuccess(update(filter));
    ASSERT_THAT(curvesOf(filter), ::testing::SizeIs(2));
    for (const Curve& curve : curvesOf(filter))
    {
      for (std::size_t i = 1; i < curve.points.size(); ++i)
      {
        EXPECT_NEAR((curve.points[i] - curve.points[i - 1]).norm(), 0.02, 0.002);
      }
    }
  }
}

TEST(ContourProperties, arePrinted)
{
  vtkNew<vtkPointSetContour> filter;
  filter->SetContourValues(0, 1.25);
  std::ostringstream text;
  filter->Print(text);
  EXPECT_THAT(text.str(), ::testing::HasSubstr("ContourValues: 1.25"));
  EXPECT_THAT(text.str(), ::testing::HasSubstr("MaximumIterations: 20"));
}
