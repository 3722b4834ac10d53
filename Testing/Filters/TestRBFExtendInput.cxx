// vtkRBFExtend: unusual and bad input, and what is said about it; abort.

#include "FieldTest.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkImageToStructuredGrid.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkPolyData> someTarget()
{
  return makeCloud(0.9 * randomCube(50, 9));
}

Outcome extend(vtkRBFExtend* filter, vtkDataObject* samples)
{
  filter->SetInputData(samples);
  filter->SetTargetData(someTarget());
  return update(filter);
}

void expectRefusal(
  vtkRBFExtend* filter, vtkDataObject* samples, std::initializer_list<const char*> parts)
{
  expectFailure(filter, extend(filter, samples), "RBF Extend", parts);
}

void expectRefusal(vtkDataObject* samples, std::initializer_list<const char*> parts)
{
  vtkNew<vtkRBFExtend> filter;
  expectRefusal(filter, samples, parts);
}

/// The values at someTarget().
Eigen::MatrixXd extended(vtkDataObject* samples)
{
  vtkNew<vtkRBFExtend> filter;
  expectSilentSuccess(extend(filter, samples));
  return numbersOf(filter->GetOutput(), "f");
}

} // namespace

// Duplicates with the same value change nothing.
TEST(RBFExtendInput, duplicatesWithEqualValues)
{
  const Points points = randomCube(200, 1);
  Points twice(3, 400);
  twice << points, points;
  EXPECT_EQ(extended(makeCloud(twice, wave)), extended(makeCloud(points, wave)));
}

// Duplicates that contradict each other count with their mean; one warning says at how many places.
TEST(RBFExtendInput, duplicatesWithContradictingValues)
{
  const Points points = randomCube(200, 1);
  const auto mean = makeCloud(points, wave);
  Points twice(3, 203);
  twice << points, points.leftCols(3);
  const auto samples = makeCloud(twice, wave);
  vtkDataArray* values = samples->GetPointData()->GetScalars();
  for (const int i : { 0, 1 }) // not 2: the third duplicate agrees
  {
    values->SetTuple1(i, values->GetTuple1(i) + 0.5);
    values->SetTuple1(200 + i, values->GetTuple1(200 + i) - 0.5);
  }
  vtkNew<vtkRBFExtend> filter;
  expectWarning(extend(filter, samples),
    { "RBF Extend: ", "contradict each other: 2.", "the mean of their values" });
  EXPECT_LT((numbersOf(filter->GetOutput(), "f") - extended(mean)).cwiseAbs().maxCoeff(), 1e-9);
}

// What one sample, or samples at one place, determine is a constant.
TEST(RBFExtendInput, oneSample)
{
  for (const int scheme : { 1, 3, 4, 5 })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkRBFExtend> filter;
    filter->SetScheme(scheme);
    expectSilentSuccess(
      extend(filter, makeCloud(Points::Constant(3, 2, 0.5), Values::Constant(2, 7.0))));
    EXPECT_TRUE((numbersOf(filter->GetOutput(), "f").array() == 7.0).all());
  }
}

// Along a line of samples a linear function is reproduced; across it, nothing is known to change.
TEST(RBFExtendInput, collinearSamples)
{
  Points points = Points::Zero(3, 100);
  points.row(0).setLinSpaced(-1.0, 1.0);
  const auto line = makeCloud(points, [](const Vector3d& p) { return 3.0 - 2.0 * p.x(); });
  const Eigen::MatrixXd values = extended(line);
  EXPECT_TRUE(values.allFinite());
  for (Eigen::Index i = 0; i < values.cols(); ++i)
  {
    EXPECT_NEAR(values(i), 3.0 - 2.0 * someTarget()->GetPoint(i)[0], 1e-8);
  }
}

// A width that makes the system singular is refused with what it is and what to change.
TEST(RBFExtendInput, aKernelWidthThatMakesTheSystemSingular)
{
  vtkNew<vtkRBFExtend> filter;
  filter->SetKernel(vtkRBFExtend::GAUSSIAN);
  filter->SetKernelWidth(100.0);
  expectRefusal(filter, waveSamples(),
    { "the Gaussian kernel of width 100", "singular", "condition", "KernelWidth" });
}

// A width that makes spikes of the samples is warned of, with what it is and what to change.
TEST(RBFExtendInput, aKernelWidthFarBelowTheSpacing)
{
  for (const int scheme : { vtkRBFExtend::GLOBAL_RBF, vtkRBFExtend::LOCAL_RBF })
  {
    vtkNew<vtkRBFExtend> filter;
    filter->SetScheme(scheme);
    filter->SetKernel(vtkRBFExtend::WENDLAND);
    filter->SetKernelWidth(0.01);
    expectWarning(extend(filter, waveSamples()),
      { "KernelWidth 0.01", "too narrow", "Wendland", "set it to 0" });
  }
}

// Samples with NaN are left out and counted; the rest is as if they were not there.
TEST(RBFExtendInput, missingSamples)
{
  const Points points = randomCube(200, 1);
  Points more(3, 203);
  more << points, Points::Constant(3, 3, 0.1);
  const auto samples = makeCloud(more, wave);
  samples->GetPointData()->GetScalars()->SetTuple1(200, NaN);
  samples->GetPointData()->GetScalars()->SetTuple1(201, std::numeric_limits<double>::infinity());
  samples->GetPoints()->SetPoint(202, NaN, 0.0, 0.0);
  vtkNew<vtkRBFExtend> filter;
  expectWarning(extend(filter, samples), { "RBF Extend: Left out 3 of 203 points" });
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f"), extended(makeCloud(points, wave)));
}

TEST(RBFExtendInput, nothingButMissingSamples)
{
  expectRefusal(makeCloud(randomCube(50, 1), Values::Constant(50, NaN)),
    { "needs points with a finite position and value, found none among 50." });
}

TEST(RBFExtendInput, noPoints)
{
  expectRefusal(vtkNew<vtkPolyData>(), { "needs points, found none." });
}

TEST(RBFExtendInput, noScalars)
{
  expectRefusal(makeCloud(randomCube(50, 1)), { "no active scalars" });
}

// Of an image or another grid the points count, alone or as a block.
TEST(RBFExtendInput, samplesOnGrids)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 6, 7);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(0.5, 0.4, 0.3);
  Points points(3, image->GetNumberOfPoints());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    image->GetPoint(i, points.col(i).data());
  }
  const auto cloud = makeCloud(points, wave);
  image->GetPointData()->ShallowCopy(cloud->GetPointData());
  vtkNew<vtkImageToStructuredGrid> convert;
  convert->SetInputData(image);
  convert->Update();
  convert->GetOutput()->GetPointData()->SetActiveScalars("f");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, image);
  const Eigen::MatrixXd expected = extended(cloud);
  EXPECT_EQ(extended(image), expected);
  EXPECT_EQ(extended(convert->GetOutput()), expected);
  EXPECT_EQ(extended(blocks), expected);
}

// Blocks of samples are one cloud.
TEST(RBFExtendInput, samplesInBlocks)
{
  const Points points = randomCube(200, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(points.leftCols(70), wave));
  blocks->SetBlock(1, makeCloud(points.rightCols(130), wave));
  EXPECT_EQ(extended(blocks), extended(makeCloud(points, wave)));
}

// A target that is nowhere gets no value.
TEST(RBFExtendInput, targetsThatAreNotFinite)
{
  Points targets = randomCube(3, 2);
  targets(1, 1) = NaN;
  targets(2, 2) = std::numeric_limits<double>::infinity();
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(makeCloud(targets));
  filter->SetNullValue(-1.0);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "Valid"), Eigen::RowVector3d(1, 0, 0));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f").rightCols(2), Eigen::RowVector2d(-1, -1));
}

// An empty target, also one of empty blocks, comes out empty with the arrays, and a warning.
TEST(RBFExtendInput, anEmptyTarget)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkPolyData>());
  const std::vector<vtkSmartPointer<vtkDataObject>> targets = { vtkSmartPointer<vtkPolyData>::New(),
    vtkSmartPointer<vtkUnstructuredGrid>::New(), vtkSmartPointer<vtkImageData>::New(),
    blocks.Get() };
  for (const auto& target : targets)
  {
    SCOPED_TRACE(target->GetClassName());
    vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(waveSamples());
    filter->SetTargetData(target);
    expectWarning(update(filter), { "RBF Extend: The target has no points" });
    vtkDataObject* output = filter->GetOutputDataObject(0);
    if (auto* composite = vtkMultiBlockDataSet::SafeDownCast(output))
    {
      output = composite->GetBlock(0);
    }
    auto* dataset = vtkDataSet::SafeDownCast(output);
    ASSERT_NE(dataset, nullptr);
    EXPECT_TRUE(dataset->GetPointData()->HasArray("f"));
    EXPECT_TRUE(dataset->GetPointData()->HasArray("Valid"));
    EXPECT_GT(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfPoints(), 0);
  }
}

TEST(RBFExtendInput, aTargetWithABlockWithoutPoints)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, someTarget());
  blocks->SetBlock(1, vtkNew<vtkTable>());
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetTargetData(blocks);
  expectFailure(
    filter, update(filter), "RBF Extend", { "found a block of type vtkTable", "Extract Block" });
}

TEST(RBFExtendInput, choicesAndNumbersOutOfTheirRange)
{
  using Setting = std::pair<std::function<void(vtkRBFExtend*)>, const char*>;
  const std::vector<Setting> settings = {
    { [](vtkRBFExtend* f) { f->SetScheme(0); }, "needs Scheme 1 (ExplicitMLS)" },
    { [](vtkRBFExtend* f) { f->SetScheme(6); }, "found 6" },
    { [](vtkRBFExtend* f) { f->SetKernel(9); }, "needs Kernel 0 (Gaussian)" },
    { [](vtkRBFExtend* f) { f->SetKernel(-1); }, "found -1" },
    { [](vtkRBFExtend* f) { f->SetKernelWidth(-1.0); }, "KernelWidth" },
    { [](vtkRBFExtend* f) { f->SetKernelWidth(NaN); }, "KernelWidth" },
    { [](vtkRBFExtend* f) { f->SetNeighborCount(-1); }, "NeighborCount" },
    { [](vtkRBFExtend* f) { f->SetSearchRadius(-1.0); }, "SearchRadius" },
    { [](vtkRBFExtend* f) { f->SetRegularization(-1.0); }, "Regularization" },
    { [](vtkRBFExtend* f) { f->SetHybridThreshold(-1.0); }, "hreshold" },
    { [](vtkRBFExtend* f) { f->SetMaximumDistance(-1.0); }, "MaximumDistance" },
  };
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    SCOPED_TRACE(i);
    vtkNew<vtkRBFExtend> filter;
    settings[i].first(filter);
    expectRefusal(filter, waveSamples(), { "needs", settings[i].second });
  }
}

// So are those of the grid, but only where there is one.
TEST(RBFExtendInput, gridsOutOfTheirRange)
{
  using Setting = std::pair<std::function<void(vtkRBFExtend*)>, const char*>;
  const std::vector<Setting> settings = {
    { [](vtkRBFExtend* f) { f->SetGridDimensions(4, 0, 4); }, "found 4 0 4" },
    { [](vtkRBFExtend* f) { f->SetGridPadding(-0.1); }, "GridPadding" },
    { [](vtkRBFExtend* f) { f->SetGridPadding(NaN); }, "GridPadding" },
  };
  for (const Setting& setting : settings)
  {
    SCOPED_TRACE(setting.second);
    vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(waveSamples());
    setting.first(filter);
    expectFailure(filter, update(filter), "RBF Extend", { "needs", setting.second });
    filter->SetTargetData(someTarget());
    expectSilentSuccess(update(filter));
  }
}

// After a refusal, a corrected filter works; after a success, a refusal leaves nothing of it.
TEST(RBFExtendInput, leavesNoTraces)
{
  vtkNew<vtkRBFExtend> filter;
  const auto samples = waveSamples();
  expectSilentSuccess(extend(filter, samples));
  filter->SetKernel(vtkRBFExtend::GAUSSIAN);
  filter->SetKernelWidth(100.0);
  expectRefusal(filter, samples, { "singular" });
  filter->SetKernel(vtkRBFExtend::CUBIC);
  filter->SetKernelWidth(0.0);
  expectSilentSuccess(extend(filter, samples));
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f"), extended(samples));
}

// Stopped anywhere, the filter leaves nothing and says nothing; run again, it does all its work.
TEST(RBFExtendInput, leavesNothingWhenStopped)
{
  const auto samples = waveSamples(20000);
  for (const double fraction : { 0.02, 0.2, 0.5, 0.9 })
  {
    SCOPED_TRACE(fraction);
    vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(samples);
    filter->SetGridDimensions(24, 24, 24);
    expectNothingWhenStopped(filter, fraction);
    expectSilentSuccess(update(filter));
    EXPECT_EQ(numbersOf(filter->GetOutputDataObject(0), "f").cols(), 24 * 24 * 24);
  }
}

// A structured grid of samples counts as a whole, whatever extent is asked of a structured output.
TEST(RBFExtendInput, readsAllOfStructuredSamples)
{
  vtkNew<vtkImageData> source;
  source->SetDimensions(9, 9, 9);
  source->SetOrigin(-1.0, -1.0, -1.0);
  source->SetSpacing(0.25, 0.25, 0.25);
  vtkNew<vtkImageToStructuredGrid> samples;
  vtkNew<vtkImageData> target;
  target->SetDimensions(3, 3, 3);
  target->SetOrigin(-0.9, -0.9, -0.9);
  target->SetSpacing(0.9, 0.9, 0.9);
  vtkNew<vtkDoubleArray> values;
  values->SetName("f");
  for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
  {
    values->InsertNextValue(wave(Vector3d(source->GetPoint(i))));
  }
  source->GetPointData()->SetScalars(values);
  samples->SetInputData(source);
  for (vtkDataObject* chosen :
    { static_cast<vtkDataObject*>(nullptr), static_cast<vtkDataObject*>(target.Get()) })
  {
    const vtkNew<vtkRBFExtend> filter;
    filter->SetInputConnection(samples->GetOutputPort());
    filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "f");
    filter->SetTargetData(chosen);
    filter->SetGridDimensions(4, 4, 4);
    expectSilentSuccess(update(filter));
    EXPECT_EQ(numbersOf(filter->GetOutputDataObject(1), "Coefficient").cols(), 729);
  }
}

// A grid that cannot be counted is refused before anything is allocated.
TEST(RBFExtendInput, refusesHugeGrids)
{
  const vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples(50));
  filter->SetGridDimensions(2000, 2000, 2000);
  expectFailure(filter, update(filter), "RBF Extend", { "2147483647 points", "2000 2000 2000" });
}

// A model is not samples: its coefficients are not values.
TEST(RBFExtendInput, refusesAModel)
{
  const vtkNew<vtkRBFExtend> first;
  first->SetInputData(waveSamples(50));
  const vtkNew<vtkRBFExtend> second;
  second->SetInputConnection(first->GetOutputPort(1));
  expectFailure(second, update(second), "RBF Extend", { "Model", "RBF Evaluate" });
}

// Where no target is near enough, that is said.
TEST(RBFExtendInput, saysThatNoTargetIsValid)
{
  const vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples(50));
  filter->SetTargetData(makeCloud(Points(randomCube(5, 2).array() + 100.0)));
  filter->SetMaximumDistance(1.0);
  expectWarning(update(filter), { "No target has a value", "MaximumDistance" });
}
