#include "Error.h"
#include "FieldTruth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace SurfaceScalars
{
namespace
{

using Truth::FieldInput;
using Truth::localSchemes;
using Truth::parametersOf;

/// The step balances the differences' own error against rounding.
void expectDerivatives(const FieldApproximation& approximation, const Vector3d& place, double step)
{
  const FieldJet jet = approximation.jet(place, Derivatives::Hessian);
  Vector3d gradient;
  Eigen::Matrix3d hessian;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3d shift = step * Vector3d::Unit(axis);
    const FieldJet after = approximation.jet(place + shift, Derivatives::Gradient);
    const FieldJet before = approximation.jet(place - shift, Derivatives::Gradient);
    gradient[axis] = (after.value - before.value) / (2.0 * step);
    hessian.col(axis) = (after.gradient - before.gradient) / (2.0 * step);
  }
  EXPECT_LT((jet.gradient - gradient).norm(), 1e-6 * (1.0 + gradient.norm()));
  EXPECT_LT((jet.hessian - hessian).norm(), 1e-6 * (1.0 + hessian.norm()));
}

// Gradient and Hessian are those of the value, by central differences with the neighborhood and its
// frame frozen, on and off the surface.
TEST(FieldSchemes, derivativesAreExact)
{
  const FieldInput input = Truth::torusInput(1000, 1);
  for (const FieldParameters& parameters : localSchemes())
  {
    SCOPED_TRACE(Truth::describe(parameters));
    const Field field = Field::fit(input.points, input.values, parameters);
    const auto approximation = field.approximation();
    const Points places = Truth::randomTorus(10, Truth::Torus::Closed, 2) * 1.03;
    for (Eigen::Index i = 0; i < places.cols(); ++i)
    {
      ASSERT_TRUE(approximation->center(places.col(i)));
      expectDerivatives(*approximation, places.col(i), 1e-5);
    }
  }
}

// Without regularization, sums of radial functions go through the samples, with every kernel.
TEST(FieldSchemes, interpolate)
{
  const FieldInput input = Truth::torusInput(2000, 3);
  const double range = input.values.maxCoeff() - input.values.minCoeff();
  for (const KernelType kernel : Truth::interpolatingKernels())
  {
    SCOPED_TRACE(nameOf(kernel));
    const Field field =
      Field::fit(input.points, input.values, parametersOf(Scheme::LocalRBF, kernel));
    const Values values = field.evaluate(input.points, {}).values;
    EXPECT_LT((values - input.values).cwiseAbs().maxCoeff(), 1e-10 * range);
  }
}

// Noise too: a width that is chosen interpolates it, a given one does or is refused.
TEST(FieldSchemes, interpolateNoiseOrRefuse)
{
  FieldInput input = Truth::torusInput(500, 16);
  input.values.setZero();
  Truth::addNoise(input.values, 1.0, 17);
  const double range = input.values.maxCoeff() - input.values.minCoeff();
  const auto largestMiss = [&](const FieldParameters& parameters)
  {
    const Field field = Field::fit(input.points, input.values, parameters);
    return (field.evaluate(input.points, {}).values - input.values).cwiseAbs().maxCoeff();
  };
  for (const KernelType kernel : Truth::interpolatingKernels())
  {
    SCOPED_TRACE(nameOf(kernel));
    FieldParameters parameters = parametersOf(Scheme::LocalRBF, kernel);
    parameters.neighborCount = 32;
    EXPECT_LT(largestMiss(parameters), 1e-9 * range);
    for (const double width : { 0.5, 1.0, 2.0, 3.0, 4.0 })
    {
      parameters.kernelWidth = width;
      try
      {
        EXPECT_LT(largestMiss(parameters), 1e-5 * range) << width;
      }
      catch (const InvalidInput&)
      {
      }
    }
  }
}

// Between scattered stations with values that jump, no kernel is far worse than the cubic one.
TEST(FieldSchemes, chosenWidthsSuitScatteredStations)
{
  const Points stations = Truth::randomPlane(400, 18);
  Values values = Truth::valuesOf(
    [](const Vector3d& p) { return std::sin(3.0 * p.x()) * std::cos(4.0 * p.y()); }, stations);
  Truth::addNoise(values, 0.1, 19);
  const auto error = [&](KernelType kernel)
  {
    FieldParameters parameters = parametersOf(Scheme::LocalRBF, kernel);
    parameters.neighborCount = 32;
    const Field field = Field::fit(stations.leftCols(100), values.head(100), parameters);
    return (field.evaluate(stations.rightCols(300), {}).values - values.tail(300)).norm();
  };
  const double cubic = error(KernelType::Cubic);
  for (const KernelType kernel : Truth::interpolatingKernels())
  {
    EXPECT_LT(error(kernel), 2.0 * cubic) << nameOf(kernel);
  }
}

// Linear functions are reproduced everywhere by the sums with a linear polynomial.
TEST(FieldSchemes, reproduceLinearFunctions)
{
  const auto linear = [](const Vector3d& p) { return 1e3 + p.dot(Vector3d(1.0, -2.0, 0.5)); };
  const Points points = Truth::randomTorus(1000, Truth::Torus::Closed, 4);
  const Points targets = Truth::randomPlaces(200, 1.5, 5);
  for (const KernelType kernel : Truth::interpolatingKernels())
  {
    SCOPED_TRACE(nameOf(kernel));
    const Field field =
      Field::fit(points, Truth::valuesOf(linear, points), parametersOf(Scheme::LocalRBF, kernel));
    const FieldValues values = field.evaluate(targets, Truth::withHessian());
    EXPECT_LT((values.values - Truth::valuesOf(linear, targets)).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(values.hessians.cwiseAbs().maxCoeff(), 1e-6);
  }
}

// On a plane, polynomials of its degree are reproduced by ParameterizedMLS, constants by the
// average.
TEST(FieldSchemes, reproducePolynomialsOnAPlane)
{
  const Points points = Truth::randomPlane(500, 6);
  const Points targets = 0.8 * Truth::randomPlane(100, 7);
  for (const int degree : { 1, 2, 3, 4 })
  {
    const auto polynomial = [=](const Vector3d& p)
    { return 5.0 + std::pow(p.x() - 0.5 * p.y(), degree); };
    FieldParameters parameters = parametersOf(Scheme::ParameterizedMLS);
    parameters.polynomialDegree = degree;
    const Values values = Field::fit(points, Truth::valuesOf(polynomial, points), parameters)
                            .evaluate(targets, {})
                            .values;
    EXPECT_LT((values - Truth::valuesOf(polynomial, targets)).cwiseAbs().maxCoeff(), 1e-10);
  }
  const Field constant =
    Field::fit(points, Values::Constant(500, 0.1), parametersOf(Scheme::ExplicitMLS));
  EXPECT_EQ(constant.evaluate(targets, {}).values, Values::Constant(100, 0.1));
}

// The average (6) with a given radius and width is the weighted mean of all samples within.
TEST(FieldSchemes, explicitMLSIsTheWeightedMean)
{
  const FieldInput input = Truth::torusInput(2000, 8);
  FieldParameters parameters = parametersOf(Scheme::ExplicitMLS);
  parameters.searchRadius = 0.2;
  parameters.kernelWidth = 0.08;
  const Points targets = Truth::randomTorus(100, Truth::Torus::Closed, 9);
  const Values values =
    Field::fit(input.points, input.values, parameters).evaluate(targets, {}).values;
  for (Eigen::Index i = 0; i < targets.cols(); ++i)
  {
    double weights = 0.0;
    double sum = 0.0;
    for (Eigen::Index j = 0; j < input.points.cols(); ++j)
    {
      const double squared = (input.points.col(j) - targets.col(i)).squaredNorm();
      const double weight = squared < 0.2 * 0.2 ? std::exp(-squared / (0.08 * 0.08)) : 0.0;
      weights += weight;
      sum += weight * input.values[j];
    }
    EXPECT_NEAR(values[i], sum / weights, 1e-13);
  }
}

// Far from all samples the average is still one: weights that all underflow are as good as any.
TEST(FieldSchemes, averagesFarAway)
{
  const FieldInput input = Truth::torusInput(500, 10);
  FieldParameters parameters = parametersOf(Scheme::ExplicitMLS);
  parameters.kernelWidth = 0.01;
  const FieldValues values = Field::fit(input.points, input.values, parameters)
                               .evaluate(Vector3d(1e3, 1.0, 0.0), Truth::withHessian());
  EXPECT_EQ(values.valid[0], 1);
  EXPECT_GE(values.values[0], input.values.minCoeff());
  EXPECT_LE(values.values[0], input.values.maxCoeff());
}

// Hybrid is LocalRBF where the average misses the samples around, ExplicitMLS elsewhere: one
// everywhere for a threshold of 0, the other for a large one.
TEST(FieldSchemes, hybridIsOneOfBoth)
{
  const FieldInput input = Truth::torusInput(1000, 14);
  const Points targets = Truth::randomTorus(300, Truth::Torus::Closed, 15);
  const auto valuesWith = [&](Scheme scheme, double threshold)
  {
    FieldParameters parameters = parametersOf(scheme);
    parameters.neighborCount = 32;
    parameters.hybridThreshold = threshold;
    return Field::fit(input.points, input.values, parameters).evaluate(targets, {}).values;
  };
  const Values average = valuesWith(Scheme::ExplicitMLS, 0.0);
  const Values interpolant = valuesWith(Scheme::LocalRBF, 0.0);
  EXPECT_EQ(valuesWith(Scheme::Hybrid, 0.0), interpolant);
  EXPECT_EQ(valuesWith(Scheme::Hybrid, 1.0), average);
  const Values mixed = valuesWith(Scheme::Hybrid, 0.03);
  const auto isAverage = mixed.array() == average.array();
  EXPECT_TRUE((isAverage || mixed.array() == interpolant.array()).all());
  EXPECT_GT(isAverage.count(), 30);
  EXPECT_LT(isAverage.count(), 270);
}

} // namespace
} // namespace SurfaceScalars
