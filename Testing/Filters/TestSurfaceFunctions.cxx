// The functions of vtkPointSetScalarFunction that live on the surface: their values, on points and
// on meshes. How accurate they are is tested in Testing/Core.

#include "SurfaceFunctionTest.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

using Filter = vtkPointSetScalarFunction;

/// Gives the border of the grid the values of x - 2 y.
void constrainBorder(Filter* filter, vtkPolyData* grid)
{
  for (vtkIdType id = 0; id < grid->GetNumberOfPoints(); ++id)
  {
    const vtkIdType row = id / Side;
    const vtkIdType column = id % Side;
    if (row == 0 || row == Side - 1 || column == 0 || column == Side - 1)
    {
      const Vector3d p(grid->GetPoint(id));
      const int next = filter->GetNumberOfConstraintIds();
      filter->SetConstraintIds(next, id);
      filter->SetConstraintValues(next, p.x() - 2.0 * p.y());
    }
  }
}

double eigenvalueOf(Filter* filter)
{
  return filter->GetOutput()->GetFieldData()->GetArray("Eigenvalue")->GetTuple1(0);
}

} // namespace

TEST(SurfaceFunction, hasTheDefaultsOfTheInterface)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetSourceType(), 0);
  EXPECT_EQ(filter->GetNumberOfSourceIds(), 0);
  EXPECT_EQ(filter->GetNumberOfConstraintIds(), 0);
  EXPECT_EQ(filter->GetNumberOfConstraintValues(), 0);
  EXPECT_EQ(filter->GetEigenIndex(), 1);
  EXPECT_EQ(filter->GetDiffusionTime(), 0.0);
  EXPECT_EQ(filter->GetWeights(), 2);
  EXPECT_EQ(filter->GetNeighborCount(), 0);
  EXPECT_EQ(filter->GetSearchRadius(), 0.0);
  EXPECT_EQ(filter->GetKernelWidth(), 0.0);
}

TEST(SurfaceFunction, keepsItsListsAsVTKDoes)
{
  vtkNew<Filter> filter;
  filter->SetConstraintIds(1, 7);
  EXPECT_EQ(filter->GetNumberOfConstraintIds(), 2);
  EXPECT_EQ(filter->GetConstraintIds(0), 0);
  EXPECT_EQ(filter->GetConstraintIds(1), 7);
  filter->SetNumberOfConstraintIds(0);
  EXPECT_EQ(filter->GetNumberOfConstraintIds(), 0);
  const vtkMTimeType before = filter->GetMTime();
  filter->SetNumberOfSourceIds(0);
  EXPECT_EQ(filter->GetMTime(), before);
  filter->SetSourceIds(0, 3);
  EXPECT_GT(filter->GetMTime(), before);
}

// On a sphere the way between two points is the arc.
TEST(SurfaceFunction, measuresAlongTheSurface)
{
  const Points points = Truth::randomSphere(5000, 1);
  const auto filter = functionOn(makeCloud(points), Filter::GEODESIC);
  setSources(filter, { 17 });
  const Values distance = silentResultOf(filter);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Geodesic");
  EXPECT_EQ(distance[17], 0.0);
  double error = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    const double arc = std::acos(std::min(1.0, points.col(i).dot(points.col(17))));
    error += std::abs(distance[i] - arc) / points.cols();
  }
  EXPECT_LT(error, 0.03 * 0.5 * Pi);
}

// The distance from several sources is that from the nearest.
TEST(SurfaceFunction, measuresFromTheNearestSource)
{
  const auto filter = functionOn(makeCloud(Truth::randomSphere(1000, 1)), Filter::GEODESIC);
  setSources(filter, { 3 });
  const Values first = silentResultOf(filter);
  setSources(filter, { 8 });
  const Values second = silentResultOf(filter);
  setSources(filter, { 3, 8, 3 });
  const Values both = silentResultOf(filter);
  EXPECT_LT((both - first.cwiseMin(second)).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_EQ(both[3], 0.0);
  EXPECT_EQ(both[8], 0.0);
}

// Between its constraints, which it keeps, with no larger or smaller value elsewhere.
TEST(SurfaceFunction, isHarmonicBetweenItsConstraints)
{
  const Points points = Truth::randomSphere(2000, 1);
  const auto filter = functionOn(makeCloud(points), Filter::HARMONIC);
  setConstraints(filter, { 5, 900, 70 }, { -1.0, 3.0, 0.5 });
  for (const int weights : { 0, 1, 2 })
  {
    SCOPED_TRACE(weights);
    filter->SetWeights(weights);
    const Values values = silentResultOf(filter);
    EXPECT_NEAR(values[5], -1.0, 1e-9);
    EXPECT_NEAR(values[900], 3.0, 1e-9);
    EXPECT_NEAR(values[70], 0.5, 1e-9);
    EXPECT_GE(values.minCoeff(), -1.0 - 1e-9);
    EXPECT_LE(values.maxCoeff(), 3.0 + 1e-9);
  }
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "Harmonic");
}

// With the weights of a mesh a linear function is harmonic in the plane, whatever the cells are.
TEST(SurfaceFunction, isLinearOnAFlatMesh)
{
  for (const int corners : { 3, 4, 2 * Side })
  {
    for (const int weights : { 3, 4, 5 })
    {
      SCOPED_TRACE(::testing::Message() << corners << " corners, weights " << weights);
      const auto mesh = meshedGrid(corners);
      const auto filter = functionOn(mesh, Filter::HARMONIC);
      filter->SetWeights(weights);
      constrainBorder(filter, mesh);
      const Values values = silentResultOf(filter);
      ASSERT_EQ(values.size(), Side * Side);
      double error = 0.0;
      for (Eigen::Index i = 0; i < values.size(); ++i)
      {
        const Vector3d p(mesh->GetPoint(i));
        error = std::max(error, std::abs(values[i] - (p.x() - 2.0 * p.y())));
      }
      EXPECT_LT(error, 1e-7);
      EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), mesh->GetNumberOfCells());
    }
  }
}

// The sphere's eigenvalues are l (l + 1): 0, then three times 2. The first function is constant.
TEST(SurfaceFunction, isAnEigenfunction)
{
  const auto filter =
    functionOn(makeCloud(Truth::randomSphere(3000, 1)), Filter::LAPLACIAN_EIGENFUNCTION);
  filter->SetEigenIndex(0);
  const Values constant = silentResultOf(filter);
  EXPECT_NEAR(eigenvalueOf(filter), 0.0, 1e-6);
  EXPECT_NEAR(constant.maxCoeff(), constant.minCoeff(), 1e-6);
  filter->SetEigenIndex(3);
  const Values wave = silentResultOf(filter);
  EXPECT_NEAR(eigenvalueOf(filter), 2.0, 0.3);
  EXPECT_LT(std::abs(wave.mean()), 0.1 * wave.cwiseAbs().maxCoeff());
  EXPECT_STREQ(
    filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "LaplacianEigenfunction");
}

// One filter after the other: the earlier eigenvalue is kept under another name.
TEST(SurfaceFunction, renamesAnEigenvalueOfTheInput)
{
  const auto cloud = makeCloud(Truth::randomSphere(300, 1));
  vtkNew<vtkDoubleArray> earlier;
  earlier->SetName("Eigenvalue");
  earlier->InsertNextValue(7.0);
  cloud->GetFieldData()->AddArray(earlier);
  const auto filter = functionOn(cloud, Filter::LAPLACIAN_EIGENFUNCTION);
  expectWarning(update(filter), { "'Eigenvalue'", "'EigenvalueInput'" });
  EXPECT_NE(eigenvalueOf(filter), 7.0);
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("EigenvalueInput")->GetTuple1(0), 7.0);
  EXPECT_FALSE(cloud->GetFieldData()->HasArray("EigenvalueInput"));
}

// Heat leaves its source in time and stays where no way leads out.
TEST(SurfaceFunction, spreadsHeat)
{
  const auto cloud = makeCloud(twoSpheres());
  const auto filter = functionOn(cloud, Filter::DIFFUSION);
  setSources(filter, { 10 });
  double hottest = std::numeric_limits<double>::infinity();
  for (const double time : { 0.05, 0.2, 1.0 })
  {
    filter->SetDiffusionTime(time);
    const Values heat = silentResultOf(filter);
    EXPECT_GT(heat[10], 0.0);
    EXPECT_LT(heat[10], hottest);
    hottest = heat[10];
    EXPECT_NEAR(heat.tail(500).cwiseAbs().maxCoeff(), 0.0, 1e-12);
  }
  // After long, the unit of heat is the same everywhere: one by the area of the sphere.
  filter->SetDiffusionTime(100.0);
  const Values even = silentResultOf(filter).head(500);
  EXPECT_NEAR(even.maxCoeff(), 1.0 / (4.0 * Pi), 0.2 / (4.0 * Pi));
  EXPECT_NEAR(even.minCoeff(), even.maxCoeff(), 1e-3);
}

// The time that 0 stands for.
TEST(SurfaceFunction, spreadsHeatByATenthOfTheDiagonal)
{
  const Points points = Truth::squareGrid(Side, 0.05);
  const auto filter = functionOn(makeCloud(points), Filter::DIFFUSION);
  setSources(filter, { 0, 200 });
  const Values automatic = silentResultOf(filter);
  filter->SetDiffusionTime(0.01 * 2.0);
  EXPECT_TRUE(automatic.isApprox(silentResultOf(filter), 1e-9));
}

// Without areas there is no length to take it from.
TEST(SurfaceFunction, needsATimeWithoutUnit)
{
  const auto filter = functionOn(meshedGrid(3), Filter::DIFFUSION);
  setSources(filter, { 0 });
  filter->SetWeights(Filter::NORMALIZED_COTANGENT);
  expectFunctionRefusal(
    filter, { "needs a DiffusionTime above 0 for NormalizedCotangent, found 0." });
  filter->SetDiffusionTime(10.0);
  EXPECT_GT(silentResultOf(filter)[0], 0.0);
}

TEST(SurfaceFunction, isTheSameForEveryNumberOfThreads)
{
  const auto cloud = makeCloud(Truth::randomTorus(5000, Truth::Torus::Closed, 1));
  for (const int function : { 3, 4, 5, 6 })
  {
    SCOPED_TRACE(function);
    std::vector<Values> results;
    for (const int threads : { 1, 2 })
    {
      vtkSMPTools::Initialize(threads);
      const auto filter = functionOn(cloud, function);
      setSources(filter, { 1, 2 });
      setConstraints(filter, { 1, 2 }, { 1.0, 2.0 });
      results.push_back(silentResultOf(filter));
    }
    vtkSMPTools::Initialize(0);
    EXPECT_TRUE(results[0] == results[1]);
  }
}

// Stopped anywhere, it leaves nothing and says nothing; run again, it does its work.
TEST(SurfaceFunction, leavesNothingWhenStopped)
{
  const auto cloud = makeCloud(Truth::randomTorus(50000, Truth::Torus::Closed, 1));
  for (const int function : { 3, 4, 5, 6 })
  {
    for (const double fraction : { 0.02, 0.15, 0.4 })
    {
      SCOPED_TRACE(::testing::Message() << "function " << function << " at " << fraction);
      const auto filter = functionOn(cloud, function);
      setSources(filter, { 1, 2 });
      setConstraints(filter, { 1, 2 }, { 1.0, 2.0 });
      expectNothingWhenStopped(filter, fraction);
    }
  }
}

TEST(SurfaceFunction, isPrinted)
{
  vtkNew<Filter> filter;
  setSources(filter, { 4, 5 });
  std::ostringstream text;
  filter->Print(text);
  EXPECT_THAT(text.str(), ::testing::HasSubstr("SourceIds: 4 5"));
  EXPECT_THAT(text.str(), ::testing::HasSubstr("EigenIndex: 1"));
}
