#include "Error.h"
#include "FieldTruth.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <functional>
#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

using Truth::FieldInput;
using Truth::parametersOf;

/// What is said about an input that is refused.
std::string refusal(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "accepted";
}

std::string refusal(const FieldInput& input, const FieldParameters& parameters)
{
  return refusal(
    [&]()
    {
      const Field field = Field::fit(input.points, input.values, parameters);
      field.evaluate(input.points, {});
    });
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// One sample says that f is constant; polynomials over a tangent plane need more.
TEST(FieldInput, oneSampleIsAConstant)
{
  const FieldInput one{ Vector3d(1.0, 2.0, 3.0), Values::Constant(1, 4.5) };
  const Points targets = Truth::randomPlaces(10, 5.0, 1);
  for (const Scheme scheme : { Scheme::ExplicitMLS, Scheme::LocalRBF, Scheme::Hybrid })
  {
    const Field field = Field::fit(one.points, one.values, parametersOf(scheme));
    const FieldValues values = field.evaluate(targets, Truth::withHessian());
    EXPECT_EQ(values.values, Values::Constant(10, 4.5));
    EXPECT_TRUE(values.gradients.isZero(0.0));
    EXPECT_TRUE(values.hessians.isZero(0.0));
    EXPECT_EQ(field.evaluate(one.points, {}).values[0], 4.5);
  }
  EXPECT_TRUE(contains(refusal(one, parametersOf(Scheme::ParameterizedMLS)),
    "needs at least 7 different points with a value to fit polynomials of degree 2, found 1"));
}

// Samples on a line determine no plane, but sums of radial functions: linear functions along it
// are reproduced, and do not change across it.
TEST(FieldInput, collinearSamples)
{
  FieldInput line{ Points(3, 50), Values(50) };
  const Vector3d along = Vector3d(1.0, 2.0, -1.0).normalized();
  for (Eigen::Index i = 0; i < 50; ++i)
  {
    line.points.col(i) = 0.1 * static_cast<double>(i) * along;
    line.values[i] = 3.0 + 0.2 * static_cast<double>(i);
  }
  const Field field = Field::fit(line.points, line.values, {});
  const Vector3d place = 2.345 * along + 0.1 * along.unitOrthogonal();
  EvaluationParameters gradient;
  gradient.derivatives = Derivatives::Gradient;
  const FieldValues values = field.evaluate(place, gradient);
  EXPECT_NEAR(values.values[0], 3.0 + 2.0 * 2.345, 1e-10);
  EXPECT_LT((values.gradients.col(0) - 2.0 * along).norm(), 1e-9);
  EXPECT_TRUE(
    contains(refusal(line, parametersOf(Scheme::ParameterizedMLS)), "50 points on one line"));
}

// Duplicates with equal values change nothing; with contradicting values their mean counts.
TEST(FieldInput, duplicates)
{
  const FieldInput input = Truth::torusInput(400, 2);
  const Points targets = Truth::randomPlaces(100, 1.5, 3);
  FieldInput twice{ Points(3, 800), Values(800) };
  twice.points << input.points, input.points;
  Values contradiction = Values::Constant(400, 0.25);
  for (const Scheme scheme :
    { Scheme::ExplicitMLS, Scheme::ParameterizedMLS, Scheme::LocalRBF, Scheme::Hybrid })
  {
    const FieldParameters parameters = parametersOf(scheme);
    const Values once =
      Field::fit(input.points, input.values, parameters).evaluate(targets, {}).values;
    twice.values << input.values, input.values;
    EXPECT_EQ(
      once, Field::fit(twice.points, twice.values, parameters).evaluate(targets, {}).values);
    twice.values << input.values + contradiction, input.values - contradiction;
    const Values mean =
      Field::fit(twice.points, twice.values, parameters).evaluate(targets, {}).values;
    EXPECT_LT((once - mean).cwiseAbs().maxCoeff(), 1e-10);
  }
}

// A width that makes systems singular is told with the condition and what to change, instead of
// numbers that are noise.
TEST(FieldInput, singularWidths)
{
  const FieldInput input = Truth::torusInput(1000, 4);
  for (const KernelType kernel : { KernelType::Gaussian, KernelType::InverseMultiquadric })
  {
    FieldParameters parameters = parametersOf(Scheme::LocalRBF, kernel);
    parameters.kernelWidth = 100.0;
    const std::string sentence = refusal(input, parameters);
    EXPECT_TRUE(contains(sentence, nameOf(kernel))) << sentence;
    EXPECT_TRUE(contains(sentence, "width 100")) << sentence;
    EXPECT_TRUE(contains(sentence, "condition")) << sentence;
    EXPECT_TRUE(contains(sentence, "Regularization")) << sentence;
    parameters.regularization = 1e-10;
    EXPECT_EQ(refusal(input, parameters), "accepted");
  }
}

// Values so small that they have few digits are refused for that, not for the kernel; those that
// are small only are not.
TEST(FieldInput, valuesWithFewDigits)
{
  FieldInput input{ Truth::randomPlaces(60, 1.0, 3), Values(60) };
  const Values waves = (3.0 * input.points.row(0)).array().sin();
  for (const KernelType kernel : { KernelType::Gaussian, KernelType::Cubic, KernelType::Wendland })
  {
    input.values = 1e-305 * waves;
    EXPECT_EQ(refusal(input, parametersOf(Scheme::GlobalRBF, kernel)), "accepted");
    input.values = 1e-318 * waves;
    const std::string sentence = refusal(input, parametersOf(Scheme::GlobalRBF, kernel));
    EXPECT_TRUE(contains(sentence, "Multiply them by a power of ten")) << sentence;
  }
}

// Samples that nearly coincide make systems of powers singular: no width helps, and none is
// advised.
TEST(FieldInput, nearlyCoincidentSamples)
{
  FieldInput input = Truth::torusInput(100, 6);
  input.points.col(7) = input.points.col(8) + Vector3d(0.0, 0.0, 1e-14);
  const std::string sentence = refusal(input, parametersOf(Scheme::LocalRBF, KernelType::Cubic));
  EXPECT_TRUE(contains(sentence, "nearly coincide")) << sentence;
  EXPECT_FALSE(contains(sentence, "Lower KernelWidth")) << sentence;
}

// Values so large that sums of them overflow are refused for that, not for the kernel.
TEST(FieldInput, refusesValuesThatOverflow)
{
  FieldInput input = Truth::torusInput(100, 5);
  input.values *= 1e307;
  for (const FieldParameters& parameters : Truth::localSchemes())
  {
    EXPECT_TRUE(contains(refusal(input, parameters), "values of 1e+300 at most"));
  }
  EXPECT_TRUE(contains(refusal(input, parametersOf(Scheme::GlobalRBF)), "power of ten"));
  input.values *= 1e-8;
  EXPECT_EQ(refusal(input, parametersOf(Scheme::GlobalRBF)), "accepted");
}

// What cannot be meant is refused in a sentence with the number.
TEST(FieldInput, refusesParameters)
{
  const FieldInput input = Truth::torusInput(100, 5);
  const auto with = [&](const std::function<void(FieldParameters&)>& change)
  {
    FieldParameters parameters;
    change(parameters);
    return refusal(input, parameters);
  };
  EXPECT_TRUE(contains(with([](auto& p) { p.neighborCount = -3; }), "NeighborCount"));
  EXPECT_TRUE(contains(with([](auto& p) { p.searchRadius = -1e-9; }), "-1e-09"));
  EXPECT_TRUE(contains(with([](auto& p) { p.kernelWidth = INFINITY; }), "inf"));
  EXPECT_TRUE(contains(with([](auto& p) { p.regularization = -1.0; }), "Regularization"));
  EXPECT_TRUE(contains(with([](auto& p) { p.kernel = KernelType::Harmonic; }), "Harmonic"));
  EXPECT_TRUE(contains(with([](auto& p) { p.scheme = Scheme::Linear; }), "schemes"));
  EXPECT_TRUE(contains(with(
                         [](auto& p)
                         {
                           p.scheme = Scheme::ParameterizedMLS;
                           p.polynomialDegree = 5;
                         }),
    "degree from 1 to 4, found 5"));
  EXPECT_TRUE(contains(with(
                         [](auto& p)
                         {
                           p.scheme = Scheme::ParameterizedMLS;
                           p.neighborCount = 6;
                         }),
    "at least 7, found 6"));
}

// So are values and points that are none, and models that do not fit together.
TEST(FieldInput, refusesSamplesAndModels)
{
  FieldInput input = Truth::torusInput(100, 6);
  FieldModel model = Field::fit(input.points, input.values, {}).model();
  model.coefficients.conservativeResize(99);
  EXPECT_TRUE(contains(refusal([&]() { Field{ model }; }), "99 for 100"));
  model = Field::fit(input.points, input.values, {}).model();
  model.centers.col(3) = model.centers.col(4);
  EXPECT_TRUE(contains(refusal([&]() { Field{ model }; }), "1 duplicates"));
  model.centers(0, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(refusal([&]() { Field{ model }; }), "finite"));

  input.values[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(refusal(input, {}), "finite values"));
  input.values.conservativeResize(50);
  EXPECT_TRUE(contains(refusal(input, {}), "50 values for 100 points"));
  EXPECT_TRUE(contains(refusal({ Points(3, 0), Values(0) }, {}), "needs points, found none"));
}

// A model whose numbers would overflow, or are none, is refused before it is used.
TEST(FieldInput, refusesHostileModels)
{
  const FieldInput input = Truth::torusInput(100, 7);
  for (const Scheme scheme :
    { Scheme::ExplicitMLS, Scheme::ParameterizedMLS, Scheme::LocalRBF, Scheme::Hybrid })
  {
    FieldParameters parameters = parametersOf(scheme);
    parameters.neighborCount = std::numeric_limits<int>::max();
    EXPECT_EQ(refusal(input, parameters), "accepted"); // the number of points counts
    FieldModel model = Field::fit(input.points, input.values, parametersOf(scheme)).model();
    model.parameters.neighborCount = std::numeric_limits<int>::max();
    EXPECT_TRUE(contains(refusal([&]() { Field{ model }; }), "100 centers, found 2147483647"));
  }
  FieldModel model =
    Field::fit(input.points, input.values, parametersOf(Scheme::GlobalRBF)).model();
  model.parameters.kernelWidth = 0.0;
  EXPECT_TRUE(contains(refusal([&]() { Field{ model }; }), "positive KernelWidth, found 0"));
}

// The Hybrid scheme asks at each sample, whatever its neighborhood costs, whether to go on, and
// refuses neighborhoods that LocalRBF would refuse before it looks at any.
TEST(FieldInput, hybridWithLargeNeighborhoods)
{
  const FieldInput input = Truth::torusInput(300, 8);
  FieldParameters parameters = parametersOf(Scheme::Hybrid);
  parameters.searchRadius = 10.0;
  int calls = 0;
  Field::fit(input.points, input.values, parameters, { 1, [&](double) { return ++calls > 0; } });
  EXPECT_GT(calls, 300);
  const int last = calls - 100; // in the middle of a block
  calls = 0;
  EXPECT_THROW(Field::fit(input.points, input.values, parameters,
                 { 1, [&](double) { return ++calls < last; } }),
    Aborted);
  EXPECT_EQ(calls, last);
  EXPECT_TRUE(contains(refusal(Truth::torusInput(2001, 9), parameters),
    "at most 2000 samples in a neighborhood, found 2001"));
}

} // namespace
} // namespace SurfaceScalars
