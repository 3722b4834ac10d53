#include "Error.h"
#include "RadialBasisFit.h"
#include "RadialTruth.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>

namespace SurfaceScalars
{
namespace
{

double rangeOf(const Values& values)
{
  return values.maxCoeff() - values.minCoeff();
}

RadialBasisFit fitOf(const Points& centers, const RadialKernel& kernel, const Values& values,
  double regularization = 0.0)
{
  RadialBasisFit fit;
  EXPECT_TRUE(fit.factor(centers, kernel, regularization)) << static_cast<int>(kernel.type());
  fit.solve(values);
  return fit;
}

/// A width with which 60 centers in the cube give a regular system.
RadialKernel kernelOf(KernelType type)
{
  return { type, type == KernelType::Gaussian ? 0.6 : 1.2 };
}

/// Some rotation and translation, so that nothing lies along the axes.
Points moved(const Points& points)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  return (turn * points).colwise() + Vector3d(3.0, -2.0, 1.0);
}

// The gradient of a sum of coefficients and values of the polynomial, by the values at the centers:
// the sum is linear in these. In space and in a plane, whose polynomials are fewer.
TEST(RadialBasisFit, dependsOnValuesAsItsGradientSays)
{
  Points plane = Truth::randomBox(40, 2);
  plane.row(2).setZero();
  for (const Points& centers : { Truth::randomBox(40, 1), plane })
  {
    const Values values = centers.row(0).array().sin() + centers.row(1).array().square();
    for (const KernelType kernel : { KernelType::Cubic, KernelType::Multiquadric })
    {
      for (const double regularization : { 0.0, 0.1 })
      {
        const RadialBasisFit fit = fitOf(centers, kernelOf(kernel), values, regularization);
        const Points places = Truth::randomBox(7, 3);
        const Values weights = places.row(0);
        const Values kernels = centers.row(1);
        const Values gradient =
          fit.dependsOnValues(kernels, fit.terms().at(places).transpose() * weights);
        double sum = kernels.dot(fit.coefficients());
        for (Eigen::Index i = 0; i < places.cols(); ++i)
        {
          sum += weights[i] *
            (fit.tail()[0] + fit.tail().tail<3>().dot(places.col(i) - fit.tailOrigin()));
        }
        EXPECT_NEAR(gradient.dot(values), sum, 1e-9 * (1.0 + std::abs(sum)));
      }
    }
  }
}

// (8): the fit goes through the values, for every kernel, in space, in a plane, on a line and with
// one to four centers.
TEST(RadialBasisFit, interpolates)
{
  Points plane = Truth::randomBox(40, 2);
  plane.row(2).setZero();
  Points line = Truth::randomBox(12, 3);
  line.bottomRows(2).setZero();
  std::vector<Points> clouds{ Truth::randomBox(60, 1), moved(plane), moved(line) };
  for (int count = 1; count <= 4; ++count)
  {
    clouds.push_back(Truth::randomBox(count, 4));
  }
  for (const KernelType type : Truth::interpolatingKernels())
  {
    for (const Points& centers : clouds)
    {
      const Values values = Truth::valuesOf(Truth::wave, centers);
      const RadialBasisFit fit = fitOf(centers, kernelOf(type), values);
      for (Eigen::Index i = 0; i < centers.cols(); ++i)
      {
        EXPECT_NEAR(fit.value(centers.col(i)), values[i], 1e-10 * std::max(rangeOf(values), 0.1))
          << static_cast<int>(type) << " with " << centers.cols();
      }
    }
  }
}

// Between the centers too it is the function of (9) and (10), solved as they stand.
TEST(RadialBasisFit, equalsTheBorderedSystem)
{
  const Points centers = Truth::randomBox(60, 5);
  const Values values = Truth::valuesOf(Truth::wave, centers);
  const Points places = Truth::randomBox(20, 6);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    for (const double regularization : { 0.0, 0.1 })
    {
      const RadialBasisFit fit = fitOf(centers, kernelOf(type), values, regularization);
      const double unit = type == KernelType::Linear ? kernelOf(type).width() : 1.0; // of phi
      const auto truth =
        Truth::solveBordered(centers, kernelOf(type), unit * regularization, values);
      for (Eigen::Index i = 0; i < places.cols(); ++i)
      {
        EXPECT_NEAR(fit.value(places.col(i)), truth(places.col(i)), 1e-9) << static_cast<int>(type);
      }
    }
  }
}

// A linear function is reproduced everywhere, whatever the kernel, also with regularization; in a
// plane, it is extended constantly away from it.
TEST(RadialBasisFit, reproducesLinearFunctions)
{
  const auto linear = [](const Vector3d& p) { return 3.0 + 2.0 * p.x() - p.y() + 0.5 * p.z(); };
  Points plane = Truth::randomBox(40, 7);
  plane.row(2).setZero();
  for (const KernelType type : Truth::interpolatingKernels())
  {
    for (const double regularization : { 0.0, 0.1 })
    {
      const Points centers = moved(Truth::randomBox(60, 8));
      const RadialBasisFit fit =
        fitOf(centers, kernelOf(type), Truth::valuesOf(linear, centers), regularization);
      const Vector3d far(9.0, 7.0, -5.0);
      const FieldJet jet = fit.jet(far, Derivatives::Hessian);
      EXPECT_NEAR(jet.value, linear(far), 1e-7);
      EXPECT_LT((jet.gradient - Vector3d(2.0, -1.0, 0.5)).norm(), 1e-7);
      EXPECT_LT(jet.hessian.norm(), 1e-7);

      const RadialBasisFit flat =
        fitOf(plane, kernelOf(type), Truth::valuesOf(linear, plane), regularization);
      EXPECT_NEAR(flat.value(Vector3d(0.3, 0.4, 0.0)), 3.0 + 0.6 - 0.4, 1e-8);
      EXPECT_LT((flat.tail().tail<3>() - Vector3d(2.0, -1.0, 0.0)).norm(), 1e-8);
    }
  }
}

// Gradient and Hessian are those of the value; at a center too, where the kernel has them.
TEST(RadialBasisFit, derivativesEqualDifferences)
{
  const Points centers = Truth::randomBox(60, 9);
  const Values values = Truth::valuesOf(Truth::wave, centers);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    const RadialBasisFit fit = fitOf(centers, kernelOf(type), values);
    const bool isSmooth = type != KernelType::Exponential && type != KernelType::Linear &&
      type != KernelType::ThinPlate && type != KernelType::Cubic && type != KernelType::Wendland &&
      type != KernelType::Wu;
    for (const Vector3d& place : { Vector3d(0.1, 0.2, -0.3), Vector3d(1.5, 0.2, 0.1),
           Vector3d(centers.col(7) + (isSmooth ? 0.0 : 0.05) * Vector3d(0.6, 0.0, 0.8)) })
    {
      const FieldJet jet = fit.jet(place, Derivatives::Hessian);
      EXPECT_NEAR(jet.value, fit.value(place), 1e-11);
      EXPECT_EQ(jet.gradient, fit.jet(place, Derivatives::Gradient).gradient);
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vector3d step = 1e-5 * Vector3d::Unit(axis);
        const double scale = 1.0 + jet.hessian.norm();
        EXPECT_NEAR(jet.gradient[axis], (fit.value(place + step) - fit.value(place - step)) / 2e-5,
          1e-6 * scale)
          << static_cast<int>(type);
        const Vector3d bend = fit.jet(place + step, Derivatives::Gradient).gradient -
          fit.jet(place - step, Derivatives::Gradient).gradient;
        EXPECT_LT((jet.hessian.col(axis) - bend / 2e-5).norm(), 1e-6 * scale)
          << static_cast<int>(type);
      }
    }
  }
}

// The more regularization, the farther from the values.
TEST(RadialBasisFit, regularizationSmooths)
{
  const Points centers = Truth::randomBox(60, 10);
  Values values = Truth::valuesOf(Truth::wave, centers);
  Truth::addNoise(values, 0.1, 1);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    double last = 0.0;
    for (const double regularization : { 1e-6, 1e-4, 1e-2, 1.0 })
    {
      const RadialBasisFit fit = fitOf(centers, kernelOf(type), values, regularization);
      const double residual =
        (Truth::valuesOf([&](const Vector3d& p) { return fit.value(p); }, centers) - values).norm();
      EXPECT_GT(residual, last) << static_cast<int>(type);
      last = residual;
    }
  }
}

// The errors of leaving one out equal those of fitting anew without each, also where the
// polynomial lacks a direction, and with regularization.
TEST(RadialBasisFit, leaveOneOutEqualsFittingWithout)
{
  Points plane = Truth::randomBox(25, 11);
  plane.row(2).setZero();
  for (const KernelType type : Truth::interpolatingKernels())
  {
    for (const Points& centers : { Truth::randomBox(30, 12), plane })
    {
      for (const double regularization : { 0.0, 0.05 })
      {
        const Values values = Truth::valuesOf(Truth::wave, centers);
        const Values errors =
          fitOf(centers, kernelOf(type), values, regularization).leaveOneOutErrors();
        for (Eigen::Index left = 0; left < centers.cols(); ++left)
        {
          const Eigen::Index last = centers.cols() - 1;
          Points others = centers.leftCols(last);
          Values rest = values.head(last);
          if (left < last)
          {
            others.col(left) = centers.col(last);
            rest[left] = values[last];
          }
          const RadialBasisFit without = fitOf(others, kernelOf(type), rest, regularization);
          EXPECT_NEAR(errors[left], values[left] - without.value(centers.col(left)), 1e-8)
            << static_cast<int>(type);
        }
      }
    }
  }
}

// Also for the sample without which the polynomial loses a direction, or that leaves one alone.
TEST(RadialBasisFit, leaveOneOutWhereATermIsLost)
{
  Points centers = Truth::randomBox(60, 16);
  centers.row(2).setZero();
  centers(2, 17) = 0.5;
  const Values values = Truth::valuesOf(Truth::wave, centers);
  Points others = centers;
  others.col(17) = centers.col(59);
  Values rest = values;
  rest[17] = values[59];
  const RadialKernel cubic(KernelType::Cubic, 1.0);
  const RadialBasisFit without = fitOf(others.leftCols(59), cubic, rest.head(59));
  const Values errors = fitOf(centers, cubic, values).leaveOneOutErrors();
  EXPECT_NEAR(errors[17], values[17] - without.value(centers.col(17)), 1e-10);

  const Values two =
    fitOf(centers.leftCols(2), cubic, Eigen::Vector2d(1.0, 4.0)).leaveOneOutErrors();
  EXPECT_NEAR(two[0], -3.0, 1e-12);
  EXPECT_NEAR(two[1], 3.0, 1e-12);
  EXPECT_THROW(fitOf(centers.leftCols(1), cubic, values.head(1)).leaveOneOutErrors(), InvalidInput);
}

// Leaving one out ends soon after it is asked to, and does not depend on the threads.
TEST(RadialBasisFit, leaveOneOutRunsAsItIsTold)
{
  const RadialKernel cubic(KernelType::Cubic, 1.0);
  const Points centers = Truth::randomBox(300, 17);
  const RadialBasisFit fit = fitOf(centers, cubic, Truth::valuesOf(Truth::wave, centers));
  EXPECT_EQ(fit.leaveOneOutErrors(), fit.leaveOneOutErrors({ 3, {} }));
  EXPECT_THROW(fit.leaveOneOutErrors({ 1, [](double) { return false; } }), Aborted);
}

// The regularization of the Linear kernel has no unit: in millimeters, the fit is the same.
TEST(RadialBasisFit, regularizationHasNoUnit)
{
  const Points centers = Truth::randomBox(60, 18);
  const Values values = Truth::valuesOf(Truth::wave, centers);
  const Vector3d place(0.1, 0.2, -0.3);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    const double meters = fitOf(centers, { type, 0.5 }, values, 0.1).value(place);
    EXPECT_NEAR(fitOf(1e3 * centers, { type, 5e2 }, values, 0.1).value(1e3 * place), meters, 1e-9)
      << nameOf(type);
  }
}

// Samples of a plane with noise do not say how f changes away from it.
TEST(RadialBasisFit, noiseMakesNoSlope)
{
  for (const double noise : { 1e-5, 1e-4 })
  {
    Points centers = Truth::randomBox(40, 19);
    centers.row(2) *= noise;
    const Values values = Truth::valuesOf(Truth::wave, centers);
    const RadialBasisFit fit = fitOf(centers, { KernelType::Cubic, 1.0 }, values);
    EXPECT_LT(std::abs(fit.tail()[3]), 1e-2);
    EXPECT_LT(std::abs(fit.value(Vector3d(0.1, 0.2, 0.5))), 2.0);
  }
}

// The residual is that of the values, and rounding alone makes it.
TEST(RadialBasisFit, boundsItsResidual)
{
  const Points centers = Truth::randomBox(60, 20);
  const Values values = Truth::valuesOf(Truth::wave, centers);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    const RadialBasisFit fit = fitOf(centers, kernelOf(type), values);
    EXPECT_LE(fit.largestResidual(), fit.residualBound()) << nameOf(type);
    EXPECT_GT(fitOf(centers, kernelOf(type), values, 0.1).largestResidual(), 1e-4) << nameOf(type);
  }
}

// The condition estimate is within a factor of 100 of the truth in the null space of the
// polynomials, from well to badly conditioned.
TEST(RadialBasisFit, estimatesTheCondition)
{
  const Points centers = Truth::randomBox(50, 13);
  const Eigen::MatrixXd basis = Truth::orthogonalTo(Truth::linearTerms(centers));
  for (const KernelType type : Truth::interpolatingKernels())
  {
    for (const double width : { 0.3, 0.6, 1.2 })
    {
      const RadialKernel kernel(type, width);
      RadialBasisFit fit;
      if (!fit.factor(centers, kernel, 0.0) || fit.reciprocalCondition() < 1e-13)
      {
        continue; // beyond what doubles can tell
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
        kernel.sign() * (basis.transpose() * Truth::kernelMatrix(centers, kernel) * basis));
      const double truth = eigen.eigenvalues()[0] / eigen.eigenvalues().tail<1>()[0];
      EXPECT_LT(fit.reciprocalCondition(), 100.0 * truth) << static_cast<int>(type);
      EXPECT_GT(fit.reciprocalCondition(), 0.01 * truth) << static_cast<int>(type);
    }
  }
}

// Systems that are singular at machine precision are told from those that are not.
TEST(RadialBasisFit, refusesSingularSystems)
{
  RadialBasisFit fit;
  EXPECT_FALSE(fit.factor(Truth::randomBox(60, 14), { KernelType::Gaussian, 20.0 }, 0.0));
  EXPECT_LT(fit.reciprocalCondition(), 1e-14);
  Points twins = Truth::randomBox(20, 15);
  twins.col(11) = twins.col(3) + Vector3d(0.0, 0.0, 1e-14);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    if (type != KernelType::Linear && type != KernelType::Exponential) // regular as 1 / distance
    {
      EXPECT_FALSE(fit.factor(twins, kernelOf(type), 0.0)) << static_cast<int>(type);
    }
  }
  EXPECT_TRUE(fit.factor(twins, { KernelType::Gaussian, 20.0 }, 1e-6)); // and it can be used again
}

} // namespace
} // namespace SurfaceScalars
