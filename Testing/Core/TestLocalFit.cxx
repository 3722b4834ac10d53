#include "LocalFit.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>

namespace SurfaceScalars
{
namespace
{

using Function = std::function<double(const Vector3d&)>;

/// All points as samples of equal weight.
WeightedSamples samplesOf(const Points& points, const Function& function)
{
  WeightedSamples samples{ points, Values(points.cols()), Values::Ones(points.cols()) };
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    samples.values[i] = function(points.col(i));
  }
  return samples;
}

Vector3d differences(const Function& function, const Vector3d& place)
{
  Vector3d result;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3d shift = 1e-5 * Vector3d::Unit(axis);
    result[axis] = (function(place + shift) - function(place - shift)) / 2e-5;
  }
  return result;
}

/// Some rotation, so that no axis of the frame is one of space.
Eigen::Matrix3d rotation()
{
  return Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
}

// On a plane, however it lies, polynomials of the fit's degree are reproduced: value and gradient
// up to rounding, anywhere.
TEST(LocalFit, reproducesPolynomialsOnAPlane)
{
  const Points points = rotation() * Truth::randomPlane(200, 1);
  const Vector3d u = rotation().col(0);
  const Vector3d v = rotation().col(1);
  for (const int degree : { 1, 2, 3, 4 })
  {
    const Function polynomial = [=](const Vector3d& p)
    { return 2.0 + std::pow(0.8 * p.dot(u) - 0.5 * p.dot(v) + 0.1, degree); };
    const Vector3d center = 0.2 * u - 0.1 * v;
    LocalFit fit;
    ASSERT_TRUE(fit.compute(center, samplesOf(points, polynomial), 1.5, degree));
    for (const Vector2d& uv : { Vector2d(0.0, 0.0), Vector2d(0.3, -0.4) })
    {
      const Vector3d place = fit.lift(uv);
      EXPECT_NEAR(place.dot(rotation().col(2)), 0.0, 1e-13);
      EXPECT_NEAR(fit.value(uv).value, polynomial(place), 1e-11) << degree;
      EXPECT_NEAR(fit.height(uv).value, 0.0, 1e-12);
      const Vector3d normal = rotation().col(2);
      const Vector3d gradient = differences(polynomial, place);
      EXPECT_LT((fit.gradient(uv) - (gradient - gradient.dot(normal) * normal)).norm(), 1e-8);
      EXPECT_NEAR(std::abs(fit.normal(uv).dot(normal)), 1.0, 1e-12);
    }
  }
}

// The Hessian is that of the polynomial, expressed in the frame.
TEST(LocalFit, hessianIsExactForQuadratics)
{
  const Eigen::Matrix2d hessian = (Eigen::Matrix2d() << 3.0, -1.0, -1.0, 0.5).finished();
  const Function quadratic = [=](const Vector3d& p)
  { return 0.5 * p.head<2>().dot(hessian * p.head<2>()) + p.x(); };
  LocalFit fit;
  ASSERT_TRUE(
    fit.compute(Vector3d::Zero(), samplesOf(Truth::randomPlane(100, 2), quadratic), 1.5, 2));
  const Eigen::Matrix2d axes = fit.frame().topLeftCorner<2, 2>();
  EXPECT_LT(
    (axes * fit.value(Vector2d::Zero()).hessian * axes.transpose() - hessian).norm(), 1e-11);
}

// lift and flatten are inverse to each other on the surface; the frame is orthonormal and
// right-handed or left-handed, never skew.
TEST(LocalFit, liftAndFlattenAreInverse)
{
  const Points points = 0.1 * Truth::randomPlane(100, 3);
  Points paraboloid = points;
  paraboloid.row(2) = 0.5 * points.colwise().squaredNorm();
  LocalFit fit;
  const Function height = [](const Vector3d& p) { return p.x(); };
  ASSERT_TRUE(fit.compute(paraboloid.col(5), samplesOf(paraboloid, height), 0.2, 2));
  EXPECT_LT((fit.frame().transpose() * fit.frame() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  const Vector2d uv(0.03, -0.02);
  EXPECT_LT((fit.flatten(fit.lift(uv)) - uv).norm(), 1e-14);
  EXPECT_LT((fit.flatten(fit.center() + fit.frame().col(2))).norm(), 1e-14);
}

// On a sphere the fitted height has both curvatures 1, the normal is radial, and f's gradient is
// its tangential part.
TEST(LocalFit, knowsTheSphere)
{
  const Vector3d center = Vector3d(0.3, -0.5, 0.8).normalized();
  const Points cap = Truth::select(
    Truth::randomSphere(200000, 4), [=](const Vector3d& p) { return (p - center).norm() < 0.05; });
  const Vector3d direction(1.0, 0.4, -0.2);
  const Function height = [=](const Vector3d& p) { return direction.dot(p); };
  LocalFit fit;
  ASSERT_TRUE(fit.compute(center, samplesOf(cap, height), 0.05, 2));
  const Vector2d zero = Vector2d::Zero();
  EXPECT_NEAR(std::abs(fit.normal(zero).dot(center)), 1.0, 1e-6);
  EXPECT_NEAR(std::abs(fit.height(zero).hessian.trace()), 2.0, 0.01);
  EXPECT_NEAR(fit.height(zero).hessian.determinant(), 1.0, 0.01);
  const Vector3d tangential = direction - direction.dot(center) * center;
  EXPECT_LT((fit.gradient(zero) - tangential).norm(), 1e-3);
  EXPECT_NEAR(fit.value(zero).value, direction.dot(center), 1e-5);
}

// Samples of weight 0 do not count: moved anywhere, the fit is the same.
TEST(LocalFit, ignoresSamplesWithoutWeight)
{
  const Function height = [](const Vector3d& p) { return std::sin(p.x()) + p.y(); };
  WeightedSamples samples = samplesOf(Truth::randomPlane(60, 5), height);
  samples.weights.tail(20).setZero();
  LocalFit fit;
  ASSERT_TRUE(fit.compute(Vector3d::Zero(), samples, 1.5, 2));
  const double before = fit.value(Vector2d(0.1, 0.2)).value;
  samples.values.tail(20).setConstant(1e6);
  samples.points.rightCols(20).setConstant(7.0);
  ASSERT_TRUE(fit.compute(Vector3d::Zero(), samples, 1.5, 2));
  EXPECT_NEAR(fit.value(Vector2d(0.1, 0.2)).value, before, 1e-12);
}

// The residuals' deviation estimates the noise without bias: corrected for the number of unknowns.
TEST(LocalFit, deviationEstimatesTheNoise)
{
  double heightSum = 0.0;
  double valueSum = 0.0;
  const int repetitions = 400;
  for (int i = 0; i < repetitions; ++i)
  {
    WeightedSamples samples =
      samplesOf(Truth::randomPlane(30, 6u + i), [](const Vector3d& p) { return p.x(); });
    Truth::Random random(1000u + i);
    for (Eigen::Index j = 0; j < 30; ++j)
    {
      samples.points(2, j) = 0.01 * random.normal();
      samples.values[j] += 0.3 * random.normal();
    }
    LocalFit fit;
    ASSERT_TRUE(fit.compute(Vector3d::Zero(), samples, 1.5, 2));
    heightSum += std::pow(fit.heightDeviation(samples), 2);
    valueSum += std::pow(fit.valueDeviation(samples), 2);
  }
  EXPECT_NEAR(std::sqrt(heightSum / repetitions), 0.01, 0.0005);
  EXPECT_NEAR(std::sqrt(valueSum / repetitions), 0.3, 0.015);
}

// Too few samples, or samples on a line, determine no polynomial: compute says so.
TEST(LocalFit, refusesDegenerateSamples)
{
  const Function height = [](const Vector3d& p) { return p.x(); };
  LocalFit fit;
  for (const int degree : { 1, 2, 3, 4 })
  {
    const int tooFew = LocalFit::termCount(degree) - 1;
    EXPECT_FALSE(
      fit.compute(Vector3d::Zero(), samplesOf(Truth::randomPlane(tooFew, 7), height), 1.5, degree));
    Points line = Truth::randomPlane(40, 8);
    line.row(1).setZero();
    EXPECT_FALSE(fit.compute(Vector3d::Zero(), samplesOf(line, height), 1.5, degree));
    EXPECT_FALSE(
      fit.compute(Vector3d::Zero(), samplesOf(Points::Zero(3, 40), height), 1.5, degree));
  }
}

// Lengths scale: the fit of a scaled neighborhood is the scaled fit.
TEST(LocalFit, doesNotDependOnTheUnit)
{
  const Points points = Truth::randomPlane(50, 9);
  const Function wave = [](const Vector3d& p) { return std::sin(2.0 * p.x() + p.y()); };
  const WeightedSamples samples = samplesOf(points, wave);
  LocalFit fit;
  ASSERT_TRUE(fit.compute(Vector3d::Zero(), samples, 1.5, 3));
  for (const double scale : { 1e-9, 1e6 })
  {
    const WeightedSamples scaled{ scale * points, samples.values, samples.weights };
    LocalFit other;
    ASSERT_TRUE(other.compute(Vector3d::Zero(), scaled, 1.5 * scale, 3));
    const Vector3d gradient = other.gradient(Vector2d::Zero()) * scale;
    EXPECT_LT((gradient - fit.gradient(Vector2d::Zero())).norm(), 1e-9);
  }
}

} // namespace
} // namespace SurfaceScalars
