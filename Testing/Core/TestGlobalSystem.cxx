#include "Error.h"
#include "Field.h"
#include "GlobalSystemTest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

using testing::HasSubstr;

double widthOf(KernelType kernel)
{
  return kernel == KernelType::Gaussian ? 0.5 : 1.2;
}

Values evaluate(const PointCloud& cloud, const GlobalSum& sum, const Points& places)
{
  const auto approximation = makeGlobalRBF({ cloud, sum.coefficients }, sum.kernel, sum.tail);
  return Truth::valuesOf([&](const Vector3d& place)
    { return approximation->jet(place, Derivatives::None).value; },
    places);
}

/// The largest miss at the points of the cloud, relative to the range.
double missOf(const PointCloud& cloud, const GlobalSum& sum, const Values& values)
{
  return (evaluate(cloud, sum, cloud.points()) - values).lpNorm<Eigen::Infinity>() /
    (values.maxCoeff() - values.minCoeff());
}

// (9) with (10) as they stand, for every kernel, with and without regularization.
TEST(GlobalSystem, equalsTheBorderedSystem)
{
  const PointCloud cloud(Truth::randomBox(80, 1));
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  const Points places = Truth::randomBox(20, 2);
  for (const KernelType kernel : Truth::interpolatingKernels())
  {
    for (const double regularization : { 0.0, 0.1 })
    {
      const FieldParameters parameters = parametersOf(kernel, widthOf(kernel), regularization);
      const GlobalSystem system({ cloud, values }, parameters, {});
      const Values found = evaluate(cloud, system.solve(values, {}), places);
      const double unit = kernel == KernelType::Linear ? widthOf(kernel) : 1.0; // of phi
      const Values truth = Truth::valuesOf(
        Truth::solveBordered(cloud.points(), system.kernel(), unit * regularization, values),
        places);
      EXPECT_LT((found - truth).lpNorm<Eigen::Infinity>(), 1e-9) << static_cast<int>(kernel);
    }
  }
}

// The sparse, iterative solution is the dense, direct one.
TEST(GlobalSystem, sparseEqualsDense)
{
  const PointCloud cloud(Truth::randomTorus(1600, Truth::Torus::Closed, 3));
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  const double support = supportOf(cloud, 40);
  const Points places = Truth::randomTorus(50, Truth::Torus::Closed, 4);
  for (const KernelType kernel : { KernelType::Wendland, KernelType::Wu })
  {
    for (const double regularization : { 0.0, 0.01 })
    {
      const FieldParameters parameters = parametersOf(kernel, support, regularization);
      const GlobalSum sparse = GlobalSystem({ cloud, values }, parameters, {}).solve(values, {});
      RadialBasisFit dense;
      ASSERT_TRUE(dense.factor(cloud.points(), sparse.kernel, regularization));
      dense.solve(values);
      const Values truth =
        Truth::valuesOf([&](const Vector3d& p) { return dense.value(p); }, places);
      EXPECT_LT((evaluate(cloud, sparse, places) - truth).lpNorm<Eigen::Infinity>(), 1e-9);
    }
  }
}

// Without regularization the samples are returned to 1e-10 of the range: dense and sparse, also on
// a plane, with a large constant beside a small variation.
TEST(GlobalSystem, interpolates)
{
  for (const Points& points : { Truth::randomTorus(1500, Truth::Torus::Closed, 5),
         Truth::randomPlane(1500, 6), Truth::randomBox(1500, 7) })
  {
    const PointCloud cloud(points);
    const Values values = 1e-3 * Truth::valuesOf(Truth::wave, cloud.points()).array() + 20.0;
    for (const auto& [kernel, width] :
      { std::pair(KernelType::Cubic, 1.0), std::pair(KernelType::Wendland, supportOf(cloud, 50)),
        std::pair(KernelType::Wendland, 1.0), std::pair(KernelType::Linear, 1.0) })
    {
      const GlobalSystem system({ cloud, values }, parametersOf(kernel, width), {});
      EXPECT_LT(missOf(cloud, system.solve(values, {}), values), 1e-10)
        << static_cast<int>(kernel) << " " << width;
    }
  }
}

// With a width chosen by itself too, for every kernel and whatever the number of points.
TEST(GlobalSystem, interpolatesWithAutomaticWidth)
{
  for (const int count : { 1, 2, 4, 5, 6, 30, 700 })
  {
    const PointCloud cloud(Truth::randomBox(count, 8));
    const Values values = Truth::valuesOf(Truth::wave, cloud.points());
    for (const KernelType kernel : Truth::interpolatingKernels())
    {
      const GlobalSystem system({ cloud, values }, parametersOf(kernel, 0.0), {});
      const GlobalSum sum = system.solve(values, {});
      const double tolerance = 1e-9 * (values.maxCoeff() - values.minCoeff()) + 1e-14;
      EXPECT_LT(
        (evaluate(cloud, sum, cloud.points()) - values).lpNorm<Eigen::Infinity>(), tolerance)
        << static_cast<int>(kernel) << " with " << count << " points, width "
        << system.kernel().width();
    }
  }
}

// Gradient and Hessian are those of the value, for a dense and a compactly supported sum.
TEST(GlobalSystem, derivativesEqualDifferences)
{
  const PointCloud cloud(Truth::randomBox(300, 9));
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  for (const KernelType kernel : { KernelType::Multiquadric, KernelType::Wendland })
  {
    const GlobalSystem system({ cloud, values }, parametersOf(kernel, 0.6), {});
    const GlobalSum sum = system.solve(values, {});
    const auto field = makeGlobalRBF({ cloud, sum.coefficients }, sum.kernel, sum.tail);
    const Vector3d place(0.11, -0.32, 0.23);
    const FieldJet jet = field->jet(place, Derivatives::Hessian);
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3d step = 1e-5 * Vector3d::Unit(axis);
      const FieldJet after = field->jet(place + step, Derivatives::Gradient);
      const FieldJet before = field->jet(place - step, Derivatives::Gradient);
      EXPECT_NEAR(jet.gradient[axis], (after.value - before.value) / 2e-5, 1e-6);
      EXPECT_LT((jet.hessian.col(axis) - (after.gradient - before.gradient) / 2e-5).norm(),
        1e-6 * (1.0 + jet.hessian.norm()));
    }
  }
}

// A second function on the same points is interpolated as if it were the first, bit for bit; and
// the number of threads does not change a bit.
TEST(GlobalSystem, equalsAFreshOneBitForBit)
{
  const PointCloud cloud(Truth::randomTorus(1500, Truth::Torus::Closed, 10));
  const Values first = Truth::valuesOf(Truth::wave, cloud.points());
  const Values second = first.array().square() - cloud.points().row(2).transpose().array();
  for (const FieldParameters& parameters : { parametersOf(KernelType::Cubic, 1.0),
         parametersOf(KernelType::Wendland, supportOf(cloud, 40)) })
  {
    const GlobalSystem kept({ cloud, first }, parameters, { 1, {} });
    kept.solve(first, { 1, {} });
    const GlobalSum again = kept.solve(second, { 1, {} });
    const GlobalSystem fresh({ cloud, second }, parameters, { 2, {} });
    const GlobalSum anew = fresh.solve(second, { 2, {} });
    EXPECT_EQ(again.coefficients, anew.coefficients);
    EXPECT_EQ(again.tail, anew.tail);
  }
}

// As a field: it interpolates at the caller's points, further values cost a solution only and give
// the field that a fresh fit with that width gives, and the model evaluates to the same bits.
TEST(GlobalSystem, isAField)
{
  Points points = Truth::randomTorus(800, Truth::Torus::Closed, 17).colwise() + Vector3d(5, 6, 7);
  const Values values = Truth::valuesOf(Truth::wave, points);
  const Values others = values.array().square();
  const Points targets = Truth::randomBox(50, 18).colwise() + Vector3d(5, 6, 7);
  const EvaluationParameters all{ Derivatives::Hessian };
  for (const KernelType kernel :
    { KernelType::Cubic, KernelType::Multiquadric, KernelType::Wendland })
  {
    const Field field = Field::fit(points, values, parametersOf(kernel, 0.0));
    EXPECT_LT((field.evaluate(points, {}).values - values).lpNorm<Eigen::Infinity>(), 1e-9);
    const FieldValues expected = field.evaluate(targets, all);
    const FieldValues reread = Field(field.model()).evaluate(targets, all);
    EXPECT_EQ(expected.values, reread.values);
    EXPECT_EQ(expected.gradients, reread.gradients);
    EXPECT_EQ(expected.hessians, reread.hessians);

    const double width = field.model().parameters.kernelWidth;
    const Field next = field.withValues(others);
    const Field fresh = Field::fit(points, others, parametersOf(kernel, width));
    EXPECT_EQ(next.evaluate(targets, all).values, fresh.evaluate(targets, all).values);
    EXPECT_EQ(next.model().parameters.kernelWidth, width);
  }
}

// The chosen width leaves no more error than any of a grid, measured by fitting without each.
TEST(GlobalSystem, automaticWidthLeavesTheLeastError)
{
  const PointCloud cloud(Truth::randomPlane(60, 11));
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  const auto bruteForce = [&](const RadialKernel& kernel)
  {
    double sum = 0.0;
    for (Eigen::Index left = 0; left < 60; ++left)
    {
      Points others(3, 59);
      others << cloud.points().leftCols(left), cloud.points().rightCols(59 - left);
      Values rest(59);
      rest << values.head(left), values.tail(59 - left);
      RadialBasisFit fit;
      if (!fit.factor(others, kernel, 0.0) || fit.reciprocalCondition() < 1e-12)
      {
        return std::numeric_limits<double>::infinity();
      }
      fit.solve(rest);
      sum += std::pow(fit.value(cloud.points().col(left)) - values[left], 2);
    }
    return sum;
  };
  for (const KernelType kernel : { KernelType::Gaussian, KernelType::Exponential,
         KernelType::InverseMultiquadric, KernelType::Wendland })
  {
    const GlobalSystem system({ cloud, values }, parametersOf(kernel, 0.0), {});
    const double chosen =
      bruteForce({ kernel, 0.99 * system.kernel().width() }); // well conditioned
    for (double width = 0.1; width < 6.0; width *= 1.2)
    {
      EXPECT_LE(chosen, 1.1 * bruteForce({ kernel, width }))
        << static_cast<int>(kernel) << ": " << system.kernel().width() << " against " << width;
    }
  }
}

// Every width reproduces constants and linear functions, up to rounding errors that say nothing:
// the width is a wide one, with which other values would be smooth between the samples.
TEST(GlobalSystem, linearFunctionsGetAWideKernel)
{
  const PointCloud cloud(Truth::randomBox(300, 21));
  const Values constant = Values::Constant(300, 0.1);
  const Values linear = cloud.points().transpose() * Vector3d(0.3, -0.7, 0.1);
  for (const KernelType kernel : { KernelType::Wendland, KernelType::Multiquadric })
  {
    for (const Values& values : { constant, linear })
    {
      const GlobalSystem system({ cloud, values }, parametersOf(kernel, 0.0), {});
      EXPECT_GT(system.kernel().width(), supportOf(cloud, 40)) << nameOf(kernel);
    }
  }
}

// Few samples always have leave-one-out errors; where many do not, the advice gives a dense system.
TEST(GlobalSystem, leavesOneOutOfDenseSystemsOnly)
{
  const PointCloud few(Truth::randomBox(900, 22));
  const Values values = Truth::valuesOf(Truth::wave, few.points());
  const GlobalSystem dense(
    { few, values }, parametersOf(KernelType::Wendland, supportOf(few, 10)), {});
  EXPECT_EQ(dense.leaveOneOutErrors(values).size(), 900);

  const PointCloud many(Truth::randomBox(1500, 23));
  const Values others = Truth::valuesOf(Truth::wave, many.points());
  const GlobalSystem sparse(
    { many, others }, parametersOf(KernelType::Wendland, supportOf(many, 10)), {});
  try
  {
    sparse.leaveOneOutErrors(others);
    ADD_FAILURE() << "not refused";
  }
  catch (const InvalidInput& refusal)
  {
    EXPECT_THAT(refusal.what(),
      AllOf(HasSubstr("Wendland"), HasSubstr("Raise KernelWidth"), Not(HasSubstr("fewer"))));
  }
  const GlobalSystem wide({ many, others }, parametersOf(KernelType::Wendland, 0.8), {});
  EXPECT_EQ(wide.leaveOneOutErrors(others).size(), 1500);
}

// An abort is heard while the width is chosen, in dense and in sparse work.
TEST(GlobalSystem, canBeAborted)
{
  const PointCloud cloud(Truth::randomTorus(2000, Truth::Torus::Closed, 15));
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  for (const FieldParameters& parameters :
    { parametersOf(KernelType::Gaussian, 0.0), parametersOf(KernelType::Cubic, 1.0),
      parametersOf(KernelType::Wendland, supportOf(cloud, 40)) })
  {
    for (const int after : { 0, 5, 20 })
    {
      int calls = 0;
      const Execution execution{ 2, [&](double) { return ++calls <= after; } };
      EXPECT_THROW(GlobalSystem({ cloud, values }, parameters, execution), Aborted);
    }
  }
}

// Progress grows from 0 to 1 and never falls.
TEST(GlobalSystem, progressDoesNotFall)
{
  const PointCloud cloud(Truth::randomTorus(1500, Truth::Torus::Closed, 16));
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  for (const FieldParameters& parameters : { parametersOf(KernelType::Gaussian, 0.0),
         parametersOf(KernelType::Wendland, supportOf(cloud, 40)) })
  {
    double last = 0.0;
    const Execution execution{ 2,
      [&](double fraction)
      {
        EXPECT_GE(fraction, last);
        EXPECT_LE(fraction, 1.0);
        last = fraction;
        return true;
      } };
    const GlobalSystem system({ cloud, values }, parameters, execution.part(0.0, 0.8));
    system.solve(values, execution.part(0.8, 1.0));
  }
}

} // namespace
} // namespace SurfaceScalars
