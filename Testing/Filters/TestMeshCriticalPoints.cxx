// What vtkMeshCriticalPoints writes.

#include "MeshTest.h"

#include "vtkMeshCriticalPoints.h"

#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

std::vector<double> column(vtkMeshCriticalPoints* filter, const char* name)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  return numbersOf(vtkDataArray::SafeDownCast(table->GetColumnByName(name)));
}

/// Minima, saddles and maxima by Delta or Persistence.
std::vector<double> countsInRow(
  vtkMeshCriticalPoints* filter, const std::string& measure, std::size_t row)
{
  std::vector<double> counts;
  for (const char* kind : { "Minima", "Saddles", "Maxima" })
  {
    counts.push_back(column(filter, (measure + kind).c_str())[row]);
  }
  return counts;
}

vtkSmartPointer<vtkMeshCriticalPoints> critical(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  filter->SetInputDataObject(input);
  return filter;
}

} // namespace

// The height of a torus has a minimum, two saddles and a maximum; none of them ever cancels.
TEST(MeshCriticalPoints, findsThoseOfATorus)
{
  const auto filter = critical(torusMesh(torusHeight()));
  expectSilentSuccess(update(filter));
  std::multiset<CriticalType> types;
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    types.insert(point.type);
    EXPECT_EQ(point.multiplicity, 1);
    EXPECT_DOUBLE_EQ(point.value, TorusGrid::height(point.position));
    EXPECT_DOUBLE_EQ(point.persistence, torusHeight().maxCoeff() - torusHeight().minCoeff());
  }
  EXPECT_THAT(types,
    ElementsAre(
      CriticalType::Minimum, CriticalType::Saddle, CriticalType::Saddle, CriticalType::Maximum));
  for (const int port : { 0, 1 })
  {
    EXPECT_THAT(fieldData(filter, "CriticalCounts", port), ElementsAre(1, 2, 1));
    EXPECT_THAT(fieldData(filter, "EulerCharacteristic", port), ElementsAre(0));
  }
  EXPECT_EQ(filter->GetOutput(2)->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfVerts(), 4);
}

// Euler's formula holds for noise; multiplicities count.
TEST(MeshCriticalPoints, obeysEulersFormula)
{
  const auto filter = critical(noisyTorus());
  expectSilentSuccess(update(filter));
  const auto counts = fieldData(filter, "CriticalCounts");
  ASSERT_EQ(counts.size(), 3U);
  EXPECT_EQ(counts[0] - counts[1] + counts[2], 0.0);
  EXPECT_GT(counts[0], 50.0);
  int saddles = 0;
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    saddles += point.type == CriticalType::Saddle ? point.multiplicity : 0;
  }
  EXPECT_EQ(saddles, counts[1]);
}

// Ids lead from the second port to the first, where all other points are regular.
TEST(MeshCriticalPoints, marksThePointsOfTheMesh)
{
  const auto filter = critical(noisyTorus());
  expectSilentSuccess(update(filter));
  vtkDataArray* types = pointArray(filter, "CriticalType");
  vtkDataArray* multiplicities = pointArray(filter, "Multiplicity");
  ASSERT_TRUE(vtkIntArray::SafeDownCast(types) && vtkIntArray::SafeDownCast(multiplicities));
  const auto points = criticalPointsOf(filter);
  for (const CriticalPoint& point : points)
  {
    const auto id = static_cast<vtkIdType>(point.input);
    EXPECT_EQ(types->GetTuple1(id), static_cast<int>(point.type));
    EXPECT_EQ(multiplicities->GetTuple1(id), point.multiplicity);
    EXPECT_EQ(Vector3d(filter->GetOutput()->GetPoint(id)), point.position);
    EXPECT_EQ(pointArray(filter, "f")->GetTuple1(id), point.value);
  }
  const auto all = numbersOf(types);
  EXPECT_EQ(std::count(all.begin(), all.end(), 5), static_cast<long>(all.size() - points.size()));
  EXPECT_TRUE(vtkIdTypeArray::SafeDownCast(pointArray(filter, "PointId", 1)));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "f");
}

// A pair is a line from an extremum to a saddle, and its persistence their difference. On a torus
// all minima but one are in a pair, all maxima but one, and all saddles but the two of its handle.
TEST(MeshCriticalPoints, drawsPairs)
{
  const auto filter = critical(noisyTorus());
  expectSilentSuccess(update(filter));
  vtkPolyData* pairs = filter->GetOutput(2);
  const auto points = criticalPointsOf(filter, 2);
  const auto persistences = numbersOf(pairs->GetCellData()->GetArray("Persistence"));
  const auto types = numbersOf(pairs->GetCellData()->GetArray("PairType"));
  const auto counts = fieldData(filter, "CriticalCounts");
  EXPECT_EQ(std::count(types.begin(), types.end(), 0), counts[0] - 1);
  EXPECT_EQ(std::count(types.begin(), types.end(), 1), counts[2] - 1);
  ASSERT_EQ(pairs->GetNumberOfLines(), counts[1] - 2);
  ASSERT_EQ(pairs->GetNumberOfCells(), pairs->GetNumberOfLines());
  vtkNew<vtkIdList> ends;
  for (vtkIdType line = 0; line < pairs->GetNumberOfLines(); ++line)
  {
    pairs->GetCellPoints(line, ends);
    const CriticalPoint& extremum = points[static_cast<std::size_t>(ends->GetId(0))];
    const CriticalPoint& saddle = points[static_cast<std::size_t>(ends->GetId(1))];
    const auto cell = static_cast<std::size_t>(line);
    EXPECT_EQ(extremum.type, types[cell] == 0.0 ? CriticalType::Minimum : CriticalType::Maximum);
    EXPECT_EQ(saddle.type, CriticalType::Saddle);
    EXPECT_DOUBLE_EQ(persistences[cell], std::abs(saddle.value - extremum.value));
    EXPECT_DOUBLE_EQ(extremum.persistence, persistences[cell]);
    EXPECT_GE(saddle.persistence, persistences[cell]);
  }
}

// What thresholds leave is what the table says they leave, with and without a boundary.
TEST(MeshCriticalPoints, tabulatesWhatThresholdsLeave)
{
  for (const auto& mesh : { noisyTorus(), noisySquare() })
  {
    const auto filter = critical(mesh);
    expectSilentSuccess(update(filter));
    const auto thresholds = column(filter, "Threshold");
    ASSERT_EQ(thresholds.size(), 102U);
    EXPECT_EQ(thresholds.front(), 0.0);
    EXPECT_EQ(thresholds.back(), 1.0);
    for (const std::size_t row : { 0, 1, 50, 75, 90, 97, 101 })
    {
      filter->SetPersistenceThreshold(thresholds[row]);
      filter->SetDelta(0.0);
      expectSilentSuccess(update(filter));
      EXPECT_EQ(fieldData(filter, "CriticalCounts"), countsInRow(filter, "Persistence", row));
      filter->SetPersistenceThreshold(0.0);
      filter->SetDelta(thresholds[row]);
      expectSilentSuccess(update(filter));
      EXPECT_EQ(fieldData(filter, "CriticalCounts"), countsInRow(filter, "Delta", row));
    }
  }
}

// Larger thresholds leave less; by persistence, Euler's formula always holds and what never cancels
// is left.
TEST(MeshCriticalPoints, simplifiesInNestedSteps)
{
  const auto filter = critical(noisyTorus());
  expectSilentSuccess(update(filter));
  for (const char* name : { "DeltaMinima", "DeltaSaddles", "DeltaMaxima", "PersistenceMinima",
         "PersistenceSaddles", "PersistenceMaxima" })
  {
    const auto counts = column(filter, name);
    EXPECT_TRUE(std::is_sorted(counts.rbegin(), counts.rend())) << name;
    EXPECT_GE(counts.back(), 0.0) << name;
  }
  const auto minima = column(filter, "PersistenceMinima");
  const auto saddles = column(filter, "PersistenceSaddles");
  const auto maxima = column(filter, "PersistenceMaxima");
  for (std::size_t row = 0; row < minima.size(); ++row)
  {
    EXPECT_EQ(minima[row] - saddles[row] + maxima[row], 0.0);
  }
  EXPECT_THAT(
    (std::vector<double>{ minima.back(), saddles.back(), maxima.back() }), ElementsAre(1, 2, 1));
}

// Only points and pairs that reach the thresholds are drawn and marked.
TEST(MeshCriticalPoints, hidesWhatIsBelowThresholds)
{
  const auto filter = critical(noisyTorus());
  filter->SetPersistenceThreshold(0.4);
  filter->SetDelta(0.01);
  expectSilentSuccess(update(filter));
  const auto points = criticalPointsOf(filter);
  ASSERT_GT(points.size(), 4U);
  const double range =
    pointArray(filter, "f")->GetRange()[1] - pointArray(filter, "f")->GetRange()[0];
  for (const CriticalPoint& point : points)
  {
    EXPECT_GE(point.persistence, 0.4 * range);
  }
  for (const double persistence :
    numbersOf(filter->GetOutput(2)->GetCellData()->GetArray("Persistence")))
  {
    EXPECT_GE(persistence, 0.4 * range);
  }
  const auto types = numbersOf(pointArray(filter, "CriticalType"));
  EXPECT_EQ(types.size() - static_cast<std::size_t>(std::count(types.begin(), types.end(), 5)),
    points.size());
}

// A constant has a minimum and a maximum, and what the torus asks for: ties are broken by index.
TEST(MeshCriticalPoints, breaksTies)
{
  const auto filter =
    critical(torusMesh(Values::Constant(TorusGrid::Columns * TorusGrid::Rows, 3.0)));
  expectSilentSuccess(update(filter));
  const auto counts = fieldData(filter, "CriticalCounts");
  ASSERT_EQ(counts.size(), 3U);
  EXPECT_EQ(counts[0] - counts[1] + counts[2], 0.0);
  EXPECT_GE(counts[0], 1.0);
  EXPECT_GE(counts[2], 1.0);
}

// Names that the filter needs are made free, with a warning; the input keeps its arrays.
TEST(MeshCriticalPoints, makesRoomForItsArrays)
{
  const auto mesh = torusMesh(torusHeight());
  addArray<vtkIntArray>(mesh, "CriticalType", Values::Constant(mesh->GetNumberOfPoints(), 7));
  const auto filter = critical(mesh);
  expectWarning(update(filter), { "Mesh Critical Points: ", "'CriticalTypeInput'" });
  EXPECT_EQ(pointArray(filter, "CriticalTypeInput")->GetTuple1(0), 7.0);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 2);
}

// A user who gives up gets nothing.
TEST(MeshCriticalPoints, stops)
{
  const auto filter = critical(noisyTorus());
  expectNothingWhenStopped(filter, 0.0);
  expectSilentSuccess(update(filter));
}
