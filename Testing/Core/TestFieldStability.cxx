#include "FieldTruth.h"
#include "LocalFit.h"
#include "RadialBasisFit.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace SurfaceScalars
{
namespace
{

using Truth::FieldInput;
using Truth::parametersOf;

Values noise(Eigen::Index count, unsigned seed)
{
  Values result = Values::Zero(count);
  Truth::addNoise(result, 0.3, seed);
  return result;
}

// The average of exact values deviates from them by no more than twice the largest (the paper has
// once, which fails for values of both signs), and perturbed values move it by no more than the
// largest perturbation.
TEST(FieldStability, average)
{
  const FieldInput input = Truth::torusInput(1000, 1);
  const Values perturbation = noise(1000, 2);
  const Field field = Field::fit(input.points, input.values, parametersOf(Scheme::ExplicitMLS));
  const FieldParameters same = field.model().parameters; // noise would ask for more neighbors
  const Field perturbed = Field::fit(input.points, input.values + perturbation, same);
  const Points targets = Truth::randomPlaces(500, 1.5, 3);
  const Values change = perturbed.evaluate(targets, {}).values - field.evaluate(targets, {}).values;
  EXPECT_LE(change.cwiseAbs().maxCoeff(), perturbation.cwiseAbs().maxCoeff());
  const Values deviation = field.evaluate(input.points, {}).values - input.values;
  EXPECT_LE(deviation.cwiseAbs().maxCoeff(), 2.0 * input.values.cwiseAbs().maxCoeff());
}

// (16), in which the paper lost B Theta: |r - r_e| <= |b(x, y)| |(B Theta B^T)^-1 B Theta e|.
TEST(FieldStability, polynomialOfDegreeTwo)
{
  const FieldInput input = Truth::torusInput(30, 4);
  WeightedSamples samples{ 0.1 * input.points, input.values, Values(30) };
  samples.points.row(2) *= 0.1;
  samples.weights = (-100.0 * samples.points.colwise().squaredNorm().transpose()).array().exp();
  WeightedSamples perturbed = samples;
  const Values perturbation = noise(30, 5);
  perturbed.values += perturbation;
  LocalFit exact;
  LocalFit moved;
  ASSERT_TRUE(exact.compute(Vector3d::Zero(), samples, 1.0, 2));
  ASSERT_TRUE(moved.compute(Vector3d::Zero(), perturbed, 1.0, 2));

  const auto terms = [](const Vector2d& uv)
  {
    Eigen::Matrix<double, 6, 1> b;
    b << 1.0, uv.x(), uv.y(), uv.x() * uv.x(), uv.x() * uv.y(), uv.y() * uv.y();
    return b;
  };
  Eigen::MatrixXd b(6, 30);
  for (Eigen::Index i = 0; i < 30; ++i)
  {
    b.col(i) = terms(exact.flatten(samples.points.col(i)));
  }
  const Eigen::MatrixXd weighted = b * samples.weights.asDiagonal();
  const Values coefficients =
    (weighted * b.transpose()).ldlt().solve(Values(weighted * perturbation));
  for (const Vector2d& uv : { Vector2d(0.0, 0.0), Vector2d(0.05, -0.1), Vector2d(0.2, 0.1) })
  {
    const double change = moved.value(uv).value - exact.value(uv).value;
    EXPECT_LE(std::abs(change), terms(uv).norm() * coefficients.norm() * (1.0 + 1e-9));
    EXPECT_NEAR(change, terms(uv).dot(coefficients), 1e-9);
  }
}

// (17) for the radial part: |F_e - F| <= C sqrt(k) |e| / lambda_min(A), C the largest |phi|.
TEST(FieldStability, radialSum)
{
  const FieldInput input = Truth::torusInput(32, 6);
  for (const double width : { 0.1, 0.3, 0.6 })
  {
    const RadialKernel kernel(KernelType::Gaussian, width);
    Eigen::MatrixXd matrix(32, 32);
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
    {
      matrix.data()[i] = kernel.value((input.points.col(i % 32) - input.points.col(i / 32)).norm());
    }
    const double smallest =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
        .eigenvalues()[0];
    const Values perturbation = noise(32, 7);
    RadialBasisFit fit;
    ASSERT_TRUE(fit.factor(input.points, kernel, 0.0));
    fit.solve(perturbation); // linear in the values: what they add
    const Points targets = Truth::randomPlaces(100, 1.5, 8);
    for (Eigen::Index i = 0; i < targets.cols(); ++i)
    {
      const Vector3d place = targets.col(i);
      const double polynomial = fit.tail()[0] + fit.tail().tail<3>().dot(place - fit.tailOrigin());
      EXPECT_LE(
        std::abs(fit.value(place) - polynomial), std::sqrt(32.0) * perturbation.norm() / smallest);
    }
  }
}

} // namespace
} // namespace SurfaceScalars
