// What mesh filters can work on, what they say about it and what they refuse: by
// vtkMeshCriticalPoints.

#include "MeshTest.h"

#include "vtkConstrainedSmoothing.h"
#include "vtkMeshCriticalPoints.h"
#include "vtkMorseComplex.h"

#include "vtkCellArrayIterator.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace
{

vtkSmartPointer<vtkMeshCriticalPoints> critical(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  filter->SetInputDataObject(input);
  return filter;
}

void expectRefusal(vtkDataObject* input, std::initializer_list<const char*> parts)
{
  const auto filter = critical(input);
  expectFailure(filter, update(filter), "Mesh Critical Points", parts);
}

std::vector<double> typesOf(vtkPolyDataAlgorithm* filter)
{
  return numbersOf(pointArray(filter, "CriticalType"));
}

/// As many points as `mesh` has and one more, which no cell uses.
vtkIdType addPoint(vtkPolyData* mesh, double x, double y, double value)
{
  auto* values = vtkDoubleArray::SafeDownCast(mesh->GetPointData()->GetScalars());
  values->InsertNextValue(value);
  return mesh->GetPoints()->InsertNextPoint(x, y, 0.0);
}

void setValue(vtkPolyData* mesh, vtkIdType point, double value)
{
  mesh->GetPointData()->GetScalars()->SetComponent(point, 0, value);
}

} // namespace

// Quads, as Triangulate cuts them up, and strips are the same mesh as their triangles.
TEST(MeshInput, takesQuadsAndStrips)
{
  const GridCorners corner{ TorusGrid::Columns, TorusGrid::Rows };
  const auto quads = noisyTorus();
  const auto strips = noisyTorus();
  vtkNew<vtkCellArray> quadCells;
  vtkNew<vtkCellArray> stripCells;
  for (int j = 0; j < TorusGrid::Rows; ++j)
  {
    stripCells->InsertNextCell(2 * TorusGrid::Columns + 2);
    for (int i = 0; i <= TorusGrid::Columns; ++i)
    {
      stripCells->InsertCellPoint(corner(i, j + 1));
      stripCells->InsertCellPoint(corner(i, j));
      if (i < TorusGrid::Columns)
      {
        quadCells->InsertNextCell(
          { corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1) });
      }
    }
  }
  quads->SetPolys(quadCells);
  strips->SetPolys(nullptr);
  strips->SetStrips(stripCells);
  for (vtkPolyData* mesh : { quads.Get(), strips.Get() })
  {
    vtkNew<vtkTriangleFilter> triangulate;
    triangulate->SetInputData(mesh);
    triangulate->Update();
    const auto ofTriangles = critical(triangulate->GetOutput());
    const auto ofCells = critical(mesh);
    expectSilentSuccess(update(ofTriangles));
    expectSilentSuccess(update(ofCells));
    EXPECT_EQ(typesOf(ofCells), typesOf(ofTriangles));
    EXPECT_EQ(ofCells->GetOutput()->GetNumberOfCells(), mesh->GetNumberOfCells());
  }
}

// A quad without area joins its neighbors as any other: the torus remains closed.
TEST(MeshInput, takesCellsWithoutArea)
{
  const auto mesh = torusMesh(torusHeight());
  for (vtkIdType i = 0; i < TorusGrid::Columns; ++i)
  {
    mesh->GetPoints()->SetPoint(i, mesh->GetPoint(i + TorusGrid::Columns));
  }
  const auto filter = critical(mesh);
  expectSilentSuccess(update(filter));
  EXPECT_THAT(fieldData(filter, "EulerCharacteristic"), ElementsAre(0));

  vtkNew<vtkCellArray> quad;
  quad->InsertNextCell({ 0, 1, 2, 3 });
  const auto flat = makeCloud(Points::Zero(3, 4), Values::LinSpaced(4, 0.0, 1.0));
  flat->SetPolys(quad);
  const auto ofFlat = critical(flat);
  EXPECT_TRUE(update(ofFlat).succeeded);
  EXPECT_THAT(fieldData(ofFlat, "EulerCharacteristic"), ElementsAre(1));
}

// Values of any type are read.
TEST(MeshInput, takesValuesOfAnyType)
{
  const auto mesh = torusMesh(torusHeight());
  addArray<vtkIntArray>(mesh, "rounded", (1000.0 * torusHeight()).array().round());
  const auto filter = critical(mesh);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "rounded");
  expectSilentSuccess(update(filter));
  EXPECT_THAT(fieldData(filter, "EulerCharacteristic"), ElementsAre(0));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "rounded");
}

// Lines and vertices take no part; they pass through.
TEST(MeshInput, ignoresLinesAndVertices)
{
  const auto mesh = torusMesh(torusHeight());
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 200, 400 });
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 1 });
  vertices->InsertNextCell({ 2 });
  mesh->SetLines(lines);
  mesh->SetVerts(vertices);
  const auto filter = critical(mesh);
  expectWarning(update(filter), { "3 of 2307 cells are vertices or lines and ignored" });
  EXPECT_THAT(fieldData(filter, "CriticalCounts"), ElementsAre(1, 2, 1));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 1);
}

// Points in no triangle are of no type; ids are those of the input.
TEST(MeshInput, excludesPointsWithoutTriangles)
{
  const auto whole = critical(squareMesh());
  const auto mesh = squareMesh();
  addPoint(mesh, 9.0, 9.0, 100.0);
  const auto filter = critical(mesh);
  expectSilentSuccess(update(whole));
  expectWarning(update(filter), { "1 of 65 points are in no triangle" });
  auto expected = typesOf(whole);
  expected.push_back(-1.0);
  EXPECT_EQ(typesOf(filter), expected);
}

// A triangle with the same corner twice is an edge of its neighbors.
TEST(MeshInput, dropsTrianglesWithARepeatedCorner)
{
  const auto mesh = torusMesh(torusHeight());
  mesh->GetPolys()->InsertNextCell({ 0, 1, 1 });
  const auto filter = critical(mesh);
  expectWarning(update(filter), { "1 of 2305 triangles have the same corner twice" });
  EXPECT_THAT(fieldData(filter, "CriticalCounts"), ElementsAre(1, 2, 1));
}

// A sample without a value is a hole of the mesh.
TEST(MeshInput, cutsHolesAtMissingValues)
{
  const auto mesh = torusMesh(torusHeight());
  setValue(mesh, 500, NaN);
  setValue(mesh, 700, std::numeric_limits<double>::infinity());
  const auto filter = critical(mesh);
  expectWarning(update(filter),
    { "Left out 2 of 1152 points whose position or value is NaN or infinite, with 12 of 2304 "
      "triangles" });
  EXPECT_EQ(typesOf(filter)[500], -1.0);
  EXPECT_EQ(typesOf(filter)[700], -1.0);
  EXPECT_THAT(fieldData(filter, "EulerCharacteristic"), ElementsAre(-2));
}

// The same for a place that is not finite.
TEST(MeshInput, cutsHolesAtMissingPlaces)
{
  const auto mesh = torusMesh(torusHeight());
  mesh->GetPoints()->SetPoint(500, 0.0, NaN, 0.0);
  const auto filter = critical(mesh);
  expectWarning(update(filter), { "Left out 1 of 1152 points", "6 of 2304 triangles" });
  EXPECT_EQ(typesOf(filter)[500], -1.0);
}

// However many values are missing, what is left is a manifold: for noise in a fifth of the points
// Euler's formula holds, boundary vertices counted half.
TEST(MeshInput, leavesAManifoldBetweenHoles)
{
  const auto mesh = noisyTorus();
  const Values missing = noise(mesh->GetNumberOfPoints(), 7);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (missing(i) < 0.2)
    {
      setValue(mesh, i, NaN);
    }
  }
  const auto filter = critical(mesh);
  const Outcome outcome = update(filter);
  expectWarning(outcome, { "Left out ", "are in no triangle" });
  const auto types = typesOf(filter);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    if (missing(i) < 0.2)
    {
      EXPECT_EQ(types[static_cast<std::size_t>(i)], -1.0);
    }
  }
}

// Where a seam tears the mesh, a warning says so, and what joins it; the mesh is taken as it is.
TEST(MeshInput, saysWhereTheMeshIsTorn)
{
  const auto mesh = squareMesh();
  vtkNew<vtkCellArray> cells;
  const vtkIdType seam = 64; // the points of column 4 once more, for the cells on its right
  for (int row = 0; row < 8; ++row)
  {
    addPoint(mesh, 4.0, row, 4.0 + 0.1 * row + (row == 2 ? 0.5 : 0.0));
  }
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  vtkNew<vtkIdList> corners;
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    cell->GetCurrentCell(corners);
    const bool onTheRight = corners->GetId(0) % 8 >= 4;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      if (onTheRight && corners->GetId(i) % 8 == 4)
      {
        corners->SetId(i, seam + corners->GetId(i) / 8);
      }
    }
    cells->InsertNextCell(corners);
  }
  mesh->SetPolys(cells);
  const auto filter = critical(mesh);
  expectWarning(update(filter),
    { "8 of 42 vertices on the boundary are at the place of another", "apply Clean first",
      "differ at 1 of them" });
  EXPECT_THAT(fieldData(filter, "EulerCharacteristic"), ElementsAre(2));
}

// What is no mesh is refused, and what to use instead is named.
TEST(MeshInput, refusesPoints)
{
  const auto cloud = makeCloud(TorusGrid::points(), torusHeight());
  expectRefusal(cloud, { "no triangle among 0 cells", "Fuzzy Critical Points", "Extract Surface" });
  vtkNew<vtkPolyData> nothing;
  expectRefusal(nothing, { "no triangle among 0 cells" });
}

// An edge of three triangles is named by a point of the input.
TEST(MeshInput, refusesEdgesOfThreeTriangles)
{
  const auto mesh = squareMesh(3);
  for (int i = 0; i < 10; ++i)
  {
    addPoint(mesh, 5.0, 5.0, 0.0);
  }
  const vtkIdType fin = addPoint(mesh, 1.0, 1.5, 2.0);
  mesh->GetPolys()->InsertNextCell({ 4, 5, fin });
  const auto filter = critical(mesh);
  const Outcome outcome = update(filter);
  expectFailure(filter, outcome, "Mesh Critical Points", { "edge" });
  EXPECT_THAT(outcome.errors.front(),
    ::testing::AnyOf(::testing::HasSubstr(" 4"), ::testing::HasSubstr(" 5")));
}

// A point at which two fans meet is named, too, by its id in the input.
TEST(MeshInput, refusesPinchedPoints)
{
  Points points = Points::Zero(3, 20);
  points.rightCols(5) << -1, -1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0;
  const auto mesh = makeCloud(points, Values::LinSpaced(20, 0.0, 1.0));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 15, 17, 16 });
  cells->InsertNextCell({ 17, 18, 19 });
  mesh->SetPolys(cells);
  expectRefusal(mesh, { "17" });
}

// Corners that do not exist do not crash.
TEST(MeshInput, refusesCornersThatDoNotExist)
{
  const auto mesh = squareMesh();
  mesh->GetPolys()->InsertNextCell({ 0, 1, 64 });
  expectRefusal(mesh, { "points 0 to 63", "a corner 64" });
}

// Nothing but missing values.
TEST(MeshInput, refusesMeshesWithoutValues)
{
  const auto mesh = torusMesh(Values::Constant(TorusGrid::Columns * TorusGrid::Rows, NaN));
  expectRefusal(mesh, { "finite position and value", "found none", "1152" });
}

// Arrays are chosen and refused as by the point-set filters.
TEST(MeshInput, refusesWhatIsNoFunction)
{
  const auto mesh = torusMesh(torusHeight());
  mesh->GetPointData()->SetActiveScalars(nullptr);
  expectRefusal(mesh, { "no active scalars", "'f'" });
  const auto filter = critical(torusMesh(torusHeight()));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "nope");
  expectFailure(filter, update(filter), "Mesh Critical Points", { "'nope'", "none of this name" });
}

// Thresholds are fractions.
TEST(MeshInput, refusesThresholdsThatAreNoFractions)
{
  for (const double threshold : { -0.1, 1.1, NaN })
  {
    const auto persistence = critical(torusMesh(torusHeight()));
    persistence->SetPersistenceThreshold(threshold);
    expectFailure(persistence, update(persistence), "Mesh Critical Points",
      { "PersistenceThreshold from 0 to 1" });
    const auto delta = critical(torusMesh(torusHeight()));
    delta->SetDelta(threshold);
    expectFailure(delta, update(delta), "Mesh Critical Points", { "Delta from 0 to 1" });
  }
}

// A block that is no polydata is refused by every filter that takes meshes.
TEST(MeshInput, refusesBlocksOfOtherTypes)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, vtkNew<vtkUnstructuredGrid>());
  const auto refuses = [&](vtkAlgorithm* filter, const std::string& name)
  {
    filter->SetInputDataObject(0, blocks);
    const Outcome outcome = update(filter); // the executive goes on with other blocks
    ASSERT_EQ(outcome.errors.size(), 1U);
    EXPECT_THAT(outcome.errors[0],
      AllOf(HasSubstr(name + ": needs blocks that are polydata"), HasSubstr("Extract Surface")));
  };
  refuses(vtkNew<vtkMeshCriticalPoints>(), "Mesh Critical Points");
  refuses(vtkNew<vtkMorseComplex>(), "Morse Complex");
  refuses(vtkNew<vtkConstrainedSmoothing>(), "Constrained Smoothing");
}

// The blocks of a composite dataset are meshes of their own.
TEST(MeshInput, worksOnBlocksOneByOne)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, torusMesh(torusHeight()));
  blocks->SetBlock(1, squareMesh());
  const auto filter = critical(blocks);
  expectSilentSuccess(update(filter));
  for (int port = 0; port < 4; ++port)
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    ASSERT_NE(output, nullptr) << port;
    ASSERT_EQ(output->GetNumberOfBlocks(), 2U);
    for (const unsigned block : { 0U, 1U })
    {
      ASSERT_NE(output->GetBlock(block), nullptr);
      EXPECT_STREQ(output->GetBlock(block)->GetClassName(), port == 3 ? "vtkTable" : "vtkPolyData");
    }
  }
  auto* meshes = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(meshes->GetBlock(0)->GetFieldData()->GetArray("EulerCharacteristic")->GetTuple1(0), 0);
  EXPECT_EQ(meshes->GetBlock(1)->GetFieldData()->GetArray("EulerCharacteristic")->GetTuple1(0), 1);
}
