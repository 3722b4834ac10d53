// What vtkScalarFunctionDesign writes.

#include "DesignTest.h"

#include "vtkMeshCriticalPoints.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

using Filter = vtkScalarFunctionDesign;

vtkIdType columnsOfTable(Filter* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetNumberOfRows();
}

/// Expects what both outputs say to be what the written values are when they are classified again.
void expectCountsOfTheValues(Filter* filter, int eulerCharacteristic)
{
  vtkNew<vtkMeshCriticalPoints> again;
  again->SetInputConnection(filter->GetOutputPort());
  expectSilentSuccess(update(again));
  const auto expected = criticalPointsOf(again);
  const auto found = criticalPointsOf(filter);
  ASSERT_EQ(found.size(), expected.size());
  double prescribed = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].input, expected[i].input);
    EXPECT_EQ(found[i].type, expected[i].type);
    EXPECT_EQ(found[i].multiplicity, expected[i].multiplicity);
    EXPECT_EQ(found[i].value, expected[i].value);
    prescribed += numbersOf(pointArray(filter, "Prescribed", 1))[i];
  }
  for (const int port : { 0, 1 })
  {
    const auto counts = fieldData(filter, "CriticalCounts", port);
    EXPECT_EQ(counts, fieldData(again, "CriticalCounts"));
    EXPECT_EQ(counts[0] - counts[1] + counts[2], eulerCharacteristic);
    EXPECT_THAT(fieldData(filter, "EulerCharacteristic", port), ElementsAre(eulerCharacteristic));
    EXPECT_THAT(fieldData(filter, "Added", port),
      ElementsAre(static_cast<double>(found.size()) - prescribed));
  }
}

/// Whether the point is critical in the result as asked for, and known to be asked for.
bool isPrescribed(Filter* filter, vtkIdType id, CriticalType type, int multiplicity = 1)
{
  const auto found = criticalPointsOf(filter);
  const auto prescribed = numbersOf(pointArray(filter, "Prescribed", 1));
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i].input == static_cast<std::size_t>(id))
    {
      return found[i].type == type && found[i].multiplicity == multiplicity && prescribed[i] == 1.0;
    }
  }
  return false;
}

} // namespace

// A torus gets the minimum, two saddles and maximum that it has to have, and nothing else. The mesh
// is the input with the result, which are the active scalars.
TEST(ScalarFunctionDesign, hasWhatIsAskedFor)
{
  const auto mesh = plainTorus();
  const auto filter = design(mesh, naturalRequests());
  expectSilentSuccess(update(filter));
  expectCountsOfTheValues(filter, 0);
  EXPECT_TRUE(isPrescribed(filter, 0, CriticalType::Maximum));
  EXPECT_TRUE(isPrescribed(filter, 12 * 48, CriticalType::Saddle));
  EXPECT_TRUE(isPrescribed(filter, 12 * 48 + 24, CriticalType::Saddle));
  EXPECT_TRUE(isPrescribed(filter, 24, CriticalType::Minimum));
  EXPECT_THAT(fieldData(filter, "Missing"), ElementsAre(0));
  EXPECT_THAT(fieldData(filter, "Missing", 1), ElementsAre(0));
  EXPECT_THAT(fieldData(filter, "Added"), ElementsAre(0));
  EXPECT_THAT(fieldData(filter, "Epsilon"), ElementsAre(0));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "DesignedScalars");
  EXPECT_EQ(output->GetPolys(), mesh->GetPolys());
  EXPECT_EQ(columnsOfTable(filter), 0);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0);
  const auto split = numbersOf(output->GetCellData()->GetArray("Split"));
  EXPECT_EQ(split.size(), 2304u);
  EXPECT_EQ(std::count(split.begin(), split.end(), 0.0), 2304);
}

// Whatever the approach, the counts are those of the values written.
TEST(ScalarFunctionDesign, countsWhatItWrites)
{
  const std::vector<Asked> asked = { { torusPlace(3, 2), 3 }, { torusPlace(9, 5), 3 },
    { torusPlace(6, 3), 1 }, { torusPlace(30, 12), 0 } };
  for (const int approach : { 0, 1 })
  {
    for (const int constraints : { 0, 1 })
    {
      for (const bool cleanUp : { false, true })
      {
        const auto filter = design(plainTorus(), asked);
        filter->SetApproach(approach);
        filter->SetConstraintType(constraints);
        filter->SetCleanUp(cleanUp);
        ASSERT_TRUE(update(filter).succeeded);
        expectCountsOfTheValues(filter, 0);
        if (constraints == Filter::INTERPOLATING)
        {
          EXPECT_THAT(fieldData(filter, "Missing"), ElementsAre(0));
        }
      }
    }
  }
}

// Values that are given are met.
TEST(ScalarFunctionDesign, meetsGivenValues)
{
  std::vector<Asked> asked = naturalRequests();
  asked[0].value = 7.0;
  asked[1].value = 5.5;
  asked[3].value = -2.0;
  const auto filter = design(plainTorus(), asked);
  ASSERT_TRUE(update(filter).succeeded);
  const Values values = designedValues(filter);
  EXPECT_NEAR(values(0), 7.0, 1e-9);
  EXPECT_NEAR(values(12 * 48), 5.5, 1e-9);
  EXPECT_NEAR(values(24), -2.0, 1e-9);
}

// Without any pit, and with neighbors that peaks and pass share, the pass is below the peaks.
TEST(ScalarFunctionDesign, placesPassesBelowPeaks)
{
  for (const int approach : { 0, 1 })
  {
    const auto filter = design(
      plainTorus(), { { torusPlace(0, 0), 3 }, { torusPlace(4, 0), 3 }, { torusPlace(2, 0), 1 } });
    filter->SetApproach(approach);
    ASSERT_TRUE(update(filter).succeeded);
    EXPECT_THAT(fieldData(filter, "Missing"), ElementsAre(0));
    EXPECT_LE(designedValues(filter)(2), 0.95);
    EXPECT_NEAR(designedValues(filter)(0), 1.0, 1e-12);
  }
}

// Points go to the nearest vertex. Those of several blocks, of other cells or number types are the
// same points.
TEST(ScalarFunctionDesign, takesPointsOfAnyKind)
{
  std::vector<Asked> asked = naturalRequests();
  const auto exact = design(plainTorus(), asked);
  expectSilentSuccess(update(exact));
  for (Asked& each : asked)
  {
    each.place += Vector3d(0.01, -0.01, 0.01);
  }
  vtkNew<vtkUnstructuredGrid> first;
  first->ShallowCopy(criticalPoints({ asked[0], asked[1] }));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, first);
  blocks->SetBlock(2, criticalPoints({ asked[2], asked[3] }));
  const auto split = design(plainTorus(), blocks);
  expectSilentSuccess(update(split));
  EXPECT_EQ(designedValues(split), designedValues(exact));

  const auto bare = criticalPoints(asked);
  bare->GetPointData()->Initialize();
  addArray<vtkIntArray>(bare, "CriticalType", Values(Eigen::Vector4d(3, 1, 1, 0)));
  const auto integers = design(plainTorus(), bare);
  expectSilentSuccess(update(integers));
  EXPECT_EQ(designedValues(integers), designedValues(exact));
}

// What another filter found is asked for again: the result has the same critical points, with the
// same values.
TEST(ScalarFunctionDesign, takesTheCriticalPointsOfAFilter)
{
  vtkNew<vtkMeshCriticalPoints> critical;
  critical->SetInputData(torusMesh(torusHeight()));
  const auto filter = design(plainTorus(), nullptr);
  filter->SetCriticalPointsConnection(critical->GetOutputPort(1));
  expectSilentSuccess(update(filter));
  const auto asked = criticalPointsOf(critical);
  for (const CriticalPoint& point : asked)
  {
    EXPECT_TRUE(
      isPrescribed(filter, static_cast<vtkIdType>(point.input), point.type, point.multiplicity));
    EXPECT_NEAR(designedValues(filter)(static_cast<Eigen::Index>(point.input)), point.value, 1e-9);
  }
}

// Regular, uncertain and excluded points ask for nothing and are counted: the first output of a
// filter fits as well as its critical points.
TEST(ScalarFunctionDesign, leavesOutWhatAsksForNothing)
{
  std::vector<Asked> asked = naturalRequests();
  asked.push_back({ torusPlace(5, 5), 4 });
  asked.push_back({ torusPlace(6, 6), 5, 0.0 });
  asked.push_back({ Vector3d(NaN, 0, 0), -1, NaN });
  const auto filter = design(plainTorus(), asked);
  expectWarning(
    update(filter), { "Scalar Function Design: Left out 3 of 7 points of CriticalPoints" });
  EXPECT_THAT(fieldData(filter, "CriticalCounts"), ElementsAre(1, 2, 1));
}

// The critical points of a template are asked for, with their values.
TEST(ScalarFunctionDesign, importsATemplate)
{
  const auto filter = design(torusMesh(torusHeight()), nullptr);
  EXPECT_STREQ(filter->GetTemplateArray(), "");
  filter->SetTemplateArray("f");
  EXPECT_STREQ(filter->GetTemplateArray(), "f");
  expectSilentSuccess(update(filter));
  vtkNew<vtkMeshCriticalPoints> critical;
  critical->SetInputData(torusMesh(torusHeight()));
  critical->Update();
  for (const CriticalPoint& point : criticalPointsOf(critical))
  {
    EXPECT_TRUE(isPrescribed(filter, static_cast<vtkIdType>(point.input), point.type));
    EXPECT_NEAR(designedValues(filter)(static_cast<Eigen::Index>(point.input)), point.value, 1e-9);
  }
  EXPECT_THAT(fieldData(filter, "Missing"), ElementsAre(0));
}

// Of noise only what lasts is imported.
TEST(ScalarFunctionDesign, importsWhatLasts)
{
  const auto noisy = torusMesh(torusHeight() + 0.1 * noise(torusHeight().size()));
  const auto filter = design(noisy, nullptr);
  filter->SetTemplateArray("f");
  filter->SetPersistenceThreshold(0.3);
  ASSERT_TRUE(update(filter).succeeded);
  const auto prescribed = numbersOf(pointArray(filter, "Prescribed", 1));
  EXPECT_EQ(std::count(prescribed.begin(), prescribed.end(), 1.0), 4);
}

// A point wins against a critical point of the template at its place or one that shares a neighbor
// with it.
TEST(ScalarFunctionDesign, prefersPointsToTheTemplate)
{
  vtkNew<vtkMeshCriticalPoints> critical;
  critical->SetInputData(torusMesh(torusHeight()));
  critical->Update();
  const auto known = criticalPointsOf(critical);
  ASSERT_EQ(known.front().type, CriticalType::Maximum);
  const auto id = static_cast<int>(known.front().input);
  for (const int columns : { 0, 1, 2, 3 })
  {
    const auto filter = design(
      torusMesh(torusHeight()), { { torusPlace((id + columns) % 48, id / 48), 3, 1.0, 9.0 } });
    filter->SetTemplateArray("f");
    const Outcome outcome = update(filter);
    if (columns < 3)
    {
      expectWarning(outcome, { "Left out 1 of the template's 4 critical points" });
    }
    else
    {
      EXPECT_TRUE(outcome.succeeded);
    }
    const auto prescribed = numbersOf(pointArray(filter, "Prescribed", 1));
    EXPECT_EQ(std::count(prescribed.begin(), prescribed.end(), 1.0), columns < 3 ? 4 : 5);
  }
}

// Epsilon is chosen from a curve for LeastSquares, unless it is given.
TEST(ScalarFunctionDesign, tabulatesWhatEpsilonWasChosenFrom)
{
  const auto filter = design(plainTorus(), naturalRequests());
  filter->SetConstraintType(Filter::LEAST_SQUARES);
  ASSERT_TRUE(update(filter).succeeded);
  EXPECT_GT(columnsOfTable(filter), 5);
  EXPECT_GT(fieldData(filter, "Epsilon")[0], 0.0);
  filter->SetEpsilonChoice(Filter::MANUAL);
  filter->SetEpsilon(1e7);
  ASSERT_TRUE(update(filter).succeeded);
  EXPECT_EQ(columnsOfTable(filter), 0);
  EXPECT_THAT(fieldData(filter, "Epsilon"), ElementsAre(1e7));
}

// What least squares lose is named.
TEST(ScalarFunctionDesign, namesWhatIsMissing)
{
  std::vector<Asked> asked = naturalRequests();
  asked.push_back({ torusPlace(6, 3), 0, 1.0, 0.9 });
  asked[0].value = 1.0;
  asked[3].value = -1.0;
  const auto filter = design(plainTorus(), asked);
  filter->SetConstraintType(Filter::LEAST_SQUARES);
  filter->SetEpsilonChoice(Filter::MANUAL);
  filter->SetEpsilon(1e-3);
  expectWarning(
    update(filter), { " asked for", " not there in the result: ", "point 4 of CriticalPoints" });
  EXPECT_GE(fieldData(filter, "Missing")[0], 1.0);
}

// Results do not depend on what was done before.
TEST(ScalarFunctionDesign, remembersNothingButTheMesh)
{
  const auto used = design(plainTorus(), naturalRequests());
  const auto moved = plainTorus();
  moved->GetPoints()->SetPoint(5, 1.45, 0.0, 0.1);
  const auto expectAsNew = [&](vtkPolyData* mesh, const std::vector<Asked>& asked)
  {
    used->SetInputData(mesh);
    used->SetCriticalPointsData(criticalPoints(asked));
    ASSERT_TRUE(update(used).succeeded);
    const auto fresh = design(mesh, asked);
    fresh->SetEnergy(used->GetEnergy());
    ASSERT_TRUE(update(fresh).succeeded);
    const Values expected = designedValues(fresh);
    EXPECT_LE((designedValues(used) - expected).lpNorm<Eigen::Infinity>(),
      1e-9 * expected.lpNorm<Eigen::Infinity>());
  };
  std::vector<Asked> other = naturalRequests();
  other[0].place = torusPlace(2, 3);
  std::vector<Asked> multiple = other;
  multiple[1].multiplicity = 3.0;
  expectAsNew(plainTorus(), naturalRequests());
  expectAsNew(plainTorus(), other);
  expectAsNew(plainTorus(), multiple);
  used->SetEnergy(Filter::HARMONIC);
  expectAsNew(plainTorus(), multiple);
  expectAsNew(moved, other);
  expectAsNew(plainTorus(), naturalRequests());
}

// The result can have any name; an array of that name is renamed.
TEST(ScalarFunctionDesign, namesTheResult)
{
  const auto filter = design(torusMesh(torusHeight()), naturalRequests());
  filter->SetResultArrayName("f");
  expectWarning(update(filter), { "'fInput'" });
  EXPECT_NE(designedValues(filter, "f"), designedValues(filter, "fInput"));
  filter->SetResultArrayName("");
  expectSilentSuccess(update(filter));
  EXPECT_EQ(designedValues(filter).size(), 1152);
}

// Points in no triangle get NaN.
TEST(ScalarFunctionDesign, leavesOtherPointsOut)
{
  const auto mesh = plainTorus();
  const vtkIdType alone = mesh->GetPoints()->InsertNextPoint(5.0, 5.0, 5.0);
  const auto filter = design(mesh, naturalRequests());
  expectWarning(update(filter), { "1 of 1153 points are in no triangle and get NaN" });
  EXPECT_TRUE(std::isnan(designedValues(filter)(alone)));
  EXPECT_EQ(designedValues(filter).array().isNaN().count(), 1);
}

TEST(ScalarFunctionDesign, stops)
{
  const auto filter = design(plainTorus(), naturalRequests());
  for (const double fraction : { 0.0, 0.3, 0.6 })
  {
    expectNothingWhenStopped(filter, fraction);
  }
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_EQ(designedValues(filter).size(), 1152);
}
