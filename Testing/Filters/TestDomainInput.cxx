// What filters for surfaces and volumes read from datasets of all kinds, and what they refuse.

#include "FieldTest.h"
#include "MeshTest.h"

#include "DomainInput.h"
#include "FilterRun.h"
#include "SolidCells.h"
#include "VolumeTopology.h"
#include "vtkLevelSetDistribution.h"
#include "vtkMeshlessApproximation.h"
#include "vtkRBFEvaluate.h"
#include "vtkRBFExtend.h"

#include "vtkCellType.h"
#include "vtkDataSetAlgorithm.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace
{

/// Reads and keeps what it read.
class ReadFilter : public vtkDataSetAlgorithm
{
public:
  static ReadFilter* New();
  vtkTypeMacro(ReadFilter, vtkDataSetAlgorithm);

  DomainInput Domain;

protected:
  ReadFilter()
  {
    this->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }

  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    return runFilter(*this, "Read Filter", outputs,
      [&](FilterRun& run)
      { this->Domain = readDomain(run, run.execution(), vtkDataSet::GetData(inputs[0])); });
  }
};
vtkStandardNewMacro(ReadFilter);

vtkSmartPointer<ReadFilter> reading(vtkDataSet* input)
{
  auto filter = vtkSmartPointer<ReadFilter>::New();
  filter->SetInputDataObject(input);
  return filter;
}

DomainInput read(vtkDataSet* input)
{
  const auto filter = reading(input);
  expectSilentSuccess(update(filter));
  return filter->Domain;
}

/// With a value for each point: its id.
void numberPoints(vtkDataSet* data)
{
  const auto numbers = vtkSmartPointer<vtkDoubleArray>::New();
  numbers->SetName("f");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  data->GetPointData()->SetScalars(numbers);
}

vtkSmartPointer<vtkImageData> image(int x, int y, int z)
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(x, y, z);
  data->SetOrigin(1.0, 2.0, 3.0);
  data->SetSpacing(0.5, 1.0, 2.0);
  numberPoints(data);
  return data;
}

vtkSmartPointer<vtkUnstructuredGrid> grid(const Points& places)
{
  auto data = vtkSmartPointer<vtkUnstructuredGrid>::New();
  data->SetPoints(makeCloud(places)->GetPoints());
  data->Allocate(1);
  numberPoints(data);
  return data;
}

void addCell(vtkUnstructuredGrid* data, int type, const std::vector<vtkIdType>& corners)
{
  data->InsertNextCell(type, static_cast<vtkIdType>(corners.size()), corners.data());
}

double volumeOf(const DomainInput& domain)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < domain.tetrahedra.cols(); ++i)
  {
    const auto corner = [&](int j) -> Vector3d
    { return domain.vertices().col(domain.tetrahedra(j, i)); };
    sum +=
      std::abs((corner(1) - corner(0)).dot((corner(2) - corner(0)).cross(corner(3) - corner(0))));
  }
  return sum / 6.0;
}

/// How many faces are of one tetrahedron. @throws InvalidInput if one is of more than two
int boundaryFaceCount(const DomainInput& domain)
{
  const VolumeTopology topology(
    static_cast<Index>(domain.vertices().cols()), domain.tetrahedra); // which throws
  std::map<std::set<Index>, int> counts;
  for (Eigen::Index i = 0; i < domain.tetrahedra.cols(); ++i)
  {
    for (int without = 0; without < 4; ++without)
    {
      std::set<Index> face;
      for (int j = 1; j < 4; ++j)
      {
        face.insert(domain.tetrahedra((without + j) % 4, i));
      }
      ++counts[face];
    }
  }
  return static_cast<int>(std::count_if(
    counts.begin(), counts.end(), [](const auto& entry) { return entry.second == 1; }));
}

/// Two cubes, a pyramid on one, a wedge on the other and a tetrahedron on that, at points in a
/// random order.
vtkSmartPointer<vtkUnstructuredGrid> mixedGrid(unsigned seed)
{
  Points places(3, 16);
  places << 0, 1, 2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 3.0, 0.0, 1.0, 2.0, //
    0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 1, 1, 0.5, 0.5, 0.5, 0.5,         //
    0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 0.5, 2.0, 2.0, 2.0;
  std::vector<vtkIdType> names(16);
  std::iota(names.begin(), names.end(), 0);
  std::shuffle(names.begin(), names.end(), std::mt19937(seed));
  Points shuffled(3, 16);
  for (std::size_t i = 0; i < 16; ++i)
  {
    shuffled.col(names[i]) = places.col(static_cast<Eigen::Index>(i));
  }
  auto data = grid(shuffled);
  const auto add = [&](int type, std::vector<vtkIdType> corners)
  {
    for (vtkIdType& corner : corners)
    {
      corner = names[static_cast<std::size_t>(corner)];
    }
    addCell(data, type, corners);
  };
  add(VTK_HEXAHEDRON, { 0, 1, 4, 3, 6, 7, 10, 9 });
  add(VTK_VOXEL, { 1, 2, 4, 5, 7, 8, 10, 11 });
  add(VTK_PYRAMID, { 2, 5, 11, 8, 12 });
  add(VTK_WEDGE, { 6, 9, 13, 7, 10, 14 });
  add(VTK_TETRA, { 7, 10, 14, 15 });
  return data;
}

} // namespace

// Tetrahedra fill the cells and meet in whole faces, whatever the order of the points is: the
// boundary has 8 + 8 triangles of cubes, 4 of the pyramid, 5 of the wedge and 3 of the tetrahedron.
TEST(DomainInput, cutsCellsConformingly)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(seed);
    const DomainInput domain = read(mixedGrid(seed));
    EXPECT_NEAR(volumeOf(domain), 2.0 + 1.0 / 3.0 + 0.5 + 1.0 / 6.0, 1e-12);
    EXPECT_EQ(boundaryFaceCount(domain), 28);
    EXPECT_THAT(domain.cells, ElementsAre(0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 3, 3, 3, 4));
  }
}

// A voxel becomes the six tetrahedra around its diagonal; values and cells follow.
TEST(DomainInput, cutsVoxelsAlongTheirDiagonal)
{
  const auto data = image(5, 4, 3);
  const DomainInput domain = read(data);
  ASSERT_TRUE(domain.isVolume());
  EXPECT_EQ(domain.tetrahedra.cols(), 6 * 4 * 3 * 2);
  EXPECT_NEAR(volumeOf(domain), 2.0 * 3.0 * 4.0, 1e-12);
  EXPECT_EQ(boundaryFaceCount(domain), 2 * 2 * (4 * 3 + 3 * 2 + 2 * 4));
  EXPECT_EQ(domain.mesh.valueName, "f");
  for (Eigen::Index i = 0; i < domain.tetrahedra.cols(); ++i)
  {
    vtkNew<vtkIdList> corners;
    data->GetCellPoints(domain.cells[static_cast<std::size_t>(i)], corners);
    EXPECT_EQ(domain.tetrahedra.col(i).minCoeff(), corners->GetId(0));
    EXPECT_EQ(domain.tetrahedra.col(i).maxCoeff(), corners->GetId(7));
  }
  for (Eigen::Index i = 0; i < domain.vertices().cols(); ++i)
  {
    EXPECT_EQ(domain.mesh.values(i), static_cast<double>(i));
    EXPECT_EQ(domain.vertices().col(i), Vector3d(data->GetPoint(i)));
  }
}

// A rectilinear grid is as an image with other places.
TEST(DomainInput, takesOtherGrids)
{
  const auto data = vtkSmartPointer<vtkRectilinearGrid>::New();
  data->SetDimensions(3, 2, 2);
  const auto set = [](const std::vector<double>& numbers)
  {
    auto array = vtkSmartPointer<vtkDoubleArray>::New();
    for (const double number : numbers)
    {
      array->InsertNextValue(number);
    }
    return array;
  };
  data->SetXCoordinates(set({ 0.0, 1.0, 4.0 }));
  data->SetYCoordinates(set({ 0.0, 2.0 }));
  data->SetZCoordinates(set({ 0.0, 3.0 }));
  numberPoints(data);
  EXPECT_NEAR(volumeOf(read(data)), 24.0, 1e-12);
}

// A flat image is a surface of two triangles for each pixel, whichever axis is flat.
TEST(DomainInput, takesFlatImagesAsSurfaces)
{
  for (const auto& data : { image(4, 3, 1), image(4, 1, 3), image(1, 4, 3) })
  {
    const DomainInput domain = read(data);
    EXPECT_FALSE(domain.isVolume());
    EXPECT_EQ(domain.mesh.surface.triangles.cols(), 12);
    EXPECT_EQ(domain.vertices().cols(), 12);
    EXPECT_THAT(domain.cells, ElementsAre(0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5));
  }
}

// Cells of polydata and of an unstructured grid know their triangles, also next to holes.
TEST(DomainInput, knowsTheCellsOfTriangles)
{
  const auto mesh = squareMesh(3);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 4, 3 });
  cells->InsertNextCell({ 1, 2, 4 }); // around point 2, which is missing
  cells->InsertNextCell({ 2, 5, 4 });
  cells->InsertNextCell({ 3, 4, 7, 6 });
  cells->InsertNextCell({ 4, 5, 8, 7 });
  mesh->SetPolys(cells);
  mesh->GetPointData()->GetScalars()->SetComponent(2, 0, NaN);
  vtkNew<vtkUnstructuredGrid> flat;
  flat->SetPoints(mesh->GetPoints());
  flat->SetCells(VTK_POLYGON, cells);
  flat->GetPointData()->ShallowCopy(mesh->GetPointData());
  for (vtkDataSet* data : { static_cast<vtkDataSet*>(mesh), static_cast<vtkDataSet*>(flat) })
  {
    const auto filter = reading(data);
    expectWarning(update(filter), { "Left out 1 of 9 points", "2 of 8 triangles" });
    EXPECT_THAT(filter->Domain.cells, ElementsAre(0, 0, 3, 3, 4, 4));
    EXPECT_EQ(filter->Domain.map().vertexOf(2), VertexMap::None);
  }
}

// Points without a finite value are left out with the tetrahedra around them.
TEST(DomainInput, leavesMissingPointsOut)
{
  const auto data = image(3, 3, 3);
  data->GetPointData()->GetScalars()->SetComponent(0, 0, NaN);
  const auto filter = reading(data);
  expectWarning(update(filter),
    { "Left out 1 of 27 points whose position or value is NaN or infinite",
      "with 6 of 48 tetrahedra" });
  const DomainInput& domain = filter->Domain;
  EXPECT_EQ(domain.vertices().cols(), 26);
  EXPECT_EQ(domain.map().vertexOf(0), VertexMap::None);
  EXPECT_EQ(domain.map().vertexOf(26), 25U);
  EXPECT_EQ(domain.mesh.values(25), 26.0);
  EXPECT_EQ(domain.cells.front(), 1);
}

// Flat cells of a volume, unused points and tetrahedra with a corner twice are ignored.
TEST(DomainInput, ignoresWhatIsNoVolume)
{
  const auto data = mixedGrid(0);
  addCell(data, VTK_TRIANGLE, { 0, 1, 2 });
  addCell(data, VTK_VERTEX, { 0 });
  addCell(data, VTK_TETRA, { 0, 1, 2, 1 });
  data->GetPoints()->InsertNextPoint(0.0, 0.0, 0.0);
  numberPoints(data);
  const auto filter = reading(data);
  expectWarning(update(filter),
    { "2 of 8 cells are flat, lines or vertices and ignored",
      "1 of 19 tetrahedra have the same corner twice",
      "1 of 17 points are in no tetrahedron and get NaN" });
  EXPECT_EQ(filter->Domain.tetrahedra.cols(), 18);
}

TEST(DomainInput, refusesWhatItCannotRead)
{
  const auto expectRefusal = [](vtkDataSet* data, std::initializer_list<const char*> parts)
  {
    const auto filter = reading(data);
    expectFailure(filter, update(filter), "Read Filter", parts);
  };
  const auto quadratic = grid(randomCube(10, 1));
  addCell(quadratic, VTK_QUADRATIC_TETRA, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9 });
  expectRefusal(quadratic, { "pyramids, found a vtkQuadraticTetra, cell 0", "Tetrahedralize" });
  expectRefusal(grid(randomCube(10, 1)), { "found none among 0 cells", "point-set filter" });
  expectRefusal(image(5, 1, 1), { "found none among 4 cells" });
  expectRefusal(vtkNew<vtkImageData>(), { "found no points" });
  const auto bare = image(3, 3, 3);
  bare->GetPointData()->Initialize();
  expectRefusal(bare, { "found no active scalars" });
  const auto all = image(3, 3, 3);
  all->GetPointData()->GetScalars()->Fill(NaN);
  expectRefusal(all, { "tetrahedra between points with a finite position and value, found none" });
  const auto wild = grid(randomCube(4, 1));
  addCell(wild, VTK_TETRA, { 0, 1, 2, 9 });
  expectRefusal(wild, { "a corner 9" });
}

// VTK's own sentence says what is no dataset, and of which type it is: there is an output to refuse
// it for.
TEST(DomainInput, isADataset)
{
  const auto expectRefusal = [](vtkAlgorithm* filter, int port)
  {
    vtkNew<vtkPolyData> none;
    filter->SetInputDataObject(0, none);
    filter->SetInputDataObject(port, vtkNew<vtkTable>());
    const Outcome outcome = update(filter);
    EXPECT_FALSE(outcome.succeeded);
    EXPECT_THAT(
      outcome.pipeline, ElementsAre(HasSubstr("of type vtkTable, but a vtkDataSet is required")));
  };
  expectRefusal(vtkNew<vtkLevelSetDistribution>(), 0);
  expectRefusal(vtkNew<vtkMeshlessApproximation>(), 0);
  expectRefusal(vtkNew<vtkRBFEvaluate>(), 1);
  expectRefusal(vtkNew<vtkRBFExtend>(), 1);
}
