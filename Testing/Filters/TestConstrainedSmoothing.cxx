// What vtkConstrainedSmoothing writes.

#include "MeshTest.h"

#include "vtkConstrainedSmoothing.h"
#include "vtkMeshCriticalPoints.h"

#include "vtkDoubleArray.h"
#include "vtkTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

using Filter = vtkConstrainedSmoothing;

vtkSmartPointer<Filter> smoothing(vtkDataObject* input, int method = Filter::FEATURE_PRESERVING)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputDataObject(input);
  filter->SetMethod(method);
  return filter;
}

/// The height of a torus with noise of a tenth of its range.
vtkSmartPointer<vtkPolyData> noisyHeight(unsigned seed = 1)
{
  const Values height = torusHeight();
  const double range = height.maxCoeff() - height.minCoeff();
  return torusMesh(height + 0.1 * range * noise(height.size(), seed));
}

Values resultOf(vtkPolyDataAlgorithm* filter, const char* name = "SmoothedScalars")
{
  const auto numbers = numbersOf(pointArray(filter, name));
  return Eigen::Map<const Values>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

Values column(Filter* filter, const char* name)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(2));
  const auto numbers = numbersOf(vtkDataArray::SafeDownCast(table->GetColumnByName(name)));
  return Eigen::Map<const Values>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

void expectRefusal(Filter* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Constrained Smoothing", parts);
}

/// 1 at some points of the torus, 0 elsewhere.
void addMask(vtkPolyData* mesh)
{
  Values mask = Values::Zero(mesh->GetNumberOfPoints());
  mask(3) = mask(400) = mask(800) = mask(1100) = 1.0;
  addArray<vtkDoubleArray>(mesh, "mask", mask);
}

} // namespace

// Of hundreds of critical points the four of the height are left, which the written values have
// when they are classified again.
TEST(ConstrainedSmoothingFilter, keepsFeaturesAndAddsNone)
{
  const auto filter = smoothing(noisyHeight());
  filter->SetPersistenceThreshold(0.1);
  expectSilentSuccess(update(filter));
  EXPECT_GT(fieldData(filter, "InputCriticalCounts")[1], 100.0);
  EXPECT_THAT(fieldData(filter, "OutputCriticalCounts"), ElementsAre(1, 2, 1));
  EXPECT_THAT(fieldData(filter, "EulerCharacteristic"), ElementsAre(0));

  vtkNew<vtkMeshCriticalPoints> again;
  again->SetInputConnection(filter->GetOutputPort());
  expectSilentSuccess(update(again));
  EXPECT_THAT(fieldData(again, "CriticalCounts"), ElementsAre(1, 2, 1));
  const auto expected = criticalPointsOf(again);
  const auto found = criticalPointsOf(filter);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(found[i].input, expected[i].input);
    EXPECT_EQ(found[i].type, expected[i].type);
    EXPECT_EQ(found[i].value, expected[i].value);
  }
}

// The counts are those of the values written, whatever the method.
TEST(ConstrainedSmoothingFilter, countsWhatItWrites)
{
  for (const int method : { 0, 1, 2, 3 })
  {
    const auto filter = smoothing(noisyHeight(), method);
    filter->SetPersistenceThreshold(0.1);
    EXPECT_TRUE(update(filter).succeeded);
    vtkNew<vtkMeshCriticalPoints> again;
    again->SetInputConnection(filter->GetOutputPort());
    expectSilentSuccess(update(again));
    EXPECT_EQ(fieldData(filter, "OutputCriticalCounts"), fieldData(again, "CriticalCounts"));
  }
}

// Smooth values are closer to the height than the noisy ones, and the error is that of the values.
TEST(ConstrainedSmoothingFilter, removesNoise)
{
  const auto mesh = noisyHeight();
  const auto filter = smoothing(mesh, Filter::TIKHONOV);
  expectSilentSuccess(update(filter));
  const Values noisy = resultOf(filter, "f");
  const Values smooth = resultOf(filter);
  const Values clean = torusHeight().array() + (noisy - torusHeight()).mean();
  EXPECT_LT((smooth - clean).norm(), 0.3 * (noisy - clean).norm());
  EXPECT_DOUBLE_EQ(
    fieldData(filter, "LInfinityError")[0], (smooth - noisy).lpNorm<Eigen::Infinity>());
  EXPECT_GT(fieldData(filter, "SobolevSeminorm")[0], 0.0);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "SmoothedScalars");
  EXPECT_FALSE(mesh->GetPointData()->HasArray("SmoothedScalars"));
}

// Epsilon is the one of the least GCV, unless it is given; then there is no curve to choose from.
TEST(ConstrainedSmoothingFilter, tabulatesWhatEpsilonWasChosenFrom)
{
  const auto filter = smoothing(noisyHeight(), Filter::TIKHONOV);
  expectSilentSuccess(update(filter));
  const Values epsilons = column(filter, "Epsilon");
  ASSERT_GT(epsilons.size(), 5);
  for (const char* name : { "Residual", "Seminorm", "GCV", "Curvature" })
  {
    EXPECT_EQ(column(filter, name).size(), epsilons.size()) << name;
  }
  const double chosen = fieldData(filter, "Epsilon")[0];
  EXPECT_GE(chosen, epsilons.minCoeff());
  EXPECT_LE(chosen, epsilons.maxCoeff());

  filter->SetEpsilonChoice(Filter::MANUAL);
  filter->SetEpsilon(2e6);
  expectSilentSuccess(update(filter));
  EXPECT_THAT(fieldData(filter, "Epsilon"), ElementsAre(2e6));
  EXPECT_EQ(column(filter, "Epsilon").size(), 0);
}

// Larger epsilons come closer to f.
TEST(ConstrainedSmoothingFilter, followsEpsilon)
{
  const auto filter = smoothing(noisyHeight(), Filter::TIKHONOV);
  filter->SetEpsilonChoice(Filter::MANUAL);
  double last = std::numeric_limits<double>::infinity();
  for (const double epsilon : { 1e2, 1e5, 1e8, 1e11 })
  {
    filter->SetEpsilon(epsilon);
    expectSilentSuccess(update(filter));
    const double error = (resultOf(filter) - resultOf(filter, "f")).norm();
    EXPECT_LT(error, last);
    last = error;
  }
}

// Marked points keep their values exactly.
TEST(ConstrainedSmoothingFilter, interpolatesMarkedPoints)
{
  const auto mesh = noisyHeight();
  addMask(mesh);
  const auto filter = smoothing(mesh, Filter::INTERPOLATING_CONSTRAINTS);
  filter->SetConstraints(Filter::MASK_ARRAY);
  filter->SetConstraintArray("mask");
  filter->IncludeOneStarsOff();
  EXPECT_STREQ(filter->GetConstraintArray(), "mask");
  expectSilentSuccess(update(filter));
  for (const Eigen::Index marked : { 3, 400, 800, 1100 })
  {
    EXPECT_NEAR(resultOf(filter)(marked), resultOf(filter, "f")(marked), 1e-9);
  }
}

// Results do not depend on what was done before: other values, parameters and places.
TEST(ConstrainedSmoothingFilter, remembersNothingButTheMesh)
{
  const auto used = smoothing(noisyHeight(), Filter::TIKHONOV);
  const auto moved = noisyHeight();
  moved->GetPoints()->SetPoint(0, 1.5, 0.0, 0.1);
  const auto expectAsNew = [&](vtkPolyData* mesh)
  {
    used->SetInputData(mesh);
    expectSilentSuccess(update(used));
    const auto fresh = smoothing(mesh, used->GetMethod());
    fresh->SetEpsilonChoice(used->GetEpsilonChoice());
    fresh->SetEnergy(used->GetEnergy());
    expectSilentSuccess(update(fresh));
    EXPECT_EQ(resultOf(used), resultOf(fresh));
  };
  expectAsNew(noisyHeight(1));
  expectAsNew(noisyHeight(2));
  used->SetEpsilonChoice(Filter::MANUAL);
  expectAsNew(noisyHeight(2));
  used->SetEnergy(Filter::HARMONIC);
  expectAsNew(noisyHeight(2));
  expectAsNew(moved);
  expectAsNew(noisyHeight(1));
}

// All weights, metrics and energies are there.
TEST(ConstrainedSmoothingFilter, offersWeightsMetricsAndEnergies)
{
  const auto filter = smoothing(noisyHeight(), Filter::TIKHONOV);
  filter->SetEpsilonChoice(Filter::MANUAL);
  for (const int weights : { 3, 4, 5 })
  {
    for (const int metric : { 0, 1, 2 })
    {
      for (const int energy : { 0, 1 })
      {
        filter->SetWeights(weights);
        filter->SetMetric(metric);
        filter->SetEnergy(energy);
        expectSilentSuccess(update(filter));
        EXPECT_TRUE(resultOf(filter).allFinite());
        EXPECT_LT(fieldData(filter, "OutputCriticalCounts")[0],
          fieldData(filter, "InputCriticalCounts")[0]);
      }
    }
  }
}

// A peak that smoothing took is named by its point.
TEST(ConstrainedSmoothingFilter, saysWhichFeatureWasLost)
{
  Values values = torusHeight();
  values(600) += 0.8;
  const auto filter = smoothing(torusMesh(values));
  filter->SetEpsilonChoice(Filter::MANUAL);
  filter->SetPersistenceThreshold(0.1);
  expectWarning(update(filter),
    { "Constrained Smoothing: A persistent minimum or maximum of the input has no counterpart in "
      "the result: at point 600. Raise Epsilon" });
}

// Points that are left out get NaN.
TEST(ConstrainedSmoothingFilter, leavesMissingPointsOut)
{
  const auto mesh = noisyHeight();
  mesh->GetPointData()->GetScalars()->SetComponent(30, 0, NaN);
  const auto filter = smoothing(mesh, Filter::TIKHONOV);
  expectWarning(update(filter), { "Left out 1 of 1152 points" });
  const Values result = resultOf(filter);
  EXPECT_TRUE(std::isnan(result(30)));
  EXPECT_EQ(result.array().isNaN().count(), 1);
}

// The result can have the name of f, which is then renamed.
TEST(ConstrainedSmoothingFilter, namesTheResult)
{
  const auto filter = smoothing(noisyHeight(), Filter::TIKHONOV);
  filter->SetResultArrayName("f");
  expectWarning(update(filter), { "'fInput'" });
  EXPECT_NE(resultOf(filter, "f"), resultOf(filter, "fInput"));
  filter->SetResultArrayName("");
  expectSilentSuccess(update(filter));
  EXPECT_EQ(resultOf(filter).size(), 1152);
}

// A constant is as smooth as it can be.
TEST(ConstrainedSmoothingFilter, leavesConstantsAlone)
{
  const Values constant = Values::Constant(TorusGrid::Columns * TorusGrid::Rows, 3.0);
  for (const int method : { 0, 1, 2, 3 })
  {
    const auto filter = smoothing(torusMesh(constant), method);
    EXPECT_TRUE(update(filter).succeeded);
    EXPECT_TRUE(resultOf(filter).isApprox(constant, 1e-9));
  }
}

// Epsilon matters only where it is used.
TEST(ConstrainedSmoothingFilter, refusesEpsilonsThatAreNotPositive)
{
  for (const double epsilon : { 0.0, -1.0, NaN })
  {
    const auto filter = smoothing(noisyHeight(), Filter::TIKHONOV);
    filter->SetEpsilon(epsilon);
    expectSilentSuccess(update(filter));
    filter->SetEpsilonChoice(Filter::MANUAL);
    expectRefusal(filter, { "Epsilon above 0" });
  }
}

TEST(ConstrainedSmoothingFilter, refusesThresholdsThatAreNoFractions)
{
  const auto filter = smoothing(noisyHeight());
  filter->SetPersistenceThreshold(1.5);
  expectRefusal(filter, { "PersistenceThreshold", "1.5" });
  filter->SetPersistenceThreshold(0.0);
  filter->SetDelta(-0.5);
  expectRefusal(filter, { "Delta", "-0.5" });
}

TEST(ConstrainedSmoothingFilter, refusesMasksThatMarkNothing)
{
  const auto mesh = noisyHeight();
  addArray<vtkDoubleArray>(mesh, "zero", Values::Zero(mesh->GetNumberOfPoints()));
  const auto filter = smoothing(mesh, Filter::INTERPOLATING_CONSTRAINTS);
  filter->SetConstraints(Filter::MASK_ARRAY);
  expectRefusal(filter, { "ConstraintArray", "none" });
  filter->SetConstraintArray("f"); // what pvpython fills in
  expectRefusal(filter, { "other than the function's own array", "'f'" });
  filter->SetConstraintArray("nope");
  expectRefusal(filter, { "'nope'", "none of this name", "'zero'" });
  filter->SetConstraintArray("zero");
  expectRefusal(filter, { "ConstraintArray", "none" });
  vtkNew<vtkDoubleArray> shorter;
  shorter->SetName("short");
  shorter->SetNumberOfTuples(7);
  mesh->GetPointData()->AddArray(shorter);
  filter->SetConstraintArray("short");
  expectRefusal(filter, { "one value per point", "7 values for 1152 points" });
  filter->SetMethod(Filter::TIKHONOV); // which uses none
  expectSilentSuccess(update(filter));
}

TEST(ConstrainedSmoothingFilter, refusesNumbersThatNameNothing)
{
  const auto filter = smoothing(noisyHeight());
  filter->SetMethod(4);
  expectRefusal(filter, { "Method 0 (FeaturePreserving)", "found 4" });
  filter->SetMethod(0);
  filter->SetWeights(0);
  expectRefusal(filter, { "Weights 3 (Cotangent)", "found 0" });
}

TEST(ConstrainedSmoothingFilter, refusesPoints)
{
  expectRefusal(smoothing(makeCloud(TorusGrid::points(), torusHeight())),
    { "no triangle among 0 cells", "Fuzzy Critical Points" });
}

TEST(ConstrainedSmoothingFilter, stops)
{
  const auto filter = smoothing(noisyHeight());
  for (const double fraction : { 0.0, 0.3, 0.6 })
  {
    expectNothingWhenStopped(filter, fraction);
  }
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_EQ(resultOf(filter).size(), 1152);
}
