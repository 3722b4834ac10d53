// What vtkMorseComplex writes.

#include "MeshTest.h"

#include "vtkMorseComplex.h"

#include "vtkCellData.h"
#include "vtkIdList.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

vtkSmartPointer<vtkMorseComplex> complexOf(vtkDataObject* input)
{
  auto filter = vtkSmartPointer<vtkMorseComplex>::New();
  filter->SetInputDataObject(input);
  return filter;
}

/// Expects paths from saddles to extrema that rise or fall all along, named by their nodes.
void expectPaths(vtkMorseComplex* filter)
{
  vtkPolyData* paths = filter->GetOutput();
  const auto nodes = criticalPointsOf(filter);
  const auto number = [&](const char* name, vtkIdType cell)
  { return static_cast<std::size_t>(paths->GetCellData()->GetArray(name)->GetTuple1(cell)); };
  vtkDataArray* values = pointArray(filter, "f");
  vtkDataArray* ids = pointArray(filter, "PointId");
  vtkNew<vtkIdList> path;
  for (vtkIdType cell = 0; cell < paths->GetNumberOfCells(); ++cell)
  {
    paths->GetCellPoints(cell, path);
    const vtkIdType last = path->GetNumberOfIds() - 1;
    const CriticalPoint& source = nodes.at(number("SourceId", cell));
    const CriticalPoint& destination = nodes.at(number("DestinationId", cell));
    const bool up = number("SeparatrixType", cell) == 1;
    EXPECT_EQ(source.type, CriticalType::Saddle);
    EXPECT_EQ(destination.type, up ? CriticalType::Maximum : CriticalType::Minimum);
    EXPECT_EQ(ids->GetTuple1(path->GetId(0)), source.input);
    EXPECT_EQ(ids->GetTuple1(path->GetId(last)), destination.input);
    EXPECT_DOUBLE_EQ(paths->GetCellData()->GetArray("Persistence")->GetTuple1(cell),
      std::abs(source.value - destination.value));
    for (vtkIdType i = 0; i < last; ++i)
    {
      const double step = values->GetTuple1(path->GetId(i + 1)) - values->GetTuple1(path->GetId(i));
      EXPECT_GE(up ? step : -step, 0.0);
    }
  }
}

} // namespace

// From each saddle of a torus two paths go down and two go up.
TEST(MorseComplexFilter, drawsThePathsOfATorus)
{
  const auto filter = complexOf(torusMesh(torusHeight()));
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), 8);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfVerts(), 4);
  expectPaths(filter);
  const auto types = numbersOf(filter->GetOutput()->GetCellData()->GetArray("SeparatrixType"));
  EXPECT_EQ(std::count(types.begin(), types.end(), 1), 4);
  for (const int port : { 0, 1 })
  {
    EXPECT_THAT(fieldData(filter, "CriticalCounts", port), ElementsAre(1, 2, 1));
    EXPECT_THAT(fieldData(filter, "EulerCharacteristic", port), ElementsAre(0));
  }
}

// For noise the paths are right, too; a saddle of multiplicity m starts m + 1 in each direction.
TEST(MorseComplexFilter, drawsThePathsOfNoise)
{
  const auto filter = complexOf(noisyTorus());
  expectSilentSuccess(update(filter));
  expectPaths(filter);
  int expected = 0;
  for (const CriticalPoint& node : criticalPointsOf(filter))
  {
    expected += node.type == CriticalType::Saddle ? 2 * (node.multiplicity + 1) : 0;
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfLines(), expected);
}

// A vertex of the mesh is one point, however many paths go through it, and says what it is.
TEST(MorseComplexFilter, sharesPoints)
{
  const auto filter = complexOf(noisyTorus());
  expectSilentSuccess(update(filter));
  auto ids = numbersOf(pointArray(filter, "PointId"));
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
  const auto types = numbersOf(pointArray(filter, "CriticalType"));
  const auto nodes = criticalPointsOf(filter);
  EXPECT_EQ(types.size() - static_cast<std::size_t>(std::count(types.begin(), types.end(), 5)),
    nodes.size());
}

// What is below the threshold is cancelled: with all of it only what the torus asks for is left.
TEST(MorseComplexFilter, simplifies)
{
  const auto filter = complexOf(noisyTorus());
  filter->SetPersistenceThreshold(1.0);
  expectSilentSuccess(update(filter));
  expectPaths(filter);
  EXPECT_THAT(fieldData(filter, "CriticalCounts"), ElementsAre(1, 2, 1));
}

// Without saddles there is nothing to draw.
TEST(MorseComplexFilter, drawsNothingWithoutSaddles)
{
  const auto filter = complexOf(squareMesh());
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfPoints(), 2);
}

TEST(MorseComplexFilter, refuses)
{
  const auto filter = complexOf(makeCloud(TorusGrid::points(), torusHeight()));
  expectFailure(
    filter, update(filter), "Morse Complex", { "no triangle", "Fuzzy Critical Points" });
  const auto other = complexOf(torusMesh(torusHeight()));
  other->SetPersistenceThreshold(2.0);
  expectFailure(other, update(other), "Morse Complex", { "PersistenceThreshold from 0 to 1" });
}

TEST(MorseComplexFilter, stops)
{
  const auto filter = complexOf(noisyTorus());
  expectNothingWhenStopped(filter, 0.0);
  expectSilentSuccess(update(filter));
}
