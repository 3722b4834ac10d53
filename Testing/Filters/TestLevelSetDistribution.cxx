// vtkLevelSetDistribution: what it writes for surfaces and volumes.

#include "DistributionTest.h"

#include "vtkContourFilter.h"
#include "vtkIntArray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

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
  auto values = numbersOf(contour->GetOutput()->GetPointData()->GetScalars());
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
