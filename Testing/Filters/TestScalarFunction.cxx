// vtkPointSetScalarFunction: its values, what passes through, what it refuses.

#include "FilterTest.h"

#include "vtkPointSetScalarFunction.h"

#include "Sampling.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Runs the filter and compares its active scalars with a function of position.
void expectValues(vtkPointSetScalarFunction* filter, const char* name,
  const std::function<double(const Vector3d&)>& expected)
{
  expectSilentSuccess(update(filter));
  vtkPolyData* output = filter->GetOutput();
  auto* values = vtkDoubleArray::SafeDownCast(output->GetPointData()->GetScalars());
  ASSERT_NE(values, nullptr);
  EXPECT_STREQ(values->GetName(), name);
  ASSERT_EQ(values->GetNumberOfTuples(), output->GetNumberOfPoints());
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(values->GetValue(i), expected(Vector3d(output->GetPoint(i))), 1e-14);
  }
}

vtkSmartPointer<vtkPolyData> sphereCloud()
{
  return makeCloud(Truth::randomSphere(500, 1));
}

void expectRefusal(vtkPointSetScalarFunction* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Point Set Scalar Function", parts);
}

} // namespace

TEST(ScalarFunction, isTheHeightInAUnitDirection)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  expectValues(filter, "Height", [](const Vector3d& p) { return p.z(); });
  filter->SetDirection(0.0, 3.0, 4.0);
  expectValues(filter, "Height", [](const Vector3d& p) { return 0.6 * p.y() + 0.8 * p.z(); });
  filter->SetDirection(0.0, 0.0, -1e-200);
  expectValues(filter, "Height", [](const Vector3d& p) { return -p.z(); });
}

TEST(ScalarFunction, isTheDistanceToAPoint)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  filter->SetFunction(vtkPointSetScalarFunction::DISTANCE_TO_POINT);
  filter->SetCenter(1.0, 2.0, 3.0);
  expectValues(
    filter, "DistanceToPoint", [](const Vector3d& p) { return (p - Vector3d(1, 2, 3)).norm(); });
}

TEST(ScalarFunction, isTheUnsignedDistanceToAPlane)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  filter->SetFunction(vtkPointSetScalarFunction::DISTANCE_TO_PLANE);
  filter->SetOrigin(0.0, 0.5, 0.0);
  filter->SetNormal(0.0, -7.0, 0.0);
  expectValues(filter, "DistanceToPlane", [](const Vector3d& p) { return std::abs(p.y() - 0.5); });
}

TEST(ScalarFunction, hasTheNameItIsGiven)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  filter->SetResultArrayName("elevation");
  expectValues(filter, "elevation", [](const Vector3d& p) { return p.z(); });
  filter->SetResultArrayName("");
  expectValues(filter, "Height", [](const Vector3d& p) { return p.z(); });
}

// Polydata keeps its points, cells and arrays.
TEST(ScalarFunction, passesPolydataThrough)
{
  const auto input = sphereCloud();
  addArray<vtkDoubleArray>(input, "mass", Values::Ones(500));
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  input->SetPolys(triangles);
  vtkNew<vtkDoubleArray> quality;
  quality->SetName("quality");
  quality->InsertNextValue(0.5);
  input->GetCellData()->AddArray(quality);

  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(input);
  expectSilentSuccess(update(filter));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), input->GetPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), 1);
  EXPECT_EQ(output->GetPointData()->GetArray("mass"), input->GetPointData()->GetArray("mass"));
  EXPECT_EQ(output->GetCellData()->GetArray("quality"), quality);
  EXPECT_FALSE(input->GetPointData()->HasArray("Height"));
}

// Other point sets become polydata with a vertex per point.
// What was active before remains, though no longer active.
TEST(ScalarFunction, keepsTheActiveArray)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(makeCloud(Truth::randomSphere(500, 1), Values::Ones(500), "mass"));
  expectSilentSuccess(update(filter));
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("mass"));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Height");
}

TEST(ScalarFunction, makesVerticesOfOtherPointSets)
{
  const auto cloud = sphereCloud();
  addArray<vtkDoubleArray>(cloud, "mass", Values::Ones(500));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cloud->GetPoints());
  grid->GetPointData()->ShallowCopy(cloud->GetPointData());
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(grid);
  expectValues(filter, "Height", [](const Vector3d& p) { return p.z(); });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfVerts(), 500);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 500);
  EXPECT_TRUE(filter->GetOutput()->GetPointData()->HasArray("mass"));
}

// Blocks become one polydata with the arrays they share.
TEST(ScalarFunction, mergesBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned i = 0; i < 2; ++i)
  {
    const auto cloud = sphereCloud();
    addArray<vtkDoubleArray>(cloud, "mass", Values::Constant(500, i));
    blocks->SetBlock(i, cloud);
  }
  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(blocks);
  expectValues(filter, "Height", [](const Vector3d& p) { return p.z(); });
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 1000);
  vtkDataArray* mass = filter->GetOutput()->GetPointData()->GetArray("mass");
  ASSERT_NE(mass, nullptr);
  EXPECT_EQ(mass->GetTuple1(0), 0.0);
  EXPECT_EQ(mass->GetTuple1(999), 1.0);
}

// Points that are nowhere have no value.
TEST(ScalarFunction, givesMissingPointsNaN)
{
  Points points = Truth::randomSphere(100, 1);
  points(2, 3) = NaN;
  points(0, 7) = std::numeric_limits<double>::infinity();
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(makeCloud(points));
  expectWarning(
    update(filter), { "Point Set Scalar Function: 2 of 100 points have a NaN or infinite" });
  vtkDataArray* values = filter->GetOutput()->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < 100; ++i)
  {
    EXPECT_EQ(std::isnan(values->GetTuple1(i)), i == 3 || i == 7);
  }
}

// An array that has the result's name is kept under another; the input keeps its own.
TEST(ScalarFunction, renamesAnArrayOfTheSameName)
{
  const auto cloud = sphereCloud();
  addArray<vtkDoubleArray>(cloud, "Height", Values::Constant(500, 7.0));
  vtkNew<vtkStringArray> words;
  words->SetName("name");
  words->SetNumberOfValues(500);
  words->SetValue(0, "first");
  cloud->GetPointData()->AddArray(words);
  for (const std::string name : { "Height", "name" })
  {
    vtkNew<vtkPointSetScalarFunction> filter;
    filter->SetInputData(cloud);
    filter->SetResultArrayName(name.c_str());
    const std::string renamed = name + "Input";
    expectWarning(update(filter), { name.c_str(), renamed.c_str() });
    vtkPointData* data = filter->GetOutput()->GetPointData();
    EXPECT_STREQ(data->GetScalars()->GetName(), name.c_str());
    ASSERT_TRUE(data->HasArray(renamed.c_str()));
    EXPECT_FALSE(cloud->GetPointData()->HasArray(renamed.c_str()));
    EXPECT_EQ(data->GetAbstractArray(renamed.c_str())->GetVariantValue(0),
      cloud->GetPointData()->GetAbstractArray(name.c_str())->GetVariantValue(0));
  }
}

TEST(ScalarFunction, refusesVectorsWithoutDirection)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  filter->SetDirection(0.0, 0.0, 0.0);
  expectRefusal(
    filter, { "needs a finite Direction other than the zero vector, found (0, 0, 0)." });
  filter->SetFunction(vtkPointSetScalarFunction::DISTANCE_TO_PLANE);
  filter->SetNormal(0.0, NaN, 0.0);
  expectRefusal(filter, { "needs a finite Normal other than the zero vector, found (0, nan, 0)." });
}

TEST(ScalarFunction, refusesPlacesThatAreNone)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  filter->SetFunction(vtkPointSetScalarFunction::DISTANCE_TO_POINT);
  filter->SetCenter(NaN, 0.0, 0.0);
  expectRefusal(filter, { "needs a finite Center, found (nan, 0, 0)." });
}

TEST(ScalarFunction, refusesFunctionsThatDoNotExist)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(sphereCloud());
  filter->SetFunction(7);
  expectRefusal(filter, { "needs Function 0 (Height)", "or 6 (Diffusion), found 7." });
}

TEST(ScalarFunction, refusesNoPoints)
{
  vtkNew<vtkPointSetScalarFunction> filter;
  filter->SetInputData(vtkNew<vtkPolyData>());
  expectRefusal(filter, { "needs points, found none." });
}
