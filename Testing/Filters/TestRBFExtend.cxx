// vtkRBFExtend: what it writes.

#include "FieldTest.h"

#include "vtkGaussianKernel.h"
#include "vtkPointInterpolator.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

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
