#include "Error.h"
#include "LaplacianFunctions.h"
#include "Queries.h"
#include "Sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

using testing::HasSubstr;
using Truth::nearest;

Laplacian localScale(const Points& points, int neighbors)
{
  return pointSetLaplacian(NeighborGraph(points, nearest(neighbors)), LaplacianWeights::LocalScale);
}

/// l (l + 1), each 2 l + 1 times.
Values sphereEigenvalues(int count)
{
  Values result(count);
  for (int l = 0, i = 0; i < count; ++l)
  {
    for (int m = 0; m <= 2 * l && i < count; ++m)
    {
      result[i++] = l * (l + 1);
    }
  }
  return result;
}

/// The smallest of (a pi / width)^2 + (b pi / height)^2, b even only and twice for b > 0 where the
/// height is a circumference.
Values rectangleEigenvalues(double width, double height, bool isCylinder, int count)
{
  std::vector<double> all;
  for (int a = 0; a < 20; ++a)
  {
    for (int b = 0; b < 20; ++b)
    {
      const double factor = isCylinder ? 2.0 : 1.0;
      const double value = std::pow(a * Pi / width, 2) + std::pow(factor * b * Pi / height, 2);
      all.insert(all.end(), isCylinder && b > 0 ? 2 : 1, value);
    }
  }
  std::sort(all.begin(), all.end());
  return Eigen::Map<Values>(all.data(), count);
}

/// The largest relative error of those that are not 0.
double relativeError(const Values& found, const Values& exact)
{
  const Eigen::Index count = found.size() - 1;
  return (found.tail(count) - exact.tail(count))
    .cwiseQuotient(exact.tail(count))
    .cwiseAbs()
    .maxCoeff();
}

/// F^T M F - identity, the residual |S f - lambda M f| over the largest lambda.
void expectSolution(const Laplacian& laplacian, const Eigenfunctions& result)
{
  const Eigen::MatrixXd& functions = result.functions;
  const Eigen::Index count = functions.cols();
  const Eigen::MatrixXd products = functions.transpose() * laplacian.mass.asDiagonal() * functions;
  EXPECT_LT((products - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff(), 1e-10);
  const Eigen::MatrixXd residuals = laplacian.stiffness * functions -
    laplacian.mass.asDiagonal() * functions * result.eigenvalues.asDiagonal();
  const Values roots = laplacian.mass.cwiseSqrt();
  EXPECT_LT((roots.cwiseInverse().asDiagonal() * residuals).colwise().norm().maxCoeff(),
    1e-5 * result.eigenvalues.maxCoeff() + 1e-10);
  EXPECT_TRUE(std::is_sorted(
    result.eigenvalues.data(), result.eigenvalues.data() + result.eigenvalues.size()));
}

class EigenvaluesOfSamples : public testing::TestWithParam<int>
{
};
INSTANTIATE_TEST_SUITE_P(Neighbors, EigenvaluesOfSamples, testing::Values(16, 32));

// The eigenvalues of the unit sphere are l (l + 1), with 2 l + 1 functions each; the scale of the
// stiffness makes no use of that.
TEST_P(EigenvaluesOfSamples, areThoseOfTheSphere)
{
  const Laplacian laplacian = localScale(Truth::randomSphere(20000, 1), GetParam());
  const Eigenfunctions result = laplacianEigenfunctions(laplacian, 16);
  expectSolution(laplacian, result);
  EXPECT_LT(relativeError(result.eigenvalues, sphereEigenvalues(16)), 0.05);
}

// A square's are those of Neumann's boundary condition.
TEST_P(EigenvaluesOfSamples, areThoseOfTheSquare)
{
  const Laplacian laplacian = localScale(Truth::randomPlane(20000, 2), GetParam());
  const Eigenfunctions result = laplacianEigenfunctions(laplacian, 12);
  expectSolution(laplacian, result);
  EXPECT_LT(relativeError(result.eigenvalues, rectangleEigenvalues(2, 2, false, 12)), 0.05);
}

// A cylinder is a rectangle with two of its sides joined: a sphere's scale would not do.
TEST_P(EigenvaluesOfSamples, areThoseOfTheCylinder)
{
  Truth::Random random(3);
  Points points(3, 20000);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    const double angle = random.uniform(0.0, 2 * Pi);
    points.col(i) = Vector3d(std::cos(angle), std::sin(angle), random.uniform(0.0, 3.0));
  }
  const Laplacian laplacian = localScale(points, GetParam());
  const Eigenfunctions result = laplacianEigenfunctions(laplacian, 12);
  EXPECT_LT(relativeError(result.eigenvalues, rectangleEigenvalues(3, 2 * Pi, true, 12)), 0.05);
}

// Nor does density matter, that varies from 1 to 4 between the poles.
TEST_P(EigenvaluesOfSamples, doNotDependOnTheDensity)
{
  Truth::Random random(5);
  const Points points = Truth::select(Truth::randomSphere(40000, 4),
    [&](const Vector3d& place) { return random.uniform() < std::pow(4.0, place.z() / 2 - 0.5); });
  const Laplacian laplacian = localScale(points, GetParam());
  const Eigenfunctions result = laplacianEigenfunctions(laplacian, 16);
  EXPECT_LT(relativeError(result.eigenvalues, sphereEigenvalues(16)), 0.05);
}

// On a square grid eigenvalues are double, exactly so; none is missed.
TEST(Eigenfunctions, ofASquareGridAreFoundTwice)
{
  const Laplacian laplacian = localScale(Truth::squareGrid(100, 0.01), 20);
  const Eigenfunctions result = laplacianEigenfunctions(laplacian, 15);
  expectSolution(laplacian, result);
  EXPECT_LT(relativeError(result.eigenvalues, rectangleEigenvalues(1, 1, false, 15)), 0.05);
}

// A connected surface has one eigenvalue 0, with the constant 1 / sqrt(area).
TEST(Eigenfunctions, beginWithTheConstant)
{
  for (const int count : { 200, 2000 }) // by a dense and by a sparse solver
  {
    const Laplacian laplacian = localScale(Truth::randomSphere(count, 6), 12);
    const Eigenfunctions result = laplacianEigenfunctions(laplacian, 4);
    expectSolution(laplacian, result);
    const double constant = 1.0 / std::sqrt(laplacian.mass.sum());
    EXPECT_EQ(result.eigenvalues[0], 0.0);
    EXPECT_NEAR(result.functions.col(0).minCoeff(), constant, 1e-15);
    EXPECT_EQ(result.functions.col(0).minCoeff(), result.functions.col(0).maxCoeff());
    EXPECT_NEAR(result.eigenvalues[1], 2.0, count < 300 ? 0.6 : 0.1);
  }
}

// There are as many eigenvalues 0 as components, then each of the others as often as copies of a
// surface.
TEST(Eigenfunctions, ofCopiesAreFoundForEach)
{
  const Points sphere = Truth::randomSphere(1500, 7);
  Points copies(3, 3 * sphere.cols());
  for (int i = 0; i < 3; ++i)
  {
    copies.middleCols(i * sphere.cols(), sphere.cols()) = sphere.colwise() + Vector3d(8 * i, 0, 0);
  }
  const Eigenfunctions one = laplacianEigenfunctions(localScale(sphere, 16), 4);
  const Laplacian laplacian = localScale(copies, 16);
  const Eigenfunctions all = laplacianEigenfunctions(laplacian, 12);
  expectSolution(laplacian, all);
  for (Eigen::Index i = 0; i < 12; ++i)
  {
    EXPECT_NEAR(all.eigenvalues[i], one.eigenvalues[i / 3], 1e-6);
  }
}

// The same numbers again, whoever listens: no random number, no thread matters.
TEST(Eigenfunctions, areTheSameAgain)
{
  const Laplacian laplacian = localScale(Truth::randomSphere(3000, 8), 16);
  const Eigenfunctions once = laplacianEigenfunctions(laplacian, 9);
  const Eigenfunctions again =
    laplacianEigenfunctions(laplacian, 9, { 1, [](double) { return true; } });
  EXPECT_EQ(once.functions, again.functions);
  for (Eigen::Index i = 0; i < 9; ++i)
  {
    Eigen::Index greatest = 0;
    once.functions.col(i).cwiseAbs().maxCoeff(&greatest);
    EXPECT_GT(once.functions(greatest, i), 0.0);
  }
}

// In another unit of length eigenvalues are those in 1 / length^2, functions those in 1 / length.
TEST(Eigenfunctions, doNotDependOnTheUnit)
{
  const Points points = Truth::randomSphere(2000, 8);
  const Eigenfunctions expected = laplacianEigenfunctions(localScale(points, 16), 6);
  for (const double unit : { std::ldexp(1.0, -60), std::ldexp(1.0, 60) })
  {
    const Eigenfunctions found = laplacianEigenfunctions(localScale(unit * points, 16), 6);
    EXPECT_TRUE((found.eigenvalues * unit * unit).isApprox(expected.eigenvalues, 1e-9)) << unit;
    EXPECT_TRUE((found.functions * unit).isApprox(expected.functions, 1e-4)) << unit;
  }
}

TEST(Eigenfunctions, checkTheirInput)
{
  Laplacian laplacian = localScale(Truth::randomSphere(500, 9), 12);
  const auto refusal = [&](int count)
  {
    try
    {
      laplacianEigenfunctions(laplacian, count);
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(0), HasSubstr("1 to 499"));
  EXPECT_THAT(refusal(500), HasSubstr("500"));
  laplacian.symmetric = false;
  EXPECT_THAT(refusal(4), HasSubstr("symmetric"));
}

// Whenever the listener says no, nothing is returned.
TEST(Eigenfunctions, canBeAborted)
{
  const Laplacian laplacian = localScale(Truth::randomSphere(5000, 10), 12);
  for (const double last : { 0.0, 0.1, 0.4, 0.5, 0.7 })
  {
    const Execution execution = { 0, [last](double fraction) { return fraction < last; } };
    EXPECT_THROW(laplacianEigenfunctions(laplacian, 6, execution), Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars
