// What vtkScalarFunctionDesign makes of a mesh on which a saddle needs more neighbors.

#include "DesignTest.h"

#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkTriangleFilter.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

constexpr vtkIdType Columns = TorusGrid::Columns;
constexpr vtkIdType Rows = TorusGrid::Rows;

/// A saddle of multiplicity 3, for which the 6 neighbors that vertices of the torus have are not
/// enough.
std::vector<Asked> multipleSaddle()
{
  return { { torusPlace(0, 0), 3 }, { torusPlace(10, 7), 1, 3.0 }, { torusPlace(24, 0), 0 } };
}

vtkSmartPointer<vtkPolyData> torusOf(vtkCellArray* polygons, vtkCellArray* strips)
{
  const auto mesh = plainTorus();
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  return mesh;
}

vtkSmartPointer<vtkPolyData> quadTorus()
{
  const GridCorners corner{ TorusGrid::Columns, TorusGrid::Rows };
  vtkNew<vtkCellArray> quads;
  for (int j = 0; j < Rows; ++j)
  {
    for (int i = 0; i < Columns; ++i)
    {
      quads->InsertNextCell(
        { corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1) });
    }
  }
  return torusOf(quads, nullptr);
}

/// The first rows as triangles, the others as strips.
vtkSmartPointer<vtkPolyData> stripTorus(int firstStrip)
{
  const GridCorners corner{ TorusGrid::Columns, TorusGrid::Rows };
  vtkNew<vtkCellArray> strips;
  for (int j = firstStrip; j < Rows; ++j)
  {
    strips->InsertNextCell(2 * TorusGrid::Columns + 2);
    for (int i = 0; i <= Columns; ++i)
    {
      strips->InsertCellPoint(corner(i, j + 1));
      strips->InsertCellPoint(corner(i, j));
    }
  }
  return torusOf(gridTriangles(corner, TorusGrid::Columns, firstStrip), strips);
}

/// Numbers its cells and adds x as a point array.
void addArrays(vtkPolyData* mesh)
{
  vtkNew<vtkIntArray> ids;
  ids->SetName("cell");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    ids->InsertNextValue(static_cast<int>(cell));
  }
  mesh->GetCellData()->AddArray(ids);
  addArray<vtkDoubleArray>(mesh, "x", Values(TorusGrid::points().row(0)));
}

/// The area of all triangles of the cells of each number.
std::map<int, double> areas(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(mesh);
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* cut = triangles->GetOutput();
  std::map<int, double> result;
  for (vtkIdType cell = 0; cell < cut->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    cut->GetCellPoints(cell, ids);
    const Vector3d a(cut->GetPoint(ids->GetId(0)));
    const Vector3d b(cut->GetPoint(ids->GetId(1)));
    const Vector3d c(cut->GetPoint(ids->GetId(2)));
    result[static_cast<int>(cut->GetCellData()->GetArray("cell")->GetTuple1(cell))] +=
      (b - a).cross(c - a).norm() / 2.0;
  }
  return result;
}

/// Expects the output to be the mesh with cells refined: the same points before others, on which
/// arrays are linear, and all area at the cell it belonged to.
void expectRefined(vtkPolyData* mesh, vtkPolyData* output)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  ASSERT_GT(output->GetNumberOfPoints(), count);
  for (vtkIdType point = 0; point < output->GetNumberOfPoints(); ++point)
  {
    const Vector3d place(output->GetPoint(point));
    if (point < count)
    {
      EXPECT_EQ(place, Vector3d(mesh->GetPoint(point)));
    }
    EXPECT_NEAR(output->GetPointData()->GetArray("x")->GetTuple1(point), place.x(), 1e-14);
  }
  const auto expected = areas(mesh);
  const auto found = areas(output);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [cell, area] : expected)
  {
    EXPECT_NEAR(found.at(cell), area, 1e-12) << cell;
  }
}

double splitCount(vtkPolyData* output)
{
  double sum = 0.0;
  for (const double split : numbersOf(output->GetCellData()->GetArray("Split")))
  {
    sum += split;
  }
  return sum;
}

} // namespace

// Twelve neighbors instead of six: the six triangles of the star and those around it are halved.
// The saddle is there with its multiplicity, and all is what it would be without splitting.
TEST(ScalarFunctionDesignSplit, splitsAStar)
{
  const auto mesh = plainTorus();
  addArrays(mesh);
  const auto filter = design(mesh, multipleSaddle());
  expectSilentSuccess(update(filter));
  vtkPolyData* output = filter->GetOutput();
  expectRefined(mesh, output);
  EXPECT_EQ(output->GetNumberOfPoints(), Columns * Rows + 6);
  EXPECT_EQ(output->GetNumberOfCells(), 2 * Columns * Rows + 12);
  EXPECT_EQ(splitCount(output), 24.0);
  EXPECT_EQ(designedValues(filter).size(), output->GetNumberOfPoints());
  EXPECT_TRUE(designedValues(filter).allFinite());
  EXPECT_THAT(fieldData(filter, "Missing"), ElementsAre(0));
  EXPECT_THAT(fieldData(filter, "EulerCharacteristic"), ElementsAre(0));
  bool isThere = false;
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    isThere |= point.input == 7 * Columns + 10 && point.multiplicity == 3;
  }
  EXPECT_TRUE(isThere);
}

// Of quads and strips the cells that are touched become triangles, with their cell data; others,
// vertices and lines stay what they are, in the order of polydata.
TEST(ScalarFunctionDesignSplit, replacesCellsOfAnyKind)
{
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 5 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 5, 6, 7 });
  for (const auto& mesh : { quadTorus(), stripTorus(0), stripTorus(7) })
  {
    mesh->SetVerts(verts);
    mesh->SetLines(lines);
    addArrays(mesh);
    const auto filter = design(mesh, multipleSaddle());
    expectWarning(update(filter), { "2 of ", " cells are vertices or lines and ignored" });
    vtkPolyData* output = filter->GetOutput();
    expectRefined(mesh, output);
    EXPECT_EQ(output->GetVerts(), verts.GetPointer());
    EXPECT_EQ(output->GetLines(), lines.GetPointer());
    EXPECT_GE(splitCount(output), 20.0); // quads may be cut along either diagonal
    const auto cells = numbersOf(output->GetCellData()->GetArray("cell"));
    ASSERT_EQ(static_cast<vtkIdType>(cells.size()), output->GetNumberOfCells());
    EXPECT_EQ(cells[0], 0.0);
    EXPECT_EQ(cells[1], 1.0);
    const auto fewer = mesh->GetNumberOfStrips() - output->GetNumberOfStrips();
    EXPECT_EQ(fewer, mesh->GetNumberOfStrips() == 0 ? 0 : mesh->GetNumberOfPolys() == 0 ? 4 : 2);
  }
}

// Cells around missing points, which are left out, stay with those of the output.
TEST(ScalarFunctionDesignSplit, keepsWhatTakesNoPart)
{
  const auto mesh = plainTorus();
  addArrays(mesh);
  mesh->GetPoints()->SetPoint(700, NaN, 0.0, 0.0);
  const auto filter = design(mesh, multipleSaddle());
  expectWarning(update(filter), { "Left out 1 of 1152 points whose position is NaN or infinite" });
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 2 * Columns * Rows + 12);
  EXPECT_EQ(splitCount(filter->GetOutput()), 24.0);
  EXPECT_TRUE(std::isnan(designedValues(filter)(700)));
  EXPECT_EQ(designedValues(filter).array().isNaN().count(), 1);
}

// Arrays of the names that are written are renamed.
TEST(ScalarFunctionDesignSplit, renamesArraysOfTheInput)
{
  const auto mesh = plainTorus();
  vtkNew<vtkIntArray> split;
  split->SetName("Split");
  split->SetNumberOfValues(mesh->GetNumberOfCells());
  split->Fill(7);
  mesh->GetCellData()->AddArray(split);
  for (const auto& asked : { multipleSaddle(), naturalRequests() })
  {
    const auto filter = design(mesh, asked);
    expectWarning(update(filter), { "the input's 'Split' is now 'SplitInput'" });
    vtkCellData* data = filter->GetOutput()->GetCellData();
    EXPECT_EQ(data->GetArray("SplitInput")->GetTuple1(0), 7.0);
    EXPECT_LE(data->GetArray("Split")->GetRange()[1], 1.0);
  }
}
