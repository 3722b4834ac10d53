// vtkRBFExtend: on which kinds of targets it writes, and on which grid without one.

#include "FieldTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkRectilinearGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

vtkSmartPointer<vtkImageData> imageTarget()
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-1, 2, 0, 4, 3, 5);
  image->SetOrigin(0.1, -0.4, -1.0);
  image->SetSpacing(0.2, 0.2, 0.2);
  return image;
}

vtkSmartPointer<vtkRectilinearGrid> rectilinearTarget()
{
  const auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> coordinates;
  for (const double x : { -0.5, -0.1, 0.0, 0.7 })
  {
    coordinates->InsertNextValue(x);
  }
  grid->SetDimensions(4, 4, 4);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  return grid;
}

/// Expects f~ to be close to the function at the points of a dataset, and that it is what is shown.
void expectWave(vtkDataObject* output)
{
  auto* dataset = vtkDataSet::SafeDownCast(output);
  ASSERT_NE(dataset, nullptr);
  vtkDataArray* values = dataset->GetPointData()->GetScalars();
  ASSERT_NE(values, nullptr);
  EXPECT_STREQ(values->GetName(), "f");
  EXPECT_EQ(values->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(values->GetNumberOfTuples(), dataset->GetNumberOfPoints());
  ASSERT_GT(dataset->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < dataset->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(values->GetTuple1(i), wave(Vector3d(dataset->GetPoint(i))), 0.02);
  }
  EXPECT_TRUE((numbersOf(dataset, "Valid").array() == 1.0).all());
}

/// Runs the filter with 2000 samples on this target.
struct Extended
{
  vtkNew<vtkRBFExtend> filter;
  vtkDataObject* output;

  explicit Extended(vtkDataObject* target)
  {
    this->filter->SetInputData(waveSamples(2000));
    this->filter->SetTargetData(target);
    expectSilentSuccess(update(this->filter));
    this->output = this->filter->GetOutputDataObject(0);
  }
};

} // namespace

// Whatever the target is, the output is of its class, has its points and f~ at them.
TEST(RBFExtendTarget, followsTheTargetsType)
{
  const std::vector<vtkSmartPointer<vtkDataSet>> targets = { pointSetTarget<vtkPolyData>(2),
    pointSetTarget<vtkUnstructuredGrid>(3), imageTarget(), rectilinearTarget() };
  for (const auto& target : targets)
  {
    SCOPED_TRACE(target->GetClassName());
    const Extended extended(target);
    EXPECT_STREQ(extended.output->GetClassName(), target->GetClassName());
    expectWave(extended.output);
    auto* output = vtkDataSet::SafeDownCast(extended.output);
    ASSERT_EQ(output->GetNumberOfPoints(), target->GetNumberOfPoints());
    EXPECT_EQ(Vector3d(output->GetPoint(7)), Vector3d(target->GetPoint(7)));
    EXPECT_FALSE(target->GetPointData()->HasArray("f"));
  }
}

// One filter follows as its target changes, and returns to the grid when it is removed.
TEST(RBFExtendTarget, followsAsTheTargetChanges)
{
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetGridDimensions(8, 8, 8);
  const auto expectType = [&](const char* type)
  {
    expectSilentSuccess(update(filter));
    EXPECT_STREQ(filter->GetOutputDataObject(0)->GetClassName(), type);
    EXPECT_TRUE(numbersOf(filter->GetOutputDataObject(0), "f").allFinite());
  };
  expectType("vtkImageData");
  filter->SetTargetData(pointSetTarget<vtkPolyData>(2));
  expectType("vtkPolyData");
  EXPECT_NE(filter->GetOutput(), nullptr);
  filter->SetTargetData(pointSetTarget<vtkUnstructuredGrid>(2));
  expectType("vtkUnstructuredGrid");
  filter->RemoveTarget();
  expectType("vtkImageData");
  filter->SetTargetData(pointSetTarget<vtkPolyData>(2));
  expectType("vtkPolyData");
  filter->SetTargetData(nullptr);
  expectType("vtkImageData");
}

// A composite target keeps its structure: empty blocks stay empty, every dataset gets its arrays.
TEST(RBFExtendTarget, keepsTheStructureOfComposites)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, imageTarget());
  inner->SetNumberOfBlocks(2);
  vtkNew<vtkMultiBlockDataSet> target;
  target->SetBlock(0, pointSetTarget<vtkPolyData>(2));
  target->SetBlock(2, inner);

  const Extended extended(target);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(extended.output);
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfBlocks(), 3u);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  expectWave(output->GetBlock(0));
  auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  ASSERT_NE(innerOutput, nullptr);
  ASSERT_EQ(innerOutput->GetNumberOfBlocks(), 2u);
  EXPECT_STREQ(innerOutput->GetBlock(0)->GetClassName(), "vtkImageData");
  expectWave(innerOutput->GetBlock(0));
  EXPECT_EQ(innerOutput->GetBlock(1), nullptr);
  EXPECT_FALSE(vtkDataSet::SafeDownCast(inner->GetBlock(0))->GetPointData()->HasArray("f"));
}

TEST(RBFExtendTarget, takesPartitionedCollections)
{
  vtkNew<vtkPartitionedDataSetCollection> target;
  target->SetPartition(0, 0, pointSetTarget<vtkPolyData>(2));
  target->SetPartition(1, 0, imageTarget());
  const Extended extended(target);
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(extended.output);
  ASSERT_NE(output, nullptr);
  expectWave(output->GetPartition(0, 0));
  expectWave(output->GetPartition(1, 0));
}

// Without a target: a grid around the samples, GridPadding of their size wider on each side.
TEST(RBFExtendTarget, makesAGridAroundTheSamples)
{
  Points points = randomCube(300, 1);
  points.col(0) << -1.0, -1.0, -1.0;
  points.col(1) << 1.0, 1.0, 1.0;
  points.row(1) *= 3.0;
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(makeCloud(points, wave));
  filter->SetGridDimensions(11, 13, 1);
  filter->SetGridPadding(0.25);
  expectSilentSuccess(update(filter));
  auto* grid = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ(grid->GetNumberOfPoints(), 11 * 13);
  const double* bounds = grid->GetBounds();
  const std::vector<double> expected = { -1.5, 1.5, -4.5, 4.5, 0.0, 0.0 };
  for (std::size_t i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(bounds[i], expected[i], 1e-12);
  }
  EXPECT_STREQ(grid->GetPointData()->GetScalars()->GetName(), "f");
}

// Flat and collinear samples have a grid too, of voxels that are not flat.
TEST(RBFExtendTarget, makesAGridAroundFlatSamples)
{
  for (const int flatAxes : { 1, 2 })
  {
    Points points = randomCube(100, 1);
    points.bottomRows(flatAxes).setConstant(5.0);
    vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(makeCloud(points, [](const Vector3d& p) { return p.x(); }));
    filter->SetGridDimensions(8, 8, 8);
    expectSilentSuccess(update(filter));
    auto* grid = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
    const double* bounds = grid->GetBounds();
    EXPECT_NEAR(bounds[5] - bounds[4], 0.2, 0.01);
    EXPECT_NEAR(0.5 * (bounds[5] + bounds[4]), 5.0, 1e-12);
    EXPECT_TRUE(numbersOf(grid, "f").allFinite());
  }
}

// Points, cells and arrays of the target pass through; nothing is copied, nothing changed.
TEST(RBFExtendTarget, passesTheTargetThrough)
{
  const auto target = makeCloud(randomCube(10, 2), Values::Ones(10), "mass");
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  target->SetPolys(triangles);
  vtkNew<vtkDoubleArray> quality;
  quality->SetName("quality");
  quality->InsertNextValue(0.5);
  target->GetCellData()->AddArray(quality);
  target->GetFieldData()->AddArray(quality);

  const Extended extended(target);
  vtkPolyData* output = extended.filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), target->GetPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), 1);
  EXPECT_EQ(output->GetPointData()->GetArray("mass"), target->GetPointData()->GetArray("mass"));
  EXPECT_EQ(output->GetCellData()->GetArray("quality"), quality);
  EXPECT_EQ(output->GetFieldData()->GetArray("quality"), quality);
}

// Arrays of the target whose names are needed get others; the target itself keeps its own.
TEST(RBFExtendTarget, renamesArraysOfTheSameName)
{
  const auto target = makeCloud(randomCube(10, 2), Values::Constant(10, 7.0), "f");
  addArray<vtkDoubleArray>(target, "Valid", Values::Constant(10, 8.0));
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(target);
  const Outcome outcome = update(filter);
  EXPECT_THAT(outcome.warnings,
    ::testing::ElementsAre(::testing::HasSubstr("'ValidInput'"), ::testing::HasSubstr("'fInput'")));
  EXPECT_TRUE((numbersOf(filter->GetOutput(), "fInput").array() == 7.0).all());
  EXPECT_TRUE((numbersOf(filter->GetOutput(), "ValidInput").array() == 8.0).all());
  EXPECT_TRUE((numbersOf(filter->GetOutput(), "Valid").array() == 1.0).all());
  EXPECT_TRUE((numbersOf(target, "f").array() == 7.0).all());
}
