#include "FitCovariance.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

// The covariance of gradient and Hessian is that of repeated fits to noise, within the uncertainty
// of these.
TEST(FitCovariance, isThatOfRepeatedFits)
{
  const int count = 80;
  const int repetitions = 2000;
  WeightedSamples samples{ randomPlane(count, 1), Values::Zero(count), Values::Zero(count) };
  for (int i = 0; i < count; ++i)
  {
    samples.weights[i] = std::pow(1.0 - 0.5 * samples.points.col(i).squaredNorm(), 2);
  }
  const Vector2d place(0.3, -0.2);
  LocalFit fit;
  FitCovariance covariance;
  Eigen::Matrix2d gradients = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d stated = Eigen::Matrix2d::Zero();
  Eigen::Matrix3d hessians = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d statedHessians = Eigen::Matrix3d::Zero();
  for (int i = 0; i < repetitions; ++i)
  {
    samples.values.setZero();
    addNoise(samples.values, 0.1, 100 + static_cast<unsigned>(i));
    ASSERT_TRUE(fit.compute(Vector3d::Zero(), samples, 1.5, 3));
    ASSERT_TRUE(covariance.compute(fit, samples));
    const Vector2d gradient = fit.value(place).gradient;
    const Eigen::Matrix2d hessian = fit.value(Vector2d::Zero()).hessian;
    const Vector3d elements(hessian(0, 0), hessian(0, 1), hessian(1, 1));
    gradients += gradient * gradient.transpose() / repetitions;
    hessians += elements * elements.transpose() / repetitions;
    stated += covariance.ofGradient(place) / repetitions;
    statedHessians += covariance.ofHessianAtCenter() / repetitions;
  }
  EXPECT_LT((stated - gradients).norm(), 0.1 * gradients.norm());
  EXPECT_LT((statedHessians - hessians).norm(), 0.1 * hessians.norm());
}
