#include "Error.h"
#include "FieldTruth.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>

namespace SurfaceScalars
{
namespace
{

using Truth::FieldInput;
using Truth::withHessian;

template <class Matrix>
void expectSameBits(const Matrix& a, const Matrix& b)
{
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(
    0, std::memcmp(a.data(), b.data(), sizeof(*a.data()) * static_cast<std::size_t>(a.size())));
}

void expectSameBits(const FieldValues& a, const FieldValues& b)
{
  expectSameBits(a.values, b.values);
  expectSameBits(a.gradients, b.gradients);
  expectSameBits(a.hessians, b.hessians);
  EXPECT_EQ(a.valid, b.valid);
}

// A model holds all of a field: what is made of it evaluates to the same bits, for any number of
// threads, whatever the order and duplicates of the input. So does a field with other values.
TEST(Field, modelEvaluatesToTheSameBits)
{
  FieldInput input = Truth::torusInput(1500, 1);
  input.points.array() += 1e3;
  input.points.rightCols(200) = input.points.leftCols(200); // with other values
  // Apart by less than the rounding errors of centering; they carry the bounding box.
  input.points.col(5) << 1e3 - 2.0, 1e3, 1e3;
  input.points.col(6) << std::nextafter(1e3 - 2.0, 2e3), 1e3, 1e3;
  const Points targets = Truth::randomPlaces(500, 1.5, 2).array() + 1e3;
  for (const FieldParameters& parameters : Truth::localSchemes())
  {
    SCOPED_TRACE(Truth::describe(parameters));
    const Field field = Field::fit(input.points, input.values, parameters, { 2, {} });
    const FieldValues values = field.evaluate(targets, withHessian(), { 2, {} });
    const Field copy(field.model(), { 1, {} });
    expectSameBits(values, copy.evaluate(targets, withHessian(), { 1, {} }));
    const Field other = Field::fit(input.points, Values::Ones(1500), parameters);
    expectSameBits(values, other.withValues(input.values).evaluate(targets, withHessian()));
  }
}

// What is known at a target depends on that target alone, not on the others nor on their order.
TEST(Field, targetsDoNotInfluenceEachOther)
{
  const FieldInput input = Truth::torusInput(2000, 3);
  const Points targets = Truth::randomPlaces(300, 1.5, 4);
  for (const FieldParameters& parameters : Truth::localSchemes())
  {
    SCOPED_TRACE(Truth::describe(parameters));
    const Field field = Field::fit(input.points, input.values, parameters);
    const FieldValues together = field.evaluate(targets, withHessian());
    for (Eigen::Index i = 0; i < 300; i += 13)
    {
      const FieldValues alone = field.evaluate(targets.col(i), withHessian());
      EXPECT_EQ(alone.values[0], together.values[i]);
      EXPECT_EQ(alone.hessians.col(0), together.hessians.col(i));
    }
  }
}

// So it is where targets share searches, being many, and where samples of a lattice are equally
// far, so that a neighborhood of k has to choose among them.
TEST(Field, closeTargetsDoNotInfluenceEachOther)
{
  constexpr int Side = 24;
  Points lattice(3, Side * Side);
  for (int i = 0; i < lattice.cols(); ++i)
  {
    lattice.col(i) << i % Side, i / Side, 0.0;
  }
  const Values values = lattice.row(0).array().square().sin();
  Points targets(3, 4 * lattice.cols());
  for (int i = 0; i < targets.cols(); ++i)
  {
    targets.col(i) << 0.5 * (i % (2 * Side)), 0.5 * (i / (2 * Side)), i % 3 == 0 ? 0.25 : 0.0;
  }
  for (const Scheme scheme : { Scheme::ExplicitMLS, Scheme::LocalRBF, Scheme::Hybrid })
  {
    for (const double radius : { 0.0, 2.0 })
    {
      FieldParameters parameters = Truth::parametersOf(scheme);
      parameters.neighborCount = 7;
      parameters.searchRadius = radius;
      SCOPED_TRACE(Truth::describe(parameters));
      const Field field = Field::fit(lattice, values, parameters);
      const FieldValues together = field.evaluate(targets, withHessian());
      for (Eigen::Index i = 0; i < targets.cols(); i += 7)
      {
        const FieldValues alone = field.evaluate(targets.col(i), withHessian());
        EXPECT_EQ(1, together.valid[static_cast<std::size_t>(i)]);
        EXPECT_EQ(alone.values[0], together.values[i]);
        EXPECT_EQ(alone.hessians.col(0), together.hessians.col(i));
      }
    }
  }
}

// f~ follows the samples when they are moved far away or measured in another unit.
TEST(Field, doesNotDependOnOriginAndUnit)
{
  const FieldInput input = Truth::torusInput(1000, 5);
  const Points targets = Truth::randomTorus(100, Truth::Torus::Closed, 6);
  for (FieldParameters parameters : Truth::localSchemes())
  {
    SCOPED_TRACE(Truth::describe(parameters));
    const FieldValues values =
      Field::fit(input.points, input.values, parameters).evaluate(targets, withHessian());
    const Points moved = input.points.array() + 4194304.0;
    const FieldValues far = Field::fit(moved, input.values, parameters)
                              .evaluate(targets.array() + 4194304.0, withHessian());
    parameters.searchRadius *= 1e-9;
    const FieldValues tiny = Field::fit(1e-9 * input.points, input.values, parameters)
                               .evaluate(1e-9 * targets, withHessian());
    EXPECT_LT((far.values - values.values).cwiseAbs().maxCoeff(), 1e-5);
    EXPECT_LT((tiny.values - values.values).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT((1e-9 * tiny.gradients - values.gradients).cwiseAbs().maxCoeff(), 1e-6);
  }
}

// Targets farther than asked for, or that are nowhere, are not valid and have the null value.
TEST(Field, marksTargetsOutside)
{
  const FieldInput input = Truth::torusInput(1000, 7);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = std::numeric_limits<double>::max();
  Points targets = Points::Zero(3, 6);
  targets.col(0) = input.points.col(0);
  targets.col(1) << 0.0, 0.0, 0.0; // 0.6 from the torus
  targets.col(2) << 1e3, 0.0, 0.0;
  targets.col(3) << nan, 0.0, 0.0;
  targets.col(4) << 0.0, -std::numeric_limits<double>::infinity(), 0.0;
  targets.col(5) << huge, -huge, huge;
  for (const FieldParameters& parameters : Truth::localSchemes())
  {
    SCOPED_TRACE(Truth::describe(parameters));
    const Field field = Field::fit(input.points, input.values, parameters);
    EvaluationParameters evaluation = withHessian();
    evaluation.nullValue = -7.0;
    evaluation.maximumDistance = 0.5;
    const FieldValues values = field.evaluate(targets, evaluation);
    EXPECT_EQ(values.valid, (std::vector<char>{ 1, 0, 0, 0, 0, 0 }));
    EXPECT_EQ(values.values.tail(5), Values::Constant(5, -7.0));
    EXPECT_TRUE((values.hessians.rightCols(5).array() == -7.0).all());

    evaluation.maximumDistance = 0.0;
    const FieldValues unlimited = field.evaluate(targets, evaluation);
    const char within = parameters.searchRadius > 0.0 ? 0 : 1;
    EXPECT_EQ(unlimited.valid, (std::vector<char>{ 1, within, within, 0, 0, 0 }));
    EXPECT_TRUE(unlimited.values.allFinite());
  }
}

// No targets, no values.
TEST(Field, acceptsNoTargets)
{
  const FieldInput input = Truth::torusInput(100, 8);
  const FieldValues values = Field::fit(input.points, input.values, {}).evaluate(Points(3, 0), {});
  EXPECT_EQ(values.values.size(), 0);
  EXPECT_TRUE(values.valid.empty());
}

// Clamped values stay within f's range, the others are untouched.
TEST(Field, clampsToTheRange)
{
  const FieldInput input = Truth::torusInput(300, 9);
  const Field field = Field::fit(input.points, input.values, {});
  const Points targets = Truth::randomPlaces(500, 2.0, 10);
  EvaluationParameters clamped;
  clamped.clampToRange = true;
  const double lowest = input.values.minCoeff();
  const double highest = input.values.maxCoeff();
  const Values free = field.evaluate(targets, {}).values;
  EXPECT_GT(free.maxCoeff(), highest);
  EXPECT_EQ(field.evaluate(targets, clamped).values, free.cwiseMax(lowest).cwiseMin(highest));
}

// A field stops soon after it is asked to, and says so.
TEST(Field, stopsOnRequest)
{
  const FieldInput input = Truth::torusInput(3000, 11);
  for (const int threads : { 1, 2 })
  {
    int calls = 0;
    const Execution execution{ threads, [&](double) { return ++calls < 8; } };
    EXPECT_THROW(Field::fit(input.points, input.values, {}, execution), Aborted);
    const Field field = Field::fit(input.points, input.values, {});
    calls = 0;
    EXPECT_THROW(field.evaluate(Truth::randomPlaces(100000, 1.5, 12), {}, execution), Aborted);
  }
}

// Progress never falls and ends at 1.
TEST(Field, reportsProgress)
{
  const FieldInput input = Truth::torusInput(3000, 13);
  double last = 0.0;
  bool falls = false;
  const Execution execution{ 2,
    [&](double fraction)
    {
      falls = falls || fraction < last;
      last = fraction;
      return true;
    } };
  const Field field = Field::fit(input.points, input.values, {}, execution);
  EXPECT_EQ(last, 1.0);
  last = 0.0;
  field.evaluate(input.points, {}, execution);
  EXPECT_EQ(last, 1.0);
  EXPECT_FALSE(falls);
}

// Places count, not samples, where samples at one place differ. New values are counted anew.
TEST(Field, CountsPlacesWhereSamplesContradict)
{
  Points points = Truth::randomTorus(100, Truth::Torus::Closed, 1);
  Values values = points.row(2);
  for (const int first : { 94, 97 }) // three places have three samples each
  {
    points.middleCols(first, 3) = points.leftCols(3);
    values.segment(first, 3) = values.head(3);
  }
  values[0] += 1.0;
  values[94] += 2.0; // at the same place
  values[98] += 1.0; // at the second of the three
  const Field field = Field::fit(points, values, FieldParameters());
  EXPECT_EQ(field.cloud().pointCount(), 94u);
  EXPECT_EQ(field.contradictionCount(), 2u);
  EXPECT_EQ(field.withValues(Values::Ones(100)).contradictionCount(), 0u);
}

} // namespace
} // namespace SurfaceScalars
