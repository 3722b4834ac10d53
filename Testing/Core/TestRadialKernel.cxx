#include "Error.h"
#include "RadialKernel.h"
#include "RadialTruth.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

// phi' and phi'' are the derivatives of phi: equal to central differences, inside the support and
// outside.
TEST(RadialKernel, derivativesAreThoseOfTheValue)
{
  const double width = 0.7;
  for (const KernelType type : Truth::allKernels())
  {
    const RadialKernel kernel(type, width);
    for (const double radius : { 0.05, 0.2, 0.5, 0.6, 0.9, 2.0 })
    {
      const double step = 1e-5 * radius;
      const double below = kernel.value(radius - step);
      const double here = kernel.value(radius);
      const double above = kernel.value(radius + step);
      const KernelJet jet = kernel.jet(radius);
      const double scale = 0.1 * (1.0 + std::abs(here));
      EXPECT_EQ(jet.value, here);
      EXPECT_NEAR(
        jet.slopeOverRadius * radius, (above - below) / (2.0 * step), 1e-5 * scale / radius)
        << static_cast<int>(type) << " at " << radius;
      const KernelJet after = kernel.jet(radius + step);
      const KernelJet before = kernel.jet(radius - step);
      const double bend =
        after.slopeOverRadius * (radius + step) - before.slopeOverRadius * (radius - step);
      EXPECT_NEAR(jet.curvature, bend / (2.0 * step), 1e-5 * scale / (radius * radius))
        << static_cast<int>(type) << " at " << radius;
    }
  }
}

// Towards r = 0, value and derivatives tend to those that are given there, except for the
// derivatives of kernels with a tip or a logarithm, which are set to 0.
TEST(RadialKernel, limitsAtTheCenter)
{
  for (const KernelType type : Truth::interpolatingKernels())
  {
    const RadialKernel kernel(type, 0.7);
    const KernelJet center = kernel.jet(0.0);
    const KernelJet beside = kernel.jet(1e-9);
    EXPECT_NEAR(center.value, beside.value, 1e-7);
    EXPECT_EQ(center.slopeOverRadius, center.curvature);
    const bool hasTip = type == KernelType::Exponential || type == KernelType::Linear ||
      type == KernelType::ThinPlate;
    EXPECT_NEAR(hasTip ? 0.0 : beside.slopeOverRadius, center.slopeOverRadius, 1e-6);
    EXPECT_NEAR(hasTip ? 0.0 : beside.curvature, center.curvature, 1e-6);
  }
  EXPECT_EQ(
    RadialKernel(KernelType::Harmonic, 1.0).value(0.0), std::numeric_limits<double>::infinity());
}

// Wendland's and Wu's functions run into zero twice continuously differentiably at their width;
// that is their support, and nobody else has one.
TEST(RadialKernel, compactSupportEndsSmoothly)
{
  for (const KernelType type : Truth::allKernels())
  {
    const RadialKernel kernel(type, 0.7);
    if (type != KernelType::Wendland && type != KernelType::Wu)
    {
      EXPECT_EQ(kernel.support(), std::numeric_limits<double>::infinity());
      continue;
    }
    EXPECT_EQ(kernel.support(), 0.7);
    const KernelJet inside = kernel.jet(0.7 * (1.0 - 1e-6));
    EXPECT_GT(inside.value, 0.0);
    EXPECT_NEAR(inside.value, 0.0, 1e-12);
    EXPECT_NEAR(inside.slopeOverRadius, 0.0, 1e-12);
    EXPECT_NEAR(inside.curvature, 0.0, 1e-8);
    for (const double outside : { 0.7, 0.8, 1e9 })
    {
      const KernelJet jet = kernel.jet(outside);
      EXPECT_EQ(jet.value, 0.0);
      EXPECT_EQ(jet.slopeOverRadius, 0.0);
      EXPECT_EQ(jet.curvature, 0.0);
    }
  }
}

// The smallest eigenvalue of sign() times the kernel matrix is positive on the vectors orthogonal
// to the polynomials of degree < order(): in space, and with the polynomials of a plane in a plane.
TEST(RadialKernel, matrixIsConditionallyPositiveDefinite)
{
  const Points plane = Truth::randomPlane(40, 3);
  const Points space = Truth::randomBox(40, 4);
  for (const KernelType type : Truth::interpolatingKernels())
  {
    for (const Points& centers : { plane, space })
    {
      const RadialKernel kernel(type, 0.4);
      Eigen::MatrixXd matrix = kernel.sign() * Truth::kernelMatrix(centers, kernel);
      if (kernel.order() > 0)
      {
        const Eigen::MatrixXd terms =
          Truth::linearTerms(centers).leftCols(kernel.order() == 1 ? 1 : 4);
        const Eigen::MatrixXd basis = Truth::orthogonalTo(terms);
        EXPECT_LT((terms.transpose() * basis).norm(), 1e-12);
        matrix = (basis.transpose() * matrix * basis).eval();
      }
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(matrix);
      EXPECT_GT(eigen.eigenvalues()[0], 1e-12 * eigen.eigenvalues().tail<1>()[0])
        << static_cast<int>(type);
    }
  }
}

// Order is not given away: without the condition the matrix has eigenvalues of both signs.
TEST(RadialKernel, orderIsNeeded)
{
  const Points centers = Truth::randomBox(40, 4);
  for (const KernelType type :
    { KernelType::Linear, KernelType::Cubic, KernelType::ThinPlate, KernelType::Multiquadric })
  {
    const RadialKernel kernel(type, 1.5);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(
      kernel.sign() * Truth::kernelMatrix(centers, kernel));
    EXPECT_LT(eigen.eigenvalues()[0], 0.0);
  }
}

// A width that is no length is refused, with a sentence that names it.
TEST(RadialKernel, refusesUnusableWidths)
{
  for (const double width : { 0.0, -1.0, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(RadialKernel(KernelType::Gaussian, width), InvalidInput);
  }
}

} // namespace
} // namespace SurfaceScalars
