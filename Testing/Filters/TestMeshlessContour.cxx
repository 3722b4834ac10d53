// vtkMeshlessContour: curves of a model on a mesh, what is written with them and what is refused.

#include "FieldTest.h"
#include "MeshTest.h"

#include "vtkMeshlessContour.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

using Filter = vtkMeshlessContour;

double distanceSquared(const Vector3d& p)
{
  return (p - Vector3d(3.2, 3.4, 0.0)).squaredNorm();
}

/// Of distanceSquared(), from samples in and around squareMesh().
vtkSmartPointer<vtkPolyData> makeModel(int scheme = 5)
{
  const Points places = (4.5 * randomCube(400, 1)).colwise() + Vector3d(3.5, 3.5, 0.0);
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(makeCloud(places, distanceSquared));
  filter->SetScheme(scheme);
  filter->SetGridDimensions(2, 2, 2);
  expectSilentSuccess(update(filter));
  const auto model = vtkSmartPointer<vtkPolyData>::New();
  model->DeepCopy(filter->GetOutputDataObject(1));
  return model;
}

vtkSmartPointer<Filter> contour(
  vtkPolyData* model, vtkDataObject* surface, const std::vector<double>& values = { 4.0 })
{
  const auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(model);
  filter->SetSurfaceData(surface);
  for (const double value : values)
  {
    filter->SetContourValues(filter->GetNumberOfContourValues(), value);
  }
  return filter;
}

void expectRefusal(Filter* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Meshless Contour", parts);
}

std::vector<double> cellData(Filter* filter, const char* name)
{
  return FilterTest::numbersOf(filter->GetOutput()->GetCellData()->GetArray(name));
}

} // namespace

// Circles of known radius: arrays of points, cells and field data, closed curves that end with the
// id they start with.
TEST(MeshlessContour, writesCurves)
{
  const auto filter = contour(makeModel(), squareMesh(), { 4.0, 1.0, 1.0, 1e6 });
  expectSilentSuccess(update(filter));
  EXPECT_EQ(fieldData(filter, "IsoValues"), (std::vector<double>{ 1.0, 4.0, 1e6 }));
  EXPECT_EQ(fieldData(filter, "ComponentCounts"), (std::vector<double>{ 1, 1, 0 }));
  EXPECT_EQ(cellData(filter, "IsoValue"), (std::vector<double>{ 1.0, 4.0 }));
  EXPECT_EQ(cellData(filter, "ComponentId"), (std::vector<double>{ 0, 0 }));
  EXPECT_EQ(cellData(filter, "Closed"), (std::vector<double>{ 1, 1 }));
  EXPECT_NEAR(cellData(filter, "Length")[0], 2.0 * Pi, 0.05);
  EXPECT_NEAR(cellData(filter, "Length")[1], 4.0 * Pi, 0.05);

  vtkPolyData* output = filter->GetOutput();
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "f");
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    output->GetCellPoints(cell, ids);
    EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1));
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType point = ids->GetId(i);
      const double value = pointArray(filter, "f")->GetComponent(point, 0);
      EXPECT_EQ(value, cellData(filter, "IsoValue")[static_cast<std::size_t>(cell)]);
      EXPECT_NEAR(distanceSquared(Vector3d(output->GetPoint(point))), value, 0.1);
      EXPECT_EQ(pointArray(filter, "Normals")->GetComponent(point, 2), 1.0);
      EXPECT_LE(pointArray(filter, "Residual")->GetComponent(point, 0), 1e-9);
    }
  }
  EXPECT_NEAR(fieldData(filter, "Tolerance")[0], 1e-3, 1e-15);
  EXPECT_LE(fieldData(filter, "LargestDeviation")[0], 1e-3);
  EXPECT_GT(fieldData(filter, "EvaluatedShare")[0], 0.3);
  EXPECT_LE(fieldData(filter, "EvaluatedShare")[0], 1.0);
  EXPECT_GT(fieldData(filter, "Evaluations")[0], 100.0);
  EXPECT_TRUE(fieldData(filter, "NeighborCount").empty());
}

// The tolerance decides how many points a curve has; without values the middle of the range is
// contoured.
TEST(MeshlessContour, heedsItsProperties)
{
  const auto model = makeModel();
  const auto filter = contour(model, squareMesh(), {});
  expectSilentSuccess(update(filter));
  const auto range = FilterTest::numbersOf(model->GetFieldData()->GetArray("ValueRange"));
  ASSERT_EQ(fieldData(filter, "IsoValues").size(), 1u);
  EXPECT_DOUBLE_EQ(fieldData(filter, "IsoValues")[0], 0.5 * (range[0] + range[1]));

  filter->SetContourValues(0, 4.0);
  expectSilentSuccess(update(filter));
  const vtkIdType count = filter->GetOutput()->GetNumberOfPoints();
  filter->SetTolerance(1e-5);
  expectSilentSuccess(update(filter));
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 5 * count);
  filter->SetMaximumRefinement(2);
  expectWarning(update(filter),
    { "Meshless Contour: Curves are up to ", "Tolerance of 1e-05", "MaximumRefinement (2)" });
  EXPECT_GT(fieldData(filter, "LargestDeviation")[0], 1e-5);
  filter->SetNumberOfContourValues(0);
  EXPECT_EQ(filter->GetNumberOfContourValues(), 0);
}

// A model read from a file gives the same bits.
TEST(MeshlessContour, readsModelsFromFiles)
{
  const auto model = makeModel();
  const std::string path = std::string(SURFACE_SCALARS_OUTPUT) + "/contour-model.vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(model);
  writer->SetDataModeToBinary();
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto one = contour(model, squareMesh());
  const auto other = contour(reader->GetOutput(), squareMesh());
  expectSilentSuccess(update(one));
  expectSilentSuccess(update(other));
  ASSERT_EQ(one->GetOutput()->GetNumberOfPoints(), other->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < one->GetOutput()->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(Vector3d(one->GetOutput()->GetPoint(i)), Vector3d(other->GetOutput()->GetPoint(i)));
  }
}

// Local schemes jump a little; curves close nevertheless.
TEST(MeshlessContour, takesModelsOfLocalSchemes)
{
  for (const int scheme : { 1, 2, 3, 4 })
  {
    const auto filter = contour(makeModel(scheme), squareMesh());
    EXPECT_TRUE(update(filter).succeeded);
    EXPECT_EQ(cellData(filter, "Closed"), std::vector<double>{ 1 }) << scheme;
  }
}

// The blocks of a composite surface are contoured one by one.
TEST(MeshlessContour, worksOnBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, squareMesh());
  blocks->SetBlock(2, squareMesh(5));
  const auto filter = contour(makeModel(), blocks);
  EXPECT_TRUE(update(filter).succeeded);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(vtkPolyData::SafeDownCast(output->GetBlock(0))->GetNumberOfCells(), 1);
  EXPECT_EQ(output->GetBlock(1), nullptr);
  EXPECT_GE(vtkPolyData::SafeDownCast(output->GetBlock(2))->GetNumberOfCells(), 1);
}

// What is left out is counted in one warning: points that are nowhere, lines; the mesh has a hole
// there, at which curves end.
TEST(MeshlessContour, leavesOutWhatIsNowhere)
{
  const auto mesh = squareMesh();
  mesh->GetPoints()->SetPoint(8 * 3 + 5, NaN, 0.0, 0.0);
  const auto filter = contour(makeModel(), mesh);
  expectWarning(update(filter), { "Left out 1 of 64 points whose position is NaN" });
  EXPECT_EQ(cellData(filter, "Closed"), std::vector<double>{ 0 });
}

TEST(MeshlessContour, saysHowMuchIsExtrapolated)
{
  Points places = 0.5 * randomCube(200, 3);
  vtkNew<vtkRBFExtend> extend;
  extend->SetInputData(makeCloud(places, distanceSquared));
  extend->SetScheme(5);
  extend->SetGridDimensions(2, 2, 2);
  expectSilentSuccess(update(extend));
  const auto filter =
    contour(vtkPolyData::SafeDownCast(extend->GetOutputDataObject(1)), squareMesh());
  const Outcome outcome = update(filter);
  expectWarning(outcome,
    { "Meshless Contour: ", "% of the curves' length is farther than ",
      "the function is extrapolated there." });
}

// Where there is nothing, what there would be is said.
TEST(MeshlessContour, saysThatThereIsNothing)
{
  expectWarning(update(contour(makeModel(), squareMesh(), { 1e30 })),
    { "The model takes none of the values on the surface; at its centers it is from " });
}

TEST(MeshlessContour, refusesWhatItCannotUse)
{
  expectRefusal(contour(waveSamples(), squareMesh()), { "needs a Model" });
  expectRefusal(contour(makeModel(), nullptr),
    { "needs a Surface of triangles, which is polydata, found none" });
  expectRefusal(
    contour(makeModel(), makeCloud(randomCube(10, 1))), { "no triangle among 0 cells" });
  expectRefusal(contour(makeModel(), squareMesh(), { 1.0, NaN }),
    { "finite numbers as ContourValues", "nan at index 1" });
  const auto filter = contour(makeModel(), squareMesh());
  filter->SetTolerance(-1.0);
  expectRefusal(filter, { "a Tolerance of 0 (automatic) or more", "-1" });
  filter->SetTolerance(NaN);
  expectRefusal(filter, { "a Tolerance of 0 (automatic) or more", "nan" });
  filter->SetTolerance(0.0);
  filter->SetMaximumRefinement(21);
  expectRefusal(filter, { "a MaximumRefinement from 0 to 20", "21" });
}

TEST(MeshlessContour, leavesNothingWhenStopped)
{
  for (const double fraction : { 0.0, 0.3, 0.6 })
  {
    expectNothingWhenStopped(contour(makeModel(), squareMesh()), fraction);
  }
}
