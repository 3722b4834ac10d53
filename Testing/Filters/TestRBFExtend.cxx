// vtkRBFExtend: what it writes on which kinds of targets.

#include "FieldTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGaussianKernel.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointInterpolator.h"
#include "vtkPoints.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

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

template <typename PointSet>
vtkSmartPointer<PointSet> pointSetTarget(unsigned seed)
{
  const auto target = vtkSmartPointer<PointSet>::New();
  target->SetPoints(makeCloud(0.8 * randomCube(60, seed))->GetPoints());
  return target;
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
TEST(RBFExtend, followsTheTargetsType)
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
TEST(RBFExtend, followsAsTheTargetChanges)
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
TEST(RBFExtend, keepsTheStructureOfComposites)
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

TEST(RBFExtend, takesPartitionedCollections)
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
TEST(RBFExtend, makesAGridAroundTheSamples)
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
TEST(RBFExtend, makesAGridAroundFlatSamples)
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

// The derivatives written are those of the values written: central differences agree.
TEST(RBFExtend, writesGradientAndHessian)
{
  const double step = 1e-4;
  const Vector3d place(0.1, 0.2, -0.3);
  Points targets(3, 7);
  targets.col(0) = place;
  for (int axis = 0; axis < 3; ++axis)
  {
    targets.col(1 + 2 * axis) = place - step * Vector3d::Unit(axis);
    targets.col(2 + 2 * axis) = place + step * Vector3d::Unit(axis);
  }
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(makeCloud(targets));
  filter->ComputeGradientOn();
  filter->ComputeHessianOn();
  expectSilentSuccess(update(filter));
  const Eigen::MatrixXd values = numbersOf(filter->GetOutput(), "f");
  const Eigen::MatrixXd gradients = numbersOf(filter->GetOutput(), "fGradient");
  const Eigen::MatrixXd hessians = numbersOf(filter->GetOutput(), "fHessian");
  ASSERT_EQ(gradients.rows(), 3);
  ASSERT_EQ(hessians.rows(), 6);
  Eigen::Matrix3d hessian;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int before = 1 + 2 * axis;
    EXPECT_NEAR((values(before + 1) - values(before)) / (2 * step), gradients(axis, 0), 1e-6);
    hessian.col(axis) = (gradients.col(before + 1) - gradients.col(before)) / (2 * step);
  }
  const std::vector<std::pair<int, int>> entries = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 },
    { 1, 2 }, { 0, 2 } };
  for (int i = 0; i < 6; ++i)
  {
    const auto [row, column] = entries[static_cast<std::size_t>(i)];
    EXPECT_NEAR(hessian(row, column), hessians(i, 0), 1e-5);
  }
}

// Only what is asked for is written.
TEST(RBFExtend, writesNoMoreThanAskedFor)
{
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(pointSetTarget<vtkPolyData>(2));
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 2);
  filter->ComputeHessianOn();
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_EQ(numbersOf(filter->GetOutput(), "fHessian").rows(), 6);
}

// The schemes that interpolate return the samples.
TEST(RBFExtend, returnsTheSamples)
{
  const auto samples = waveSamples(300);
  for (const int scheme : { 3, 5 })
  {
    vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(samples);
    filter->SetTargetData(makeCloud(randomCube(300, 1)));
    filter->SetScheme(scheme);
    expectSilentSuccess(update(filter));
    const Eigen::MatrixXd error = numbersOf(filter->GetOutput(), "f") - numbersOf(samples, "f");
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-10);
  }
}

// ExplicitMLS is what VTK's interpolator computes with its Gaussian kernel of the same support.
TEST(RBFExtend, equalsVTKsGaussianInterpolation)
{
  const auto samples = waveSamples(2000);
  const auto target = pointSetTarget<vtkPolyData>(5);
  const double radius = 0.4;
  const double sharpness = 2.5;

  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(samples);
  filter->SetTargetData(target);
  filter->SetScheme(vtkRBFExtend::EXPLICIT_MLS);
  filter->SetSearchRadius(radius);
  filter->SetKernelWidth(radius / sharpness);
  expectSilentSuccess(update(filter));

  vtkNew<vtkGaussianKernel> kernel;
  kernel->SetKernelFootprintToRadius();
  kernel->SetRadius(radius);
  kernel->SetSharpness(sharpness);
  vtkNew<vtkPointInterpolator> interpolator;
  interpolator->SetInputData(target);
  interpolator->SetSourceData(samples);
  interpolator->SetKernel(kernel);
  interpolator->Update();
  const Eigen::MatrixXd expected = numbersOf(interpolator->GetOutput(), "f");
  const Eigen::MatrixXd found = numbersOf(filter->GetOutput(), "f");
  ASSERT_EQ(expected.size(), found.size());
  EXPECT_LT((expected - found).cwiseAbs().maxCoeff(), 1e-12);
}

// Points, cells and arrays of the target pass through; nothing is copied, nothing changed.
TEST(RBFExtend, passesTheTargetThrough)
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
TEST(RBFExtend, renamesArraysOfTheSameName)
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

TEST(RBFExtend, givesTheResultTheNameItIsGiven)
{
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(pointSetTarget<vtkPolyData>(2));
  filter->SetResultArrayName("height");
  filter->ComputeGradientOn();
  expectSilentSuccess(update(filter));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "height");
  EXPECT_EQ(numbersOf(filter->GetOutput(), "heightGradient").rows(), 3);
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f").size(), 0);
  filter->SetResultArrayName("Valid");
  expectWarning(update(filter), { "'Valid'", "'ValidInput'" });
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "ValidInput");
}

// Targets farther than MaximumDistance from every sample are marked and get NullValue in all
// arrays.
TEST(RBFExtend, marksTargetsFarOutside)
{
  Points targets(3, 3);
  targets << 0.0, 50.0, 0.1, 0.0, 0.0, 0.1, 0.0, 0.0, 0.1;
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(makeCloud(targets));
  filter->SetMaximumDistance(1.0);
  filter->SetNullValue(-99.0);
  filter->ComputeGradientOn();
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Valid"), Eigen::RowVector3d(1, 0, 1));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f")(1), -99.0);
  EXPECT_EQ(numbersOf(filter->GetOutput(), "fGradient").col(1), Vector3d::Constant(-99.0));
  filter->SetMaximumDistance(0.0);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Valid"), Eigen::RowVector3d(1, 1, 1));
}

// Clamped, no value leaves the range of the samples; the others are the same.
TEST(RBFExtend, keepsValuesWithinTheRange)
{
  const auto samples = waveSamples(300);
  const double lowest = numbersOf(samples, "f").minCoeff();
  const double highest = numbersOf(samples, "f").maxCoeff();
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(samples);
  filter->SetTargetData(makeCloud(3.0 * randomCube(500, 7)));
  expectSilentSuccess(update(filter));
  const Eigen::MatrixXd free = numbersOf(filter->GetOutput(), "f");
  ASSERT_GT(free.maxCoeff(), highest);
  filter->ClampToRangeOn();
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f"), free.cwiseMax(lowest).cwiseMin(highest));
}

// The second of two time steps on the same points, in new arrays, is what a new filter gives.
TEST(RBFExtend, keepsWhatDependsOnPointsOnly)
{
  const Points points = randomCube(400, 1);
  const auto target = pointSetTarget<vtkPolyData>(4);
  const auto extend = [&](vtkRBFExtend* filter, double phase)
  {
    filter->SetInputData(
      makeCloud(points, [=](const Vector3d& p) { return wave(p + Vector3d::Constant(phase)); }));
    filter->SetTargetData(target);
    filter->ComputeGradientOn();
    filter->ComputeHessianOn();
    expectSilentSuccess(update(filter));
  };
  for (const int scheme : { 1, 2, 3, 4, 5 })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkRBFExtend> series;
    series->SetScheme(scheme);
    for (const double phase : { 0.0, 0.5, 1.0, 0.0 })
    {
      extend(series, phase);
      vtkNew<vtkRBFExtend> fresh;
      fresh->SetScheme(scheme);
      extend(fresh, phase);
      expectSameResult(fresh->GetOutput(), series->GetOutput());
    }
  }
}

// What the kept field was made of decides, not when: points, parameters and count may all change.
TEST(RBFExtend, noticesEveryChange)
{
  vtkNew<vtkRBFExtend> series;
  const auto target = pointSetTarget<vtkPolyData>(4);
  const auto expectFresh = [&](vtkPolyData* samples, int scheme, double regularization)
  {
    vtkNew<vtkRBFExtend> fresh;
    for (vtkRBFExtend* filter : { series.Get(), fresh.Get() })
    {
      filter->SetInputData(samples);
      filter->SetTargetData(target);
      filter->SetScheme(scheme);
      filter->SetRegularization(regularization);
      filter->ComputeHessianOn();
      filter->ComputeGradientOn();
      expectSilentSuccess(update(filter));
    }
    expectSameResult(fresh->GetOutput(), series->GetOutput());
  };
  expectFresh(waveSamples(200, 1), 3, 0.0);
  expectFresh(waveSamples(200, 2), 3, 0.0);
  expectFresh(waveSamples(100, 2), 3, 0.0);
  expectFresh(waveSamples(100, 2), 1, 0.0);
  expectFresh(waveSamples(100, 2), 3, 0.1);
}

// The result does not depend on the number of threads; more than one block of targets fits
// together.
TEST(RBFExtend, isTheSameForEveryNumberOfThreads)
{
  std::vector<Eigen::MatrixXd> results;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(waveSamples(200));
    filter->SetScheme(vtkRBFExtend::EXPLICIT_MLS);
    filter->SetGridDimensions(70, 70, 70);
    expectSilentSuccess(update(filter));
    results.push_back(numbersOf(filter->GetOutputDataObject(0), "f"));
  }
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(results[0], results[1]);
}
