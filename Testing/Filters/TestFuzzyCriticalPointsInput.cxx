// What vtkFuzzyCriticalPoints can work on, and what it refuses.

#include "CriticalPointTest.h"

#include "vtkCellArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
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

/// A hill and a hollow in the plane.
double hillAndHollow(const Vector3d& p)
{
  const auto bell = [&](double x)
  { return std::exp(-8.0 * (p - Vector3d(x, 0.0, 0.0)).squaredNorm()); };
  return bell(0.45) - bell(-0.45);
}

const std::vector<CriticalType> HillAndHollowTypes = { CriticalType::Minimum,
  CriticalType::Maximum };

/// The centered square grid of 60 x 60 points.
Points grid()
{
  Points points = Truth::squareGrid(60, 2.0 / 59.0);
  points.topRows(2).array() -= 1.0;
  return points;
}

void expectSameAsTorus(vtkDataObject* input)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputDataObject(input);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
}

void expectRefusal(vtkFuzzyCriticalPoints* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Fuzzy Critical Points", parts);
}

void expectRefusal(vtkDataObject* input, std::initializer_list<const char*> parts)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputDataObject(input);
  expectRefusal(filter, parts);
}

} // namespace

// Polydata keeps its cells and arrays.
TEST(FuzzyCriticalPointsInput, passesPolydataThrough)
{
  const auto cloud = tiltedTorus(3000);
  addArray<vtkDoubleArray>(cloud, "mass", Values::Ones(3000));
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  cloud->SetPolys(triangles);
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), 1);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 1);
  EXPECT_EQ(sampleArray(filter, "mass"), cloud->GetPointData()->GetArray("mass"));
  EXPECT_FALSE(cloud->GetPointData()->HasArray("Normals"));
}

// Other point sets become polydata with a vertex per point.
TEST(FuzzyCriticalPointsInput, makesVerticesOfOtherPointSets)
{
  const auto cloud = makeCloud(grid(), hillAndHollow);
  vtkNew<vtkUnstructuredGrid> unstructured;
  unstructured->SetPoints(cloud->GetPoints());
  unstructured->GetPointData()->ShallowCopy(cloud->GetPointData());
  vtkNew<vtkStructuredGrid> structured;
  structured->SetDimensions(60, 60, 1);
  structured->SetPoints(cloud->GetPoints());
  structured->GetPointData()->ShallowCopy(cloud->GetPointData());
  for (vtkPointSet* input : std::initializer_list<vtkPointSet*>{ unstructured, structured })
  {
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(input);
    expectSilentSuccess(update(filter));
    EXPECT_EQ(filter->GetOutput()->GetNumberOfVerts(), 3600);
    EXPECT_EQ(sampleArray(filter, "CriticalType")->GetNumberOfTuples(), 3600);
    EXPECT_THAT(typesOf(filter), ::testing::IsSupersetOf(HillAndHollowTypes));
  }
}

// Missing samples are left out, get NaN and -1, and one warning counts them; ids stay those of the
// input.
TEST(FuzzyCriticalPointsInput, leavesMissingSamplesOut)
{
  Points points = Truth::randomTorus(10003, Truth::Torus::Closed, 1);
  Values values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    values[i] = tiltedHeight(points.col(i));
  }
  points(1, 0) = NaN;
  values[1] = std::numeric_limits<double>::infinity();
  values[5000] = NaN;
  const auto cloud = makeCloud(points, values);
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  expectWarning(update(filter), { "Fuzzy Critical Points: Left out 3 of 10003 points" });
  EXPECT_EQ(typesOf(filter), TorusTypes);
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 10003);
  for (vtkIdType i = 0; i < 10003; ++i)
  {
    const bool isMissing = i == 0 || i == 1 || i == 5000;
    EXPECT_EQ(std::isnan(sampleArray(filter, "CriticalProbability")->GetTuple1(i)), isMissing);
    EXPECT_EQ(std::isnan(sampleArray(filter, "Gradient")->GetComponent(i, 2)), isMissing);
    EXPECT_EQ(std::isnan(sampleArray(filter, "Normals")->GetComponent(i, 0)), isMissing);
    EXPECT_EQ(sampleArray(filter, "CriticalType")->GetTuple1(i) == -1.0, isMissing);
  }
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    const Vector3d sample(cloud->GetPoint(static_cast<vtkIdType>(point.input)));
    EXPECT_LT((sample - point.position).norm(), 0.05);
  }
}

// Samples at one place are one sample and share its arrays.
TEST(FuzzyCriticalPointsInput, countsDuplicatesOnce)
{
  const Points once = Truth::randomTorus(5000, Truth::Torus::Closed, 1);
  Points twice(3, 10000);
  twice << once, once;
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(makeCloud(twice, tiltedHeight));
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    for (const char* name : { "CriticalProbability", "CriticalType", "Gradient", "Normals" })
    {
      EXPECT_EQ(sampleArray(filter, name)->GetTuple(i)[0],
        sampleArray(filter, name)->GetTuple(i + 5000)[0]);
    }
  }
}

// Arrays whose names are needed are kept under others, f among them.
TEST(FuzzyCriticalPointsInput, renamesArraysWhoseNamesAreNeeded)
{
  const auto cloud = tiltedTorus(5000);
  addArray<vtkDoubleArray>(cloud, "Normals", Values::Ones(5000));
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  expectWarning(update(filter), { "'Normals'", "'NormalsInput'" });
  EXPECT_EQ(sampleArray(filter, "NormalsInput")->GetTuple1(0), 1.0);
  EXPECT_EQ(sampleArray(filter, "Normals")->GetNumberOfComponents(), 3);

  const auto named = makeCloud(Truth::randomTorus(5000, Truth::Torus::Closed, 1));
  Values values(5000);
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    values[i] = tiltedHeight(Vector3d(named->GetPoint(i)));
  }
  addArray<vtkDoubleArray>(named, "Gradient", values);
  filter->SetInputData(named);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Gradient");
  expectWarning(update(filter), { "'Gradient'", "'GradientInput'" });
  EXPECT_EQ(typesOf(filter), TorusTypes);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "GradientInput");
  EXPECT_EQ(sampleArray(filter, "GradientInput")->GetTuple1(7), values[7]);
}

// The blocks of a composite dataset are one surface; ids count through them.
TEST(FuzzyCriticalPointsInput, mergesTiles)
{
  const Points points = Truth::randomTorus(10000, Truth::Torus::Closed, 1);
  const auto isLeft = [](const Vector3d& p) { return p.x() < 0.0; };
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(Truth::select(points, isLeft), tiltedHeight));
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2,
    makeCloud(Truth::select(points, [&](const Vector3d& p) { return !isLeft(p); }), tiltedHeight));
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(blocks);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  ASSERT_EQ(filter->GetOutput()->GetNumberOfPoints(), 10000);
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    const Vector3d sample(filter->GetOutput()->GetPoint(static_cast<vtkIdType>(point.input)));
    EXPECT_LT((sample - point.position).norm(), 0.05);
  }
}

// Ghost points belong to another tile: wrong values do no harm, and no warning counts them.
TEST(FuzzyCriticalPointsInput, leavesGhostPointsOut)
{
  const auto cloud = tiltedTorus();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(10000);
  ghosts->FillValue(0);
  for (vtkIdType i = 0; i < 10000; i += 7)
  {
    ghosts->SetValue(i, vtkDataSetAttributes::DUPLICATEPOINT);
    cloud->GetPointData()->GetScalars()->SetTuple1(i, i % 2 ? NaN : 1000.0);
  }
  cloud->GetPointData()->AddArray(ghosts);
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  EXPECT_EQ(sampleArray(filter, "CriticalType")->GetTuple1(7), -1.0);
  EXPECT_NE(sampleArray(filter, "CriticalType")->GetTuple1(8), -1.0);
}

// Neither the place nor the units matter.
TEST(FuzzyCriticalPointsInput, worksInMapCoordinatesAndEveryUnit)
{
  const Points points = Truth::randomTorus(10000, Truth::Torus::Closed, 1);
  Values values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    values[i] = tiltedHeight(points.col(i));
  }
  Points map = points;
  map.colwise() += Vector3d(4e6, 4e6, 4e6);
  expectSameAsTorus(makeCloud(map, values));
  expectSameAsTorus(makeCloud(Points(1e-9 * points), values));
  expectSameAsTorus(makeCloud(Points(1e9 * points), Values(1e-30 * values)));
  expectSameAsTorus(makeCloud(points, Values(1e30 * values)));
}

TEST(FuzzyCriticalPointsRefusal, noPoints)
{
  expectRefusal(vtkNew<vtkPolyData>(), { "needs points, found none." });
  expectRefusal(vtkNew<vtkMultiBlockDataSet>(), { "needs points, found none." });
}

TEST(FuzzyCriticalPointsRefusal, fewPoints)
{
  expectRefusal(tiltedTorus(1), { "needs at least", "found 1" });
  expectRefusal(tiltedTorus(2), { "needs at least", "found 2" });
  expectRefusal(tiltedTorus(5), { "needs at least", "found 5" });
  expectRefusal(makeCloud(Points(Vector3d(1, 2, 3).replicate(1, 50)), tiltedHeight),
    { "needs at least 2 different points, found 50 points at one place." });
}

TEST(FuzzyCriticalPointsRefusal, onlyMissingValues)
{
  expectRefusal(makeCloud(Truth::randomPlane(50, 1), Values(Values::Constant(50, NaN))),
    { "needs points with a finite position and value, found none among 50." });
}

TEST(FuzzyCriticalPointsRefusal, noArray)
{
  expectRefusal(makeCloud(Truth::randomPlane(100, 1)), { "no active scalars" });
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus(500));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "g");
  expectRefusal(filter, { "needs the point array 'g'", "Choose the point array 'f'." });
}

TEST(FuzzyCriticalPointsRefusal, aBlockThatIsNoPointSet)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  blocks->SetBlock(0, tiltedTorus(500));
  blocks->SetBlock(1, image);
  expectRefusal(blocks, { "found a block of type vtkImageData" });
}

TEST(FuzzyCriticalPointsRefusal, choicesThatDoNotExist)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus(500));
  for (const int scheme : { 0, 5, 99 })
  {
    filter->SetScheme(scheme);
    expectRefusal(filter,
      { "needs Scheme 1 (ExplicitMLS), 2 (ParameterizedMLS), 3 (LocalRBF) or 4 (Hybrid), found" });
  }
  filter->SetScheme(2);
  filter->SetKernel(9);
  expectRefusal(
    filter, { "needs Kernel from 0 (Gaussian) to 8 (Wu), such as 3 (Cubic), found 9." });
  filter->SetKernel(3);
  filter->SetProbabilityModel(2);
  expectRefusal(filter, { "needs ProbabilityModel 0 (Gradient) or 1 (NormalAngle), found 2." });
}

TEST(FuzzyCriticalPointsRefusal, numbersOutOfTheirRange)
{
  using Setting = std::function<void(vtkFuzzyCriticalPoints*)>;
  const std::vector<Setting> settings = {
    [](vtkFuzzyCriticalPoints* f) { f->SetPolynomialDegree(0); },
    [](vtkFuzzyCriticalPoints* f) { f->SetPolynomialDegree(5); },
    [](vtkFuzzyCriticalPoints* f) { f->SetNeighborCount(-1); },
    [](vtkFuzzyCriticalPoints* f) { f->SetNeighborCount(3); },
    [](vtkFuzzyCriticalPoints* f) { f->SetSearchRadius(-1.0); },
    [](vtkFuzzyCriticalPoints* f) { f->SetSearchRadius(NaN); },
    [](vtkFuzzyCriticalPoints* f) { f->SetKernelWidth(-1.0); },
    [](vtkFuzzyCriticalPoints* f) { f->SetProbabilityThreshold(-0.1); },
    [](vtkFuzzyCriticalPoints* f) { f->SetProbabilityThreshold(1.1); },
    [](vtkFuzzyCriticalPoints* f) { f->SetProbabilityThreshold(NaN); },
    [](vtkFuzzyCriticalPoints* f) { f->SetPersistenceThreshold(-0.1); },
    [](vtkFuzzyCriticalPoints* f) { f->SetPersistenceThreshold(1.1); },
    [](vtkFuzzyCriticalPoints* f) { f->SetPersistenceThreshold(NaN); },
  };
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    SCOPED_TRACE(i);
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(tiltedTorus(500));
    settings[i](filter);
    expectRefusal(filter, { "needs", "found" });
  }
}

// After a refusal, a corrected filter works; after a success, a refusal leaves nothing of it.
TEST(FuzzyCriticalPointsRefusal, leavesNoTraces)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus());
  expectSilentSuccess(update(filter));
  filter->SetScheme(99);
  expectRefusal(filter, { "Scheme" });
  filter->SetScheme(2);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
}
