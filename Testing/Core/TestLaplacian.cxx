#include "Error.h"
#include "Laplacian.h"
#include "Queries.h"
#include "Sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

using testing::HasSubstr;
using Truth::nearest;

class PointSetLaplacian : public testing::TestWithParam<LaplacianWeights>
{
};

INSTANTIATE_TEST_SUITE_P(Weights, PointSetLaplacian,
  testing::Values(
    LaplacianWeights::Gaussian, LaplacianWeights::DensityNormalized, LaplacianWeights::LocalScale));

double energy(const Laplacian& laplacian, const Values& function)
{
  return function.dot(laplacian.stiffness * function);
}

// The stiffness is symmetric to the last bit, its rows sum to 0, links are negative and lead both
// ways; the mass is positive.
TEST_P(PointSetLaplacian, isASymmetricMatrixOfLinks)
{
  const NeighborGraph graph(Truth::randomSphere(3000, 1), nearest(12));
  const Laplacian laplacian = pointSetLaplacian(graph, GetParam());
  const Eigen::SparseMatrix<double> transposed = laplacian.stiffness.transpose();

  EXPECT_TRUE(laplacian.symmetric);
  EXPECT_EQ((laplacian.stiffness - transposed).norm(), 0.0);
  const Values ones = Values::Ones(3000);
  EXPECT_LT((laplacian.stiffness * ones).cwiseAbs().maxCoeff(),
    1e-13 * laplacian.stiffness.diagonal().maxCoeff());
  EXPECT_GT(laplacian.mass.minCoeff(), 0.0);
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    for (const Index j : graph.neighbors(i))
    {
      ASSERT_LT(laplacian.stiffness.coeff(i, j), 0.0);
    }
  }
  for (int i = 0; i < laplacian.stiffness.cols(); ++i)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(laplacian.stiffness, i); entry; ++entry)
    {
      const auto from = static_cast<Index>(i);
      const auto to = static_cast<Index>(entry.row());
      ASSERT_TRUE(from == to || graph.isEdge(from, to) || graph.isEdge(to, from));
    }
  }
}

// The mass sums to the area, that of the unit sphere being 4 pi.
TEST_P(PointSetLaplacian, massIsTheArea)
{
  const NeighborGraph graph(Truth::randomSphere(5000, 2), nearest(16));
  EXPECT_NEAR(pointSetLaplacian(graph, GetParam()).mass.sum(), 4 * Pi, 0.01 * 4 * Pi);
}

// On a grid, nothing gives way: the Laplacian of x^2 / 2 is 1, away from the boundary.
TEST_P(PointSetLaplacian, differentiatesQuadraticsOnAGrid)
{
  const double spacing = 0.01;
  const NeighborGraph graph(Truth::squareGrid(151, spacing), nearest(20));
  const Laplacian laplacian = pointSetLaplacian(graph, GetParam());
  const Values x = graph.points().row(0);
  const Values half = x.cwiseAbs2() / 2; // whose Laplacian is 1
  const Values result = (laplacian.stiffness * half).cwiseQuotient(laplacian.mass);
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    if (graph.points().col(i).cwiseAbs().maxCoeff() < 0.6)
    {
      ASSERT_NEAR(result[i], -1.0, 0.035);
    }
  }
}

// Twice the unit is four times the mass, and the same stiffness.
TEST_P(PointSetLaplacian, unitsAreThoseOfItsContract)
{
  const Points points = Truth::randomSphere(2000, 3);
  const Laplacian one = pointSetLaplacian(NeighborGraph(points, nearest(16)), GetParam());
  const Laplacian two = pointSetLaplacian(NeighborGraph(2.0 * points, nearest(16)), GetParam());
  EXPECT_NEAR((two.mass - 4.0 * one.mass).norm(), 0.0, 1e-12 * two.mass.norm());
  EXPECT_NEAR((two.stiffness - one.stiffness).norm(), 0.0, 1e-11 * one.stiffness.norm());
}

// Density plays no part, although it varies from 1 to 4 between the poles: a function that
// lives in the north has the energy of its mirror image, 2/3 of 2 pi for |z| cut off at 0.
TEST(PointSetLaplacianOfLocalScale, energyDoesNotDependOnTheDensity)
{
  Truth::Random random(5);
  const Points points = Truth::select(Truth::randomSphere(60000, 4),
    [&](const Vector3d& place) { return random.uniform() < std::pow(4.0, place.z() / 2 - 0.5); });
  const NeighborGraph graph(points, nearest(32));
  const Laplacian laplacian = pointSetLaplacian(graph, LaplacianWeights::LocalScale);
  const Values z = graph.points().row(2).array() + graph.origin().z();

  const double exact = 2.0 / 3 * 2 * Pi;
  const double north = energy(laplacian, z.cwiseMax(0.0));
  const double south = energy(laplacian, z.cwiseMin(0.0));
  EXPECT_NEAR(north / south, 1.0, 0.03);
  EXPECT_NEAR(north, exact, 0.12 * exact); // somewhat more, as z does not give way
}

// Two threads make the same as one.
TEST_P(PointSetLaplacian, doesNotDependOnTheThreads)
{
  const NeighborGraph graph(Truth::randomSphere(9000, 6), nearest(16));
  const Laplacian one = pointSetLaplacian(graph, GetParam(), 0.0, { 1, {} });
  const Laplacian two = pointSetLaplacian(graph, GetParam(), 0.0, { 2, {} });
  EXPECT_EQ((one.stiffness - two.stiffness).norm(), 0.0);
  EXPECT_EQ(one.mass, two.mass);
}

// Points within a radius serve as well: the scale follows the density, not the radius.
TEST(PointSetLaplacianOfLocalScale, takesNeighborsWithinARadius)
{
  const Points points = Truth::randomSphere(5000, 7);
  const Laplacian laplacian =
    pointSetLaplacian(NeighborGraph(points, Truth::within(0.15)), LaplacianWeights::LocalScale);
  EXPECT_NEAR(laplacian.mass.sum(), 4 * Pi, 0.03 * 4 * Pi);
}

// A point far from a dense cluster remains linked to it.
TEST_P(PointSetLaplacian, keepsOutliersLinked)
{
  Points points = 1e-3 * Truth::randomSphere(1001, 8);
  points.col(1000) = Vector3d(10.0, 0.0, 0.0);
  const Laplacian laplacian = pointSetLaplacian(NeighborGraph(points, nearest(16)), GetParam());
  EXPECT_THAT(connectedComponents(laplacian.stiffness), testing::Each(0));
  EXPECT_TRUE(laplacian.mass.allFinite());
}

TEST(PointSetLaplacianInput, isChecked)
{
  const NeighborGraph graph(Truth::randomSphere(100, 9), nearest(8));
  const auto refusal = [&](LaplacianWeights weights, double width)
  {
    try
    {
      pointSetLaplacian(graph, weights, width);
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(LaplacianWeights::Cotangent, 0.0), HasSubstr("LocalScale"));
  EXPECT_THAT(refusal(LaplacianWeights::Gaussian, -1.0), HasSubstr("-1"));
  EXPECT_THAT(
    refusal(LaplacianWeights::Gaussian, std::numeric_limits<double>::infinity()), HasSubstr("inf"));
  EXPECT_THROW(pointSetLaplacian(
                 graph, LaplacianWeights::LocalScale, 0.0, { 0, [](double) { return false; } }),
    Aborted);
}

// Components are counted in the order of their first rows; an entry of either triangle links.
TEST(ConnectedComponents, areNumberedByTheirFirstRows)
{
  Eigen::SparseMatrix<double> matrix(6, 6);
  matrix.insert(4, 1) = 1.0; // 1 and 4
  matrix.insert(0, 3) = 1.0; // 0 and 3
  matrix.insert(3, 5) = 1.0; // and 5
  matrix.insert(2, 0) = 0.0; // links nothing
  EXPECT_THAT(connectedComponents(matrix), testing::ElementsAre(0, 1, 2, 0, 1, 0));
  EXPECT_TRUE(connectedComponents(Eigen::SparseMatrix<double>(0, 0)).empty());
}

} // namespace
} // namespace SurfaceScalars
