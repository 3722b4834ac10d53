// vtkLevelSetDistribution: what it takes, leaves out and refuses, and what it says.

#include "DistributionTest.h"
#include "GhostTest.h"

#include "vtkMultiBlockDataSet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

// Noise alone leaves no interval without a critical value, which is said.
TEST(LevelSetDistributionInput, saysThatNothingIsLeft)
{
  const auto filter = distribution(noisyTorus());
  filter->SetMaximumIntervals(16);
  expectWarning(update(filter), { "All 14 intervals", "Raise PersistenceThreshold" });
  EXPECT_TRUE(column(filter, 2, "Distortion").empty());
  filter->SetPersistenceThreshold(1.0);
  expectSilentSuccess(update(filter));
  EXPECT_GT(column(filter, 2, "Distortion").size(), 4U);
}

// Images, flat and not, and their tetrahedra: the voxels of an image are covered if one of their
// tetrahedra is, so that its share is not less.
TEST(LevelSetDistributionInput, takesImagesAndVolumes)
{
  const auto flat = distribution(slopeImage(20, 20, 1));
  flat->SetDistanceMeasure(vtkLevelSetDistribution::GEODESIC);
  expectSilentSuccess(update(flat));
  EXPECT_GT(column(flat, 2, "Distortion").size(), 4U);
  EXPECT_GE(shareOfCovered(flat), field(flat, "GlobalCoverage")[0]);

  const auto image = distribution(slopeImage(10, 10, 10));
  image->SetCoverageTolerance(0.05);
  expectSilentSuccess(update(image));
  EXPECT_GE(shareOfCovered(image), field(image, "GlobalCoverage")[0]);
  EXPECT_STREQ(image->GetOutput()->GetClassName(), "vtkImageData");
  const auto distances = column(image, 2, "Distortion");
  EXPECT_GT(distances.size(), 4U);
  EXPECT_TRUE(std::all_of(distances.begin(), distances.end(),
    [](double distance) { return distance > 0.0 && distance < 2.0; }));
}

// A tolerance of 0 and other properties that mean nothing are refused, as is what is not offered.
TEST(LevelSetDistributionInput, refusesProperties)
{
  const auto filter = distribution(torusMesh(torusHeight()));
  filter->SetCoverageTolerance(0.0);
  expectRefusal(filter, { "CoverageTolerance above 0 and below 1, found 0" });
  filter->SetCoverageTolerance(1e-4);
  filter->SetPersistenceThreshold(-0.1);
  expectRefusal(filter, { "PersistenceThreshold from 0 to 1" });
  filter->SetPersistenceThreshold(0.0);
  filter->SetDistanceMeasure(2);
  expectRefusal(filter, { "0 (Hausdorff) or 1 (Geodesic)" });
  filter->SetDistanceMeasure(1);
  filter->SetMaximumIntervals(3);
  expectRefusal(filter, { "MaximumIntervals of 4 or more, or 0, found 3" });
  filter->SetMaximumIntervals(0);
  expectSilentSuccess(update(filter));
  filter->SetInputDataObject(slopeImage(5, 5, 5));
  expectRefusal(filter, { "Hausdorff for a volume" });
}

// A constant is covered by nothing, which is said.
TEST(LevelSetDistributionInput, constantsHaveNoIsoValues)
{
  const auto filter = distribution(torusMesh(Values::Constant(1152, 4.0)));
  expectWarning(update(filter), { "constant", "no iso-values" });
  EXPECT_THAT(field(filter, "GlobalCoverage"), ElementsAre(0.0));
  EXPECT_TRUE(field(filter, "OptimalIsoValues").empty());
  EXPECT_TRUE(column(filter, 1, "Coverage").empty());
  EXPECT_TRUE(column(filter, 2, "Distortion").empty());
  const auto is = covered(filter);
  EXPECT_EQ(std::count(is.begin(), is.end(), 0), static_cast<long>(is.size()));
}

// One value that is far off crowds the others, which is said, too.
TEST(LevelSetDistributionInput, crowdedValuesAreNoticed)
{
  Values values = torusHeight();
  values[5] = 1e9;
  const auto filter = distribution(torusMesh(values));
  expectWarning(update(filter), { "not stationary at 1048575 iso-values" });
}

// Points without a value are left out with their triangles and counted.
TEST(LevelSetDistributionInput, leavesMissingValuesOut)
{
  Values values = torusHeight();
  values[100] = NaN;
  const auto filter = distribution(torusMesh(values));
  expectWarning(update(filter), { "Left out 1 of 1152 points", "6 of 2304 triangles" });
  const auto is = covered(filter);
  EXPECT_GE(std::count(is.begin(), is.end(), 0), 6);
  EXPECT_GT(field(filter, "GlobalCoverage")[0], 0.99);
}

// Duplicates count in another piece, not here: of what is left of the steps, 20 columns, 8 are not
// flat. Nor are they covered.
TEST(LevelSetDistributionInput, duplicatesDoNotCount)
{
  const auto mesh = stepMesh();
  const auto isLeft = [](vtkCell* cell)
  { return cell->GetBounds()[1] <= 12.0 || cell->GetBounds()[0] >= 20.0; };
  markCells(mesh, vtkDataSetAttributes::DUPLICATECELL,
    [](vtkCell* cell) { return cell->GetBounds()[1] <= 12.0; });
  const auto filter = distribution(mesh);
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_NEAR(field(filter, "GlobalCoverage").front(), 0.4, 1e-12);

  // Nothing but what is not flat is a duplicate.
  markCells(
    mesh, vtkDataSetAttributes::DUPLICATECELL, [&](vtkCell* cell) { return !isLeft(cell); });
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_NEAR(field(filter, "GlobalCoverage").front(), 0.0, 1e-12);
  const auto is = covered(filter);
  EXPECT_EQ(std::count(is.begin(), is.end(), 1), 0);

  markCells(mesh, vtkDataSetAttributes::DUPLICATECELL, [](vtkCell*) { return true; });
  expectRefusal(filter, { "cells that are no duplicates" });
}

// Hidden cells are as those around points without a value, whatever the value is, but for the
// warning.
TEST(LevelSetDistributionInput, hiddenCellsAreNotThere)
{
  for (const vtkSmartPointer<vtkDataSet>& input :
    std::vector<vtkSmartPointer<vtkDataSet>>{ torusMesh(torusHeight()), slopeImage(20, 20, 1),
      slopeImage(8, 8, 8), tetrahedraOf(slopeImage(7, 7, 7)) })
  {
    const auto isOut = [&](vtkIdType point) { return input->GetPoint(point)[0] > 0.5; };
    const auto withValue = [&](double value)
    {
      const auto copy = vtkSmartPointer<vtkDataSet>::Take(input->NewInstance());
      copy->DeepCopy(input);
      for (vtkIdType point = 0; point < copy->GetNumberOfPoints(); ++point)
      {
        if (isOut(point))
        {
          copy->GetPointData()->GetScalars()->SetComponent(point, 0, value);
        }
      }
      return distribution(copy);
    };
    const auto missing = withValue(NaN);
    EXPECT_TRUE(update(missing).succeeded);
    const auto hidden = withValue(1e9);
    markCells(vtkDataSet::SafeDownCast(hidden->GetInput()), vtkDataSetAttributes::HIDDENCELL,
      [&](vtkCell* cell)
      {
        const auto* ids = cell->GetPointIds()->GetPointer(0);
        return std::any_of(ids, ids + cell->GetNumberOfPoints(), isOut);
      });
    expectSilentSuccess(update(hidden));
    EXPECT_GT(column(hidden, 2, "Distortion").size(), 4U);
    EXPECT_EQ(column(hidden, 1, "Coverage"), column(missing, 1, "Coverage"));
    EXPECT_EQ(column(hidden, 2, "Distortion"), column(missing, 2, "Distortion"));
    EXPECT_EQ(field(hidden, "OptimalIsoValues"), field(missing, "OptimalIsoValues"));
    EXPECT_EQ(covered(hidden), covered(missing));
  }
}

// What is no surface is refused, and points are referred to the filters for them.
TEST(LevelSetDistributionInput, refusesBadMeshes)
{
  const auto mesh = squareMesh(4);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 5 });
  cells->InsertNextCell({ 0, 1, 4 });
  cells->InsertNextCell({ 0, 1, 8 });
  mesh->SetPolys(cells);
  expectRefusal(distribution(mesh), { "at most 2 triangles at each edge" });
  expectRefusal(distribution(makeCloud(TorusGrid::points(), torusHeight())), { "needs a mesh" });
  expectRefusal(distribution(vtkSmartPointer<vtkPolyData>::New()), { "found no points" });
}

// Blocks are worked on one by one, whatever they are.
TEST(LevelSetDistributionInput, takesBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, torusMesh(torusHeight()));
  blocks->SetBlock(1, slopeImage(6, 6, 6));
  const auto filter = distribution(blocks);
  expectSilentSuccess(update(filter));
  for (const int port : { 0, 1, 2 })
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    ASSERT_TRUE(output);
    ASSERT_EQ(output->GetNumberOfBlocks(), 2U);
    for (const unsigned block : { 0U, 1U })
    {
      EXPECT_STREQ(output->GetBlock(block)->GetClassName(),
        port > 0 ? "vtkTable" : blocks->GetBlock(block)->GetClassName());
    }
  }
}

// A user who gives up gets nothing.
TEST(LevelSetDistributionInput, stops)
{
  const auto filter = distribution(noisyTorus());
  filter->SetPersistenceThreshold(1.0);
  expectNothingWhenStopped(filter, 0.0);
  expectNothingWhenStopped(filter, 0.5);
  expectSilentSuccess(update(filter));
}
