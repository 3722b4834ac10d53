// The functions on surfaces of vtkPointSetScalarFunction on points and meshes of all kinds.

#include "SurfaceFunctionTest.h"

#include "vtkDoubleArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

using Filter = vtkPointSetScalarFunction;

} // namespace

// Points at one place have one value.
TEST(SurfaceFunctionInput, isTheSameAtDuplicates)
{
  const Points once = Truth::randomSphere(400, 1);
  Points points(3, 800);
  points << once, once;
  const auto cloud = makeCloud(points);
  for (const int function : { 3, 4, 5, 6 })
  {
    SCOPED_TRACE(function);
    const auto filter = functionOn(cloud, function);
    setSources(filter, { 7 });
    setConstraints(filter, { 7, 430, 30 }, { 1.0, 2.0, 2.0 }); // 430 and 30 are one place
    const Values values = silentResultOf(filter);
    ASSERT_EQ(values.size(), 800);
    EXPECT_TRUE(values.head(400) == values.tail(400));
    EXPECT_TRUE(values.allFinite());
  }
}

// Points that are nowhere have no value; the others have that of the others alone.
TEST(SurfaceFunctionInput, leavesMissingPointsOut)
{
  const Points clean = Truth::randomSphere(400, 1);
  Points points(3, 402);
  points << clean.leftCols(100), Vector3d(NaN, 0.0, 0.0), clean.rightCols(300),
    Vector3d(0.0, 1.0, std::numeric_limits<double>::infinity());
  for (const int function : { 3, 4, 5, 6 })
  {
    SCOPED_TRACE(function);
    const auto filter = functionOn(makeCloud(points), function);
    setSources(filter, { 200 });
    setConstraints(filter, { 200, 3 }, { 1.0, 2.0 });
    expectWarning(update(filter), { "2 of 402 points have a NaN or infinite coordinate" });
    const Values values = resultOf(filter);
    const auto reference = functionOn(makeCloud(clean), function);
    setSources(reference, { 199 });
    setConstraints(reference, { 199, 3 }, { 1.0, 2.0 });
    const Values expected = silentResultOf(reference);
    EXPECT_TRUE(std::isnan(values[100]) && std::isnan(values[401]));
    EXPECT_TRUE(values.head(100) == expected.head(100));
    EXPECT_TRUE(values.segment(101, 300) == expected.tail(300));
  }
}

TEST(SurfaceFunctionInput, leavesPointsWithoutTrianglesOut)
{
  const auto mesh = meshedGrid(3);
  mesh->GetPoints()->InsertNextPoint(5.0, 5.0, 5.0);
  const auto filter = functionOn(mesh, Filter::HARMONIC);
  filter->SetWeights(Filter::COTANGENT);
  setConstraints(filter, { 0, 100 }, { 0.0, 1.0 });
  expectWarning(update(filter), { "1 of 442 points are in no triangle and get NaN." });
  const Values values = resultOf(filter);
  EXPECT_TRUE(std::isnan(values[441]));
  EXPECT_TRUE(values.head(441).allFinite());
  setConstraints(filter, { 0, 441 }, { 0.0, 1.0 });
  expectFunctionRefusal(filter, { "point 441, which is in no triangle." });
}

TEST(SurfaceFunctionInput, countsWhatCannotBeReached)
{
  const auto filter = functionOn(makeCloud(twoSpheres()), Filter::GEODESIC);
  setSources(filter, { 499 });
  expectWarning(update(filter), { "500 of 1000 points cannot be reached from the sources" });
  const Values values = resultOf(filter);
  EXPECT_TRUE(values.head(500).allFinite());
  EXPECT_TRUE(values.tail(500).array().isNaN().all());
}

// Ids count through the blocks.
TEST(SurfaceFunctionInput, countsThroughBlocks)
{
  const Points points = Truth::randomSphere(600, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(Points(points.leftCols(200))));
  blocks->SetBlock(1, nullptr);
  blocks->SetBlock(2, makeCloud(Points(points.rightCols(400))));
  for (const int function : { 3, 4, 6 })
  {
    SCOPED_TRACE(function);
    const auto merged = functionOn(blocks, function);
    const auto whole = functionOn(makeCloud(points), function);
    for (Filter* filter : { merged.Get(), whole.Get() })
    {
      setSources(filter, { 350 });
      setConstraints(filter, { 350, 10 }, { 1.0, 2.0 });
    }
    EXPECT_TRUE(silentResultOf(merged) == silentResultOf(whole));
  }
}

TEST(SurfaceFunctionInput, readsOtherPointSets)
{
  const auto cloud = makeCloud(Truth::randomSphere(300, 1));
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cloud->GetPoints());
  const auto filter = functionOn(grid, Filter::GEODESIC);
  setSources(filter, { 0 });
  const Values values = silentResultOf(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfVerts(), 300);
  const auto reference = functionOn(cloud, Filter::GEODESIC);
  setSources(reference, { 0 });
  EXPECT_TRUE(values == silentResultOf(reference));
}

// A radius or another number of neighbors gives another graph.
TEST(SurfaceFunctionInput, choosesNeighbors)
{
  const auto filter = functionOn(makeCloud(Truth::squareGrid(Side, 0.05)), Filter::GEODESIC);
  setSources(filter, { 0 });
  const Values usual = silentResultOf(filter);
  filter->SetNeighborCount(16);
  EXPECT_TRUE(usual == silentResultOf(filter));
  filter->SetNeighborCount(8);
  EXPECT_FALSE(usual == silentResultOf(filter));
  filter->SetSearchRadius(0.2);
  EXPECT_FALSE(usual == silentResultOf(filter));
  filter->SetSearchRadius(0.01);
  expectWarning(update(filter), { "440 of 441 points cannot be reached" });
}
