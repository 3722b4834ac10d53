// vtkLevelSetDistribution: what it writes for surfaces and volumes, and what it says.

#include "ApproximationTest.h"

#include "vtkLevelSetDistribution.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkContourFilter.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Geometry>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

using Distribution = vtkSmartPointer<vtkLevelSetDistribution>;

Distribution distribution(vtkDataObject* input)
{
  auto filter = Distribution::New();
  filter->SetInputDataObject(input);
  return filter;
}

std::vector<double> column(vtkLevelSetDistribution* filter, int port, const char* name)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
  return numbersOf(vtkDataArray::SafeDownCast(table->GetColumnByName(name)));
}

std::vector<double> field(vtkLevelSetDistribution* filter, const char* name)
{
  return ::numbersOf(filter->GetOutputDataObject(0)->GetFieldData()->GetArray(name));
}

std::vector<double> covered(vtkLevelSetDistribution* filter)
{
  return numbersOf(filter->GetOutput()->GetCellData()->GetArray("Covered"));
}

/// Area of a triangle, volume of a tetrahedron; 1 for the cells of images, which are all equal.
double sizeOf(vtkCell* cell)
{
  const auto place = [&](vtkIdType i)
  {
    Vector3d result;
    cell->GetPoints()->GetPoint(i, result.data());
    return result;
  };
  const auto side = [&](vtkIdType i) -> Vector3d { return place(i) - place(0); };
  switch (cell->GetCellType())
  {
    case VTK_TRIANGLE:
      return 0.5 * side(1).cross(side(2)).norm();
    case VTK_TETRA:
      return std::abs(side(1).cross(side(2)).dot(side(3))) / 6.0;
    default:
      return 1.0;
  }
}

/// The share of the area or volume of the cells that are covered.
double shareOfCovered(vtkLevelSetDistribution* filter)
{
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const auto is = covered(filter);
  double whole = 0.0;
  double share = 0.0;
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const double size = sizeOf(output->GetCell(cell));
    whole += size;
    share += is[static_cast<std::size_t>(cell)] * size;
  }
  return share / whole;
}

/// A square whose values are flat but for a strip in the middle, a quarter of it.
vtkSmartPointer<vtkPolyData> stepMesh()
{
  const auto mesh = squareMesh(33);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double x = mesh->GetPoint(i)[0];
    mesh->GetPointData()->GetScalars()->SetComponent(i, 0, std::clamp(x, 12.0, 20.0) + 0.3);
  }
  return mesh;
}

/// Marks the cells for which a condition on their corners holds.
template <class Condition>
void mark(vtkDataSet* input, unsigned char ghost, const Condition& isMarked)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    ghosts->InsertNextValue(isMarked(input->GetCell(cell)) ? ghost : 0);
  }
  input->GetCellData()->AddArray(ghosts);
}

void expectRefusal(vtkLevelSetDistribution* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Level Set Distribution", parts);
}

} // namespace

// The table, the field data and the cells say the same: the coverage is the share of the area, or
// volume, of the covered cells, and its last row is that of the optimal values.
TEST(LevelSetDistribution, figuresAgree)
{
  for (const vtkSmartPointer<vtkDataSet>& input : std::vector<vtkSmartPointer<vtkDataSet>>{
         noisyTorus(), torusMesh(torusHeight()), stepMesh(), tetrahedraOf(slopeImage(9, 9, 9)) })
  {
    const auto filter = distribution(input);
    EXPECT_TRUE(update(filter).succeeded);
    const auto counts = column(filter, 1, "IsoValueCount");
    const auto coverages = column(filter, 1, "Coverage");
    ASSERT_GT(counts.size(), 2U);
    ASSERT_EQ(coverages.size(), counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k)
    {
      EXPECT_EQ(counts[k], std::ldexp(1.0, static_cast<int>(k) + 1) - 1.0);
    }
    EXPECT_TRUE(std::is_sorted(coverages.begin(), coverages.end()));
    EXPECT_THAT(field(filter, "GlobalCoverage"), ElementsAre(coverages.back()));
    const auto optimal = field(filter, "OptimalIsoValues");
    EXPECT_EQ(static_cast<double>(optimal.size()), counts.back());
    EXPECT_TRUE(std::is_sorted(optimal.begin(), optimal.end()));
    EXPECT_NEAR(shareOfCovered(filter), coverages.back(), 1e-12);
    EXPECT_STREQ(filter->GetOutput()->GetClassName(), input->GetClassName());
    EXPECT_TRUE(vtkIntArray::SafeDownCast(filter->GetOutput()->GetCellData()->GetArray("Covered")));
  }
}

// Where f is flat nothing is covered: of the steps a quarter is not flat.
TEST(LevelSetDistribution, plateausAreNotCovered)
{
  const auto filter = distribution(stepMesh());
  update(filter);
  EXPECT_THAT(field(filter, "GlobalCoverage"), ElementsAre(0.25));
}

// A contour filter takes the optimal values as they are, and finds something at each.
TEST(LevelSetDistribution, optimalValuesAreForAContour)
{
  const auto filter = distribution(torusMesh(torusHeight()));
  filter->SetCoverageTolerance(0.02);
  expectSilentSuccess(update(filter));
  const auto optimal = field(filter, "OptimalIsoValues");
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(filter->GetOutput());
  for (std::size_t i = 0; i < optimal.size(); ++i)
  {
    contour->SetValue(static_cast<int>(i), optimal[i]);
  }
  contour->Update();
  auto values = ::numbersOf(contour->GetOutput()->GetPointData()->GetScalars());
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end(),
                 [](double a, double b) { return std::abs(a - b) < 1e-9; }),
    values.end());
  EXPECT_EQ(values.size(), optimal.size());
}

// A quad or strip is covered if one of its triangles is; vertices and lines never are.
TEST(LevelSetDistribution, cellsOfSeveralTriangles)
{
  Points points(3, 6);
  points << 0, 1, 2, 0, 1, 2, //
    0, 0, 0, 1, 1, 1,         //
    0, 0, 0, 0, 0, 0;
  Values values(6);
  values << 0.0, 0.0, 3.0, 0.0, 0.0, 0.0;
  const auto mesh = makeCloud(points, values);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 2, 5 });
  mesh->SetLines(lines);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 4, 3 });
  mesh->SetPolys(polygons);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 4, 1, 5, 2 });
  mesh->SetStrips(strips);
  const auto filter = distribution(mesh);
  expectWarning(update(filter), { "1 of 3 cells are vertices or lines" });
  EXPECT_THAT(covered(filter), ElementsAre(0, 0, 1));
  // The strip's triangle (1, 5, 2), a half of 2: (4, 1, 5) and the quad are flat.
  EXPECT_THAT(field(filter, "GlobalCoverage"), ElementsAre(0.25));
}

// The distortion of a plane is the distance between parallel lines, by both measures; intervals
// follow each other.
TEST(LevelSetDistribution, distortionOfAPlaneIsEven)
{
  const auto mesh = squareMesh(33);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPointData()->GetScalars()->SetComponent(i, 0, mesh->GetPoint(i)[0]);
  }
  for (const int measure :
    { vtkLevelSetDistribution::HAUSDORFF, vtkLevelSetDistribution::GEODESIC })
  {
    const auto filter = distribution(mesh);
    filter->SetMaximumIntervals(17);
    filter->SetDistanceMeasure(measure);
    expectSilentSuccess(update(filter));
    const auto from = column(filter, 2, "IsoValue");
    const auto to = column(filter, 2, "NextIsoValue");
    const auto distances = column(filter, 2, "Distortion");
    ASSERT_EQ(distances.size(), 14U);
    EXPECT_THAT(field(filter, "DistortionIntervals"), ElementsAre(14));
    EXPECT_THAT(field(filter, "LeftOutIntervals"), ElementsAre(0));
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      EXPECT_EQ(from[i], 2.0 * static_cast<double>(i + 1));
      EXPECT_EQ(to[i], from[i] + 2.0);
      EXPECT_NEAR(distances[i], 2.0, 1e-12);
    }
  }
}

// No interval of the table holds a critical value of enough persistence; those left out are
// counted, and rows are iso-values of the optimal list.
TEST(LevelSetDistribution, leavesCriticalValuesOut)
{
  const auto mesh = torusMesh(torusHeight() + 0.02 * noise(torusHeight().size()));
  std::size_t last = 0;
  for (const double threshold : { 0.0, 0.005, 0.1 })
  {
    const auto filter = distribution(mesh);
    filter->SetPersistenceThreshold(threshold);
    EXPECT_TRUE(update(filter).succeeded);
    vtkNew<vtkMeshCriticalPoints> critical;
    critical->SetInputData(mesh);
    critical->SetPersistenceThreshold(threshold);
    critical->Update();
    const auto values = numbersOf(pointArray(critical, "ScalarValue", 1));
    const auto from = column(filter, 2, "IsoValue");
    const auto to = column(filter, 2, "NextIsoValue");
    const auto optimal = field(filter, "OptimalIsoValues");
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      EXPECT_TRUE(std::none_of(values.begin(), values.end(),
        [&](double value) { return from[i] <= value && value <= to[i]; }));
      EXPECT_TRUE(std::binary_search(optimal.begin(), optimal.end(), from[i]));
      EXPECT_TRUE(std::binary_search(optimal.begin(), optimal.end(), to[i]));
    }
    EXPECT_EQ(field(filter, "DistortionIntervals")[0] - field(filter, "LeftOutIntervals")[0],
      static_cast<double>(from.size()));
    EXPECT_GE(from.size(), last);
    last = from.size();
  }
  EXPECT_GT(last, 10U);
}

// Noise alone leaves no interval without a critical value, which is said.
TEST(LevelSetDistribution, saysThatNothingIsLeft)
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
TEST(LevelSetDistribution, takesImagesAndVolumes)
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
TEST(LevelSetDistribution, refusesProperties)
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
TEST(LevelSetDistribution, constantsHaveNoIsoValues)
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
TEST(LevelSetDistribution, crowdedValuesAreNoticed)
{
  Values values = torusHeight();
  values[5] = 1e9;
  const auto filter = distribution(torusMesh(values));
  expectWarning(update(filter), { "not stationary at 1048575 iso-values" });
}

// Points without a value are left out with their triangles and counted.
TEST(LevelSetDistribution, leavesMissingValuesOut)
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
TEST(LevelSetDistribution, duplicatesDoNotCount)
{
  const auto mesh = stepMesh();
  const auto isLeft = [](vtkCell* cell)
  { return cell->GetBounds()[1] <= 12.0 || cell->GetBounds()[0] >= 20.0; };
  mark(mesh, vtkDataSetAttributes::DUPLICATECELL,
    [](vtkCell* cell) { return cell->GetBounds()[1] <= 12.0; });
  const auto filter = distribution(mesh);
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_NEAR(field(filter, "GlobalCoverage").front(), 0.4, 1e-12);

  // Nothing but what is not flat is a duplicate.
  mark(mesh, vtkDataSetAttributes::DUPLICATECELL, [&](vtkCell* cell) { return !isLeft(cell); });
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_NEAR(field(filter, "GlobalCoverage").front(), 0.0, 1e-12);
  const auto is = covered(filter);
  EXPECT_EQ(std::count(is.begin(), is.end(), 1), 0);

  mark(mesh, vtkDataSetAttributes::DUPLICATECELL, [](vtkCell*) { return true; });
  expectRefusal(filter, { "cells that are no duplicates" });
}

// Hidden cells are as those around points without a value, whatever the value is, but for the
// warning.
TEST(LevelSetDistribution, hiddenCellsAreNotThere)
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
    mark(vtkDataSet::SafeDownCast(hidden->GetInput()), vtkDataSetAttributes::HIDDENCELL,
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
TEST(LevelSetDistribution, refusesBadMeshes)
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

// The input's own array Covered is renamed; the input is not touched.
TEST(LevelSetDistribution, makesRoomForItsArrays)
{
  const auto first = distribution(torusMesh(torusHeight()));
  expectSilentSuccess(update(first));
  const auto again = distribution(first->GetOutput());
  expectWarning(update(again), { "'CoveredInput'" });
  EXPECT_TRUE(again->GetOutput()->GetCellData()->HasArray("CoveredInput"));
  EXPECT_FALSE(first->GetOutput()->GetCellData()->HasArray("CoveredInput"));
}

// Blocks are worked on one by one, whatever they are.
TEST(LevelSetDistribution, takesBlocks)
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
TEST(LevelSetDistribution, stops)
{
  const auto filter = distribution(noisyTorus());
  filter->SetPersistenceThreshold(1.0);
  expectNothingWhenStopped(filter, 0.0);
  expectNothingWhenStopped(filter, 0.5);
  expectSilentSuccess(update(filter));
}
