#include "Error.h"
#include "LaplacianFunctions.h"
#include "Queries.h"
#include "Sampling.h"

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
using Truth::nearest;

/// Heat 1 in all, at one point.
Values unitHeat(const Laplacian& laplacian, Index source)
{
  Values result = Values::Zero(laplacian.mass.size());
  result[source] = 1.0 / laplacian.mass[source];
  return result;
}

/// Of the unit sphere: sum (2 l + 1) / (4 pi) exp(-l (l + 1) t) P_l(cosine).
double sphereHeatKernel(double cosine, double time)
{
  double result = 0.0;
  double last = 0.0;
  double legendre = 1.0;
  for (int l = 0; l < 60; ++l)
  {
    result += (2 * l + 1) / (4 * Pi) * std::exp(-l * (l + 1) * time) * legendre;
    const double next = ((2 * l + 1) * cosine * legendre - l * last) / (l + 1);
    last = legendre;
    legendre = next;
  }
  return result;
}

// From one point of a sphere heat spreads as the heat kernel, the known series of Legendre
// polynomials, but for the noise of where samples happen to lie; nowhere is less than none.
TEST(Diffusion, isTheHeatKernelOfTheSphere)
{
  const NeighborGraph graph(Truth::randomSphere(20000, 1), nearest(24));
  const Laplacian laplacian = pointSetLaplacian(graph, LaplacianWeights::LocalScale);
  const Index source = 1234;
  const Vector3d north = graph.points().col(source) + graph.origin();
  for (const double time : { 0.1, 0.5 })
  {
    const Values heat = diffuse(laplacian, unitHeat(laplacian, source), time);
    const double peak = sphereHeatKernel(1.0, time);
    Values exact(heat.size());
    for (Eigen::Index i = 0; i < heat.size(); ++i)
    {
      exact[i] = sphereHeatKernel(north.dot(graph.points().col(i) + graph.origin()), time);
    }
    EXPECT_LT((heat - exact).cwiseAbs().maxCoeff(), 0.1 * peak) << "time " << time;
    EXPECT_LT((heat - exact).cwiseAbs().mean(), 0.01 * peak) << "time " << time;
    EXPECT_GT(heat.minCoeff(), -1e-4 * peak) << "time " << time;
    EXPECT_NEAR(heat.dot(laplacian.mass), 1.0, 1e-12);
  }
}

// In a plane it is a Gaussian, as long as it has not come to the boundary.
TEST(Diffusion, isAGaussianInAPlane)
{
  const NeighborGraph graph(Truth::randomPlane(20000, 2), nearest(24));
  const Laplacian laplacian = pointSetLaplacian(graph, LaplacianWeights::LocalScale);
  Neighborhood middle;
  graph.nearest(Vector3d::Zero(), 1, middle);
  const Index source = middle.indices.front();
  const double time = 0.02;
  const Values heat = diffuse(laplacian, unitHeat(laplacian, source), time);
  const double peak = 1.0 / (4 * Pi * time);
  Values exact(heat.size());
  for (Eigen::Index i = 0; i < heat.size(); ++i)
  {
    const double squared = (graph.points().col(i) - graph.points().col(source)).squaredNorm();
    exact[i] = peak * std::exp(-squared / (4 * time));
  }
  EXPECT_LT((heat - exact).cwiseAbs().maxCoeff(), 0.15 * peak);
  EXPECT_LT((heat - exact).cwiseAbs().mean(), 0.005 * peak);
}

// An eigenfunction decays by exp(-lambda t), to 1.2e-5 for any time, be it short or long.
TEST(Diffusion, ofEigenfunctionsIsExponential)
{
  const Laplacian laplacian = pointSetLaplacian(
    NeighborGraph(Truth::randomSphere(250, 3), nearest(12)), LaplacianWeights::LocalScale);
  const Eigenfunctions modes = laplacianEigenfunctions(laplacian, 249);
  for (const double time : { 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0 })
  {
    for (int i = 0; i < 249; i += 8)
    {
      const Values mode = modes.functions.col(i);
      const Values exact = std::exp(-modes.eigenvalues[i] * time) * mode;
      const Values error = diffuse(laplacian, mode, time) - exact;
      ASSERT_LT(std::sqrt(error.cwiseAbs2().dot(laplacian.mass)), 1.2e-5)
        << "time " << time << ", number " << i;
    }
  }
}

// Heat remains in its component, all of it, at any time.
TEST(Diffusion, keepsTheHeatOfEachComponent)
{
  const Points sphere = Truth::randomSphere(2000, 4);
  Points both(3, 4000);
  both << sphere, sphere.colwise() + Vector3d(5.0, 0.0, 0.0);
  const NeighborGraph graph(both, nearest(16));
  const Laplacian laplacian = pointSetLaplacian(graph, LaplacianWeights::LocalScale);
  const std::vector<int> components = connectedComponents(laplacian.stiffness);
  for (const double time : { 1e-6, 1.0, 1e6 })
  {
    const Values heat = diffuse(laplacian, unitHeat(laplacian, 100), time);
    EXPECT_NEAR(heat.dot(laplacian.mass), 1.0, 1e-12);
    for (std::size_t i = 0; i < components.size(); ++i)
    {
      if (components[i] != components[100])
      {
        ASSERT_NEAR(heat[static_cast<Eigen::Index>(i)], 0.0, 1e-9);
      }
    }
  }
}

// Constant heat remains what it is.
TEST(Diffusion, leavesConstantsAlone)
{
  const Laplacian laplacian = pointSetLaplacian(
    NeighborGraph(Truth::randomPlane(500, 5), nearest(12)), LaplacianWeights::LocalScale);
  const Values heat = diffuse(laplacian, Values::Constant(500, 7.0), 0.1);
  EXPECT_NEAR(heat.minCoeff(), 7.0, 1e-12);
  EXPECT_NEAR(heat.maxCoeff(), 7.0, 1e-12);
}

TEST(Diffusion, checksItsInput)
{
  const Laplacian laplacian = pointSetLaplacian(
    NeighborGraph(Truth::randomPlane(300, 6), nearest(12)), LaplacianWeights::LocalScale);
  const auto refusal = [&](const Values& heat, double time)
  {
    try
    {
      diffuse(laplacian, heat, time);
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  const Values ones = Values::Ones(300);
  EXPECT_THAT(refusal(ones, 0.0), HasSubstr("time"));
  EXPECT_THAT(refusal(ones, std::numeric_limits<double>::infinity()), HasSubstr("inf"));
  EXPECT_THAT(refusal(Values::Ones(299), 1.0), HasSubstr("299"));
  EXPECT_THAT(refusal(Values::Constant(300, std::nan("")), 1.0), HasSubstr("finite"));
  const Execution refuse = { 0, [](double fraction) { return fraction < 0.5; } };
  EXPECT_THROW(diffuse(laplacian, ones, 1.0, refuse), Aborted);
}

} // namespace
} // namespace SurfaceScalars
