// vtkMeshlessApproximation: bad and unusual input, and what is said about it.

#include "ApproximationTest.h"

#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

void expectRefusal(vtkMeshlessApproximation* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Meshless Approximation", parts);
}

/// Two tori beside each other, as one mesh.
vtkSmartPointer<vtkPolyData> twoTori()
{
  const Points one = TorusGrid::points();
  Points places(3, 2 * one.cols());
  places << one, one.colwise() + Vector3d(5.0, 0.0, 0.0);
  Values values(places.cols());
  values << torusHills(), 2.0 * torusHills();
  const auto mesh = makeCloud(places, values);
  const auto cells =
    gridTriangles({ TorusGrid::Columns, TorusGrid::Rows }, TorusGrid::Columns, TorusGrid::Rows);
  vtkNew<vtkCellArray> twice;
  twice->Append(cells);
  twice->Append(cells, one.cols());
  mesh->SetPolys(twice);
  return mesh;
}

} // namespace

// A constant is reproduced.
TEST(MeshlessApproximationInput, constants)
{
  for (const double value : { 0.0, 7.0, -1e9 })
  {
    const auto mesh = torusMesh(Values::Constant(1152, value));
    const auto filter = approximation(mesh);
    expectWarning(update(filter), { "everywhere" });
    EXPECT_LE(figure(filter, "LInfinityError"), 1e-9 * std::abs(value));
    EXPECT_EQ(figure(filter, "StarCount"), 0);
  }
}

// Points without a value are left out and counted; there u is NaN.
TEST(MeshlessApproximationInput, missingValues)
{
  const auto mesh = torusMesh(torusHills());
  mesh->GetPointData()->GetScalars()->SetComponent(100, 0, NaN);
  const auto image = slopeImage(10, 10, 10);
  image->GetPointData()->GetScalars()->SetComponent(100, 0, NaN);
  for (vtkDataSet* input :
    { static_cast<vtkDataSet*>(mesh.Get()), static_cast<vtkDataSet*>(image.Get()) })
  {
    const auto filter = approximation(input);
    expectWarning(update(filter), { "Left out 1 of" });
    const Eigen::MatrixXd u = numbersOf(filter->GetOutputDataObject(0), "fApproximation");
    EXPECT_TRUE(std::isnan(u(0, 100)));
    EXPECT_EQ(u.array().isNaN().count(), 1);
    EXPECT_EQ(figure(filter, "Missing"), 0.0);
    EXPECT_TRUE(std::isfinite(figure(filter, "LInfinityError")));
  }
}

// Gaussians of a large width are refused with the condition number; with Regularization they are
// solved, and the condition is in a warning.
TEST(MeshlessApproximationInput, illConditionedKernels)
{
  const auto filter = approximation(torusMesh(torusHills()));
  filter->SetKernel(vtkMeshlessApproximation::GAUSSIAN);
  filter->SetKernelWidth(20.0);
  expectRefusal(filter, { "condition" });
  filter->SetRegularization(1e-6);
  expectWarning(update(filter), { "condition" });
  EXPECT_LT(figure(filter, "LInfinityError"), 0.5);
}

// A mesh may have several components, and a boundary.
TEST(MeshlessApproximationInput, componentsAndBoundary)
{
  const auto parts = approximation(twoTori());
  expectSilentSuccess(update(parts));
  EXPECT_EQ(figure(parts, "Missing"), 0.0);
  EXPECT_GE(critical(parts)->GetNumberOfPoints(), 8);
  const auto square = squareMesh(30);
  for (vtkIdType i = 0; i < square->GetNumberOfPoints(); ++i)
  {
    square->GetPointData()->GetScalars()->SetComponent(
      i, 0, wave(Vector3d(square->GetPoint(i)) / 9.7 + Vector3d(0.2, 0.1, 0.0)));
  }
  const auto filter = approximation(square);
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_EQ(figure(filter, "Missing"), 0.0);
}

// Of noise nearly all points are in stars: a warning says so, and a threshold helps.
TEST(MeshlessApproximationInput, noise)
{
  const auto mesh = torusMesh(torusHills() + 0.5 * noise(1152));
  const auto filter = approximation(mesh);
  expectWarning(update(filter), { "PersistenceThreshold" });
  const double stars = figure(filter, "StarCount");
  filter->SetPersistenceThreshold(0.4);
  expectSilentSuccess(update(filter));
  EXPECT_LT(figure(filter, "StarCount"), 0.5 * stars);
  const auto image = slopeImage(10, 10, 10);
  const Values shake = noise(1000);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(
      i, 0, image->GetPointData()->GetScalars()->GetComponent(i, 0) + 0.5 * shake(i));
  }
  const auto volume = approximation(image);
  expectWarning(update(volume), { "PersistenceThreshold" });
  const double starsInVolume = figure(volume, "StarCount");
  volume->SetPersistenceThreshold(0.3);
  EXPECT_TRUE(update(volume).succeeded);
  EXPECT_LT(figure(volume, "StarCount"), 0.5 * starsInVolume);
}

// Whole numbers, and functions that a grid mirrors, are level around critical points: these are
// kept all the same.
TEST(MeshlessApproximationInput, levelStars)
{
  const auto steps = approximation(torusMesh((20.0 * torusHills()).array().floor()));
  steps->SetPersistenceThreshold(0.05);
  EXPECT_TRUE(update(steps).succeeded);
  EXPECT_GE(critical(steps)->GetNumberOfPoints(), 4);
  EXPECT_EQ(figure(steps, "Missing"), 0.0);
  const auto image = slopeImage(12, 12, 12);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, wave(Vector3d(image->GetPoint(i))));
  }
  const auto mirrored = approximation(image);
  EXPECT_TRUE(update(mirrored).succeeded);
  EXPECT_EQ(figure(mirrored, "Missing"), 0.0);
  EXPECT_LT(figure(mirrored, "LInfinityError"), 0.05);
}

TEST(MeshlessApproximationInput, numbersOutOfTheirRange)
{
  const auto expectRefused = [](const auto& change, std::initializer_list<const char*> parts)
  {
    const auto filter = approximation(torusMesh(torusHills()));
    change(*filter);
    expectRefusal(filter, parts);
  };
  using Filter = vtkMeshlessApproximation;
  expectRefused([](Filter& filter) { filter.SetSampleFraction(0.0); }, { "SampleFraction" });
  expectRefused([](Filter& filter) { filter.SetSampleFraction(1.5); }, { "SampleFraction", "1.5" });
  expectRefused([](Filter& filter) { filter.SetSampleFraction(NaN); }, { "SampleFraction" });
  expectRefused(
    [](Filter& filter) { filter.SetPersistenceThreshold(-0.1); }, { "PersistenceThreshold" });
  expectRefused([](Filter& filter) { filter.SetKernel(9); }, { "Kernel", "found 9" });
  expectRefused([](Filter& filter) { filter.SetKernelWidth(-1.0); }, { "KernelWidth" });
  expectRefused([](Filter& filter) { filter.SetRegularization(-1.0); }, { "Regularization" });
  expectRefused([](Filter& filter) { filter.SetCentreSelection(2); }, { "CentreSelection" });
  expectRefused(
    [](Filter& filter) { filter.SetLevelSetConstraints(3); }, { "LevelSetConstraints" });
  expectRefused(
    [](Filter& filter)
    {
      filter.SetCentreSelection(Filter::LEVEL_SETS);
      filter.SetCoverageTolerance(0.0);
    },
    { "CoverageTolerance above 0", "found 0" });
}

TEST(MeshlessApproximationInput, nothingToWorkOn)
{
  expectRefusal(approximation(vtkNew<vtkPolyData>()), { "found no points" });
  expectRefusal(approximation(waveSamples()), { "triangle" });
  const auto bare = slopeImage(4, 4, 4);
  bare->GetPointData()->Initialize();
  expectRefusal(approximation(bare), { "no active scalars" });
  const auto all = torusMesh(Values::Constant(1152, NaN));
  expectRefusal(approximation(all), { "finite" });
}

TEST(MeshlessApproximationInput, stops)
{
  const auto filter = approximation(slopeImage(12, 12, 12));
  for (const double fraction : { 0.02, 0.3, 0.8 })
  {
    expectNothingWhenStopped(filter, fraction);
  }
  expectSilentSuccess(update(filter));
}
