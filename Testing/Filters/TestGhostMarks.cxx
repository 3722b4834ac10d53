// What the filters for meshes make of hidden cells and of duplicates of another piece's.

#include "ApproximationTest.h"
#include "GhostTest.h"

#include "vtkConstrainedSmoothing.h"
#include "vtkMeshlessContour.h"
#include "vtkMorseComplex.h"
#include "vtkScalarFunctionDesign.h"

#include "vtkTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <utility>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

using Algorithm = vtkSmartPointer<vtkAlgorithm>;

/// Of the height of a torus.
vtkPolyData* heightModel()
{
  static const auto filter = []()
  {
    const auto result = approximation(torusMesh(torusHeight()));
    expectSilentSuccess(update(result));
    return result;
  }();
  return model(filter);
}

/// The filters that work on a mesh with the array f.
std::vector<Algorithm> filtersOf(vtkPolyData* mesh)
{
  const auto contour = vtkSmartPointer<vtkMeshlessContour>::New();
  contour->SetInputData(heightModel());
  contour->SetSurfaceData(mesh);
  const auto critical = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  const auto ofModel = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  ofModel->SetModelData(heightModel());
  const auto design = vtkSmartPointer<vtkScalarFunctionDesign>::New();
  design->SetTemplateArray("f");
  std::vector<Algorithm> filters{ critical, ofModel, vtkSmartPointer<vtkMorseComplex>::New(),
    vtkSmartPointer<vtkConstrainedSmoothing>::New(), design, approximation(mesh) };
  for (const Algorithm& filter : filters)
  {
    filter->SetInputDataObject(mesh);
  }
  filters.push_back(contour);
  return filters;
}

/// All numbers of the point and field data of the outputs, but for marks. NaN becomes a number.
std::map<std::string, std::vector<double>> numbersOf(vtkAlgorithm* filter)
{
  std::map<std::string, std::vector<double>> result;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    auto* dataSet = vtkDataSet::SafeDownCast(output);
    auto* table = vtkTable::SafeDownCast(output);
    vtkFieldData* rows = dataSet ? dataSet->GetPointData() : nullptr;
    for (vtkFieldData* data : { output->GetFieldData(), table ? table->GetRowData() : rows })
    {
      for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
      {
        const std::string name = data->GetArrayName(i);
        vtkDataArray* array = data->GetArray(i);
        if (array && name != vtkDataSetAttributes::GhostArrayName())
        {
          std::vector<double>& numbers = result[std::to_string(port) + " " + name];
          for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
          {
            const int width = array->GetNumberOfComponents();
            const double number = array->GetComponent(k / width, static_cast<int>(k % width));
            numbers.push_back(std::isnan(number) ? -1e300 : number);
          }
        }
      }
    }
  }
  return result;
}

/// The cells for which a condition on their corners holds, and all points.
vtkSmartPointer<vtkPolyData> withCells(
  vtkPolyData* mesh, const std::function<bool(vtkCell*)>& isThere)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(mesh->GetPoints());
  result->GetPointData()->ShallowCopy(mesh->GetPointData());
  const vtkNew<vtkCellArray> cells;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (isThere(mesh->GetCell(cell)))
    {
      cells->InsertNextCell(mesh->GetCell(cell)->GetPointIds());
    }
  }
  result->SetPolys(cells);
  return result;
}

template <class Condition>
bool anyCorner(vtkCell* cell, const Condition& condition)
{
  const vtkIdType* ids = cell->GetPointIds()->GetPointer(0);
  return std::any_of(ids, ids + cell->GetNumberOfPoints(), condition);
}

/// A height with some noise, which leaves few features.
vtkSmartPointer<vtkPolyData> slightlyNoisyTorus()
{
  const Values height = torusHeight();
  return torusMesh(height + 0.02 * noise(height.size()));
}

} // namespace

// Without a word, all results are those of the mesh without the hidden cells, whether these are
// marked or one of their points is, and whatever is at their points.
TEST(GhostMarks, hiddenCellsAreNoPartOfTheMesh)
{
  const auto mesh = slightlyNoisyTorus();
  const auto isOut = [&](vtkIdType point) { return mesh->GetPoint(point)[0] > 0.5; };
  const auto isHidden = [&](vtkCell* cell) { return anyCorner(cell, isOut); };
  const auto rest = withCells(mesh, [&](vtkCell* cell) { return !isHidden(cell); });
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    if (isOut(point))
    {
      mesh->GetPointData()->GetScalars()->SetComponent(point, 0, point % 2 == 0 ? NaN : 1e9);
    }
  }
  const auto ofRest = filtersOf(rest);
  for (const bool byPoints : { false, true })
  {
    const auto marked = vtkSmartPointer<vtkPolyData>::New();
    marked->DeepCopy(mesh);
    byPoints ? markPoints(marked, vtkDataSetAttributes::HIDDENPOINT, isOut)
             : markCells(marked, vtkDataSetAttributes::HIDDENCELL, isHidden);
    const auto ofMarked = filtersOf(marked);
    for (std::size_t i = 0; i < ofRest.size(); ++i)
    {
      SCOPED_TRACE(ofRest[i]->GetClassName());
      EXPECT_TRUE(update(ofRest[i]).succeeded);
      const Outcome outcome = update(ofMarked[i]);
      EXPECT_TRUE(outcome.succeeded);
      for (const std::string& warning : outcome.warnings)
      {
        EXPECT_EQ(warning.find("NaN"), std::string::npos) << warning;
      }
      auto expected = numbersOf(ofRest[i]);
      auto found = numbersOf(ofMarked[i]);
      EXPECT_GT(expected.size(), 4U);
      expected.erase("0 f");
      found.erase("0 f");
      for (const auto& [name, numbers] : expected)
      {
        EXPECT_EQ(found[name], numbers) << name;
      }
      EXPECT_EQ(found.size(), expected.size());
    }
  }
}

// Where hidden cells meet at a point, its larger fan is kept, and what hides all is refused.
TEST(GhostMarks, holesMayMeet)
{
  const auto mesh = squareMesh(6);
  markCells(mesh, vtkDataSetAttributes::HIDDENCELL,
    [](vtkCell* cell)
    {
      const double* bounds = cell->GetBounds();
      return (bounds[1] <= 3.0 && bounds[3] <= 3.0) || (bounds[0] >= 3.0 && bounds[2] >= 3.0);
    });
  const auto filter = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  filter->SetInputDataObject(mesh);
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_EQ(fieldData(filter, "EulerCharacteristic"), std::vector<double>{ 2.0 });
  markCells(mesh, vtkDataSetAttributes::HIDDENCELL, [](vtkCell*) { return true; });
  expectFailure(filter, update(filter), "Mesh Critical Points",
    { "cells that are not hidden", "none among 50" });
}

namespace
{

/// The part of a mesh where x is on one side of 0, and the cells around its points, which are
/// duplicates of the other's if their first corner is there.
vtkSmartPointer<vtkPolyData> pieceOf(vtkPolyData* mesh, double side)
{
  const auto isOwn = [&](vtkIdType point) { return mesh->GetPoint(point)[0] * side > 0.0; };
  const auto piece = withCells(mesh, [&](vtkCell* cell) { return anyCorner(cell, isOwn); });
  piece->GetPointData()->Initialize();
  piece->GetPointData()->SetScalars(mesh->GetPointData()->GetScalars());
  markPoints(
    piece, vtkDataSetAttributes::DUPLICATEPOINT, [&](vtkIdType point) { return !isOwn(point); });
  markCells(piece, vtkDataSetAttributes::DUPLICATECELL,
    [&](vtkCell* cell) { return !isOwn(cell->GetPointId(0)); });
  return piece;
}

using Listed = std::multiset<std::array<double, 3>>; ///< point, type, multiplicity

void addListed(vtkPolyDataAlgorithm* filter, Listed& all)
{
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    all.insert({ static_cast<double>(point.input), static_cast<double>(point.type),
      static_cast<double>(point.multiplicity) });
  }
}

} // namespace

// The critical points that two pieces list are those of the whole mesh, each once, if both have the
// cells around their points. Numbers add up.
TEST(GhostMarks, piecesListCriticalPointsOnce)
{
  const auto mesh = noisyTorus();
  const auto whole = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  whole->SetInputDataObject(mesh);
  expectSilentSuccess(update(whole));
  Listed expected;
  addListed(whole, expected);
  const auto columns = [](vtkMeshCriticalPoints* filter)
  {
    std::vector<double> numbers = fieldData(filter, "CriticalCounts");
    auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
    for (const char* name : { "DeltaMinima", "DeltaSaddles", "PersistenceMinima",
           "PersistenceSaddles", "PersistenceMaxima" })
    {
      numbers.push_back(table->GetValueByName(0, name).ToDouble());
    }
    return numbers;
  };
  Listed found;
  std::vector<double> sum(columns(whole).size(), 0.0);
  for (const double side : { -1.0, 1.0 })
  {
    const auto filter = vtkSmartPointer<vtkMeshCriticalPoints>::New();
    filter->SetInputDataObject(pieceOf(mesh, side));
    EXPECT_TRUE(update(filter).succeeded);
    addListed(filter, found);
    const std::vector<double> ofPiece = columns(filter);
    std::transform(sum.begin(), sum.end(), ofPiece.begin(), sum.begin(), std::plus<>());
    EXPECT_EQ(filter->GetOutput(2)->GetNumberOfPoints(), filter->GetOutput(1)->GetNumberOfPoints());
    EXPECT_GT(filter->GetOutput(2)->GetNumberOfCells(), 50);
    // Types are those of all points.
    const auto types = numbersOf(pointArray(filter, "CriticalType"));
    const auto count = std::count_if(
      types.begin(), types.end(), [](double type) { return type >= 0.0 && type < 5.0; });
    EXPECT_GT(count, filter->GetOutput(1)->GetNumberOfPoints());
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(sum, columns(whole));
}

// Of a model, too: every point is refined from the piece that has its candidate.
TEST(GhostMarks, piecesListPointsOfModelsOnce)
{
  const auto mesh = torusMesh(torusHeight());
  std::vector<double> types;
  for (const double side : { -1.0, 1.0 })
  {
    const auto filter = vtkSmartPointer<vtkMeshCriticalPoints>::New();
    filter->SetInputDataObject(pieceOf(mesh, side));
    filter->SetModelData(heightModel());
    EXPECT_TRUE(update(filter).succeeded);
    for (const CriticalPoint& point : criticalPointsOf(filter))
    {
      types.push_back(static_cast<double>(point.type));
    }
  }
  std::sort(types.begin(), types.end());
  EXPECT_EQ(types, (std::vector<double>{ 0.0, 1.0, 1.0, 3.0 }));
}

// A path belongs to the piece of its saddle, as does what it passes.
TEST(GhostMarks, piecesHaveThePathsOfTheirSaddles)
{
  const auto mesh = noisyTorus();
  const auto pathsFrom = [](vtkMorseComplex* filter, std::multiset<vtkIdType>& saddles)
  {
    const auto nodes = criticalPointsOf(filter);
    for (const double source : numbersOf(filter->GetOutput()->GetCellData()->GetArray("SourceId")))
    {
      saddles.insert(static_cast<vtkIdType>(nodes.at(static_cast<std::size_t>(source)).input));
    }
    for (const double end :
      numbersOf(filter->GetOutput()->GetCellData()->GetArray("DestinationId")))
    {
      EXPECT_NE(nodes.at(static_cast<std::size_t>(end)).type, CriticalType::Saddle);
    }
  };
  const auto complexOf = [](vtkPolyData* input)
  {
    auto filter = vtkSmartPointer<vtkMorseComplex>::New();
    filter->SetInputDataObject(input);
    EXPECT_TRUE(update(filter).succeeded);
    return filter;
  };
  const auto whole = complexOf(mesh);
  std::multiset<vtkIdType> expected;
  pathsFrom(whole, expected);
  std::multiset<vtkIdType> found;
  std::vector<double> counts(3, 0.0);
  for (const double side : { -1.0, 1.0 })
  {
    const auto filter = complexOf(pieceOf(mesh, side));
    pathsFrom(filter, found);
    const auto ofPiece = fieldData(filter, "CriticalCounts");
    std::transform(counts.begin(), counts.end(), ofPiece.begin(), counts.begin(), std::plus<>());
  }
  EXPECT_EQ(found, expected);
  EXPECT_EQ(counts, fieldData(whole, "CriticalCounts"));
}

// Level sets of a model are drawn by the piece whose cells they cross: once.
TEST(GhostMarks, piecesDrawContoursOnce)
{
  const auto mesh = torusMesh(torusHeight());
  const auto lengthOf = [](vtkPolyData* surface)
  {
    const auto filter = vtkSmartPointer<vtkMeshlessContour>::New();
    filter->SetInputData(heightModel());
    filter->SetSurfaceData(surface);
    filter->SetContourValues(0, 0.3);
    EXPECT_TRUE(update(filter).succeeded);
    const auto lengths = numbersOf(filter->GetOutput()->GetCellData()->GetArray("Length"));
    return std::accumulate(lengths.begin(), lengths.end(), 0.0);
  };
  const double whole = lengthOf(mesh);
  EXPECT_GT(whole, 3.0);
  EXPECT_NEAR(lengthOf(pieceOf(mesh, -1.0)) + lengthOf(pieceOf(mesh, 1.0)), whole, 1e-4 * whole);
}
