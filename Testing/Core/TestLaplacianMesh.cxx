#include "Error.h"
#include "LaplacianFunctions.h"
#include "MeshExamples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

using testing::HasSubstr;

using Truth::Mesh;
using Truth::sphereMesh;
using Truth::squareMesh;

Laplacian laplacianOf(const Mesh& mesh, LaplacianWeights weights)
{
  return meshLaplacian(mesh.vertices, mesh.triangles, weights);
}

class MeshLaplacian : public testing::TestWithParam<LaplacianWeights>
{
};
INSTANTIATE_TEST_SUITE_P(Weights, MeshLaplacian,
  testing::Values(LaplacianWeights::Cotangent, LaplacianWeights::NormalizedCotangent,
    LaplacianWeights::MeanValue));

// In the plane a linear function has Laplacian 0 at each inner vertex, whatever the triangles are;
// constants have it everywhere.
TEST_P(MeshLaplacian, vanishesOnLinearFunctions)
{
  const Mesh mesh = squareMesh(20, 0.2);
  const Laplacian laplacian = laplacianOf(mesh, GetParam());
  const Values linear = mesh.vertices.transpose() * Vector3d(2.0, -3.0, 0.0);
  const Values result = laplacian.stiffness * linear;
  const Values ones = Values::Ones(linear.size());
  EXPECT_LT((laplacian.stiffness * ones).cwiseAbs().maxCoeff(), 1e-12);
  for (Eigen::Index i = 0; i < result.size(); ++i)
  {
    const auto place = mesh.vertices.col(i).head(2);
    if (place.minCoeff() > 1e-9 && place.maxCoeff() < 1.0 - 1e-9)
    {
      ASSERT_NEAR(result[i], 0.0, 1e-12);
    }
  }
  EXPECT_EQ(laplacian.symmetric, GetParam() != LaplacianWeights::MeanValue);
  EXPECT_GT(laplacian.mass.minCoeff(), 0.0);
}

// The energy of a linear function is the area times its slope's square: that of finite elements.
TEST(MeshLaplacianOfCotangents, isTheDirichletEnergyOfFiniteElements)
{
  const Mesh mesh = squareMesh(10, 0.2);
  const Laplacian laplacian = laplacianOf(mesh, LaplacianWeights::Cotangent);
  const Values linear = mesh.vertices.transpose() * Vector3d(2.0, -3.0, 0.0);
  EXPECT_NEAR(linear.dot(laplacian.stiffness * linear), 13.0, 1e-12);
  EXPECT_NEAR(laplacian.mass.sum(), 1.0, 1e-13);
  const Eigen::SparseMatrix<double> transposed = laplacian.stiffness.transpose();
  EXPECT_EQ((laplacian.stiffness - transposed).norm(), 0.0);
}

// On a sphere the eigenvalues l (l + 1) come out the better the finer the mesh, by the square of
// the edges.
TEST(MeshLaplacianOfCotangents, convergesOnASphere)
{
  std::array<double, 2> errors{};
  for (int i = 0; i < 2; ++i)
  {
    const Laplacian laplacian = laplacianOf(sphereMesh(3 + i), LaplacianWeights::Cotangent);
    const Values eigenvalues = laplacianEigenfunctions(laplacian, 16).eigenvalues;
    Values exact(16);
    exact << 0, 2, 2, 2, 6, 6, 6, 6, 6, 12, 12, 12, 12, 12, 12, 12;
    errors[i] = (eigenvalues - exact).tail(15).cwiseQuotient(exact.tail(15)).cwiseAbs().maxCoeff();
  }
  EXPECT_LT(errors[1], 0.02);
  EXPECT_NEAR(errors[0] / errors[1], 4.0, 0.6);
}

// The coordinates of a sphere are eigenfunctions: also where the weights are not symmetric and
// there is no energy, -Laplacian x = 2 x.
TEST(MeshLaplacianOfMeanValues, convergesOnASphere)
{
  const Mesh mesh = sphereMesh(4);
  const Laplacian laplacian = laplacianOf(mesh, LaplacianWeights::MeanValue);
  const Values x = mesh.vertices.row(0);
  const Values result = (laplacian.stiffness * x).cwiseQuotient(laplacian.mass);
  EXPECT_LT((result - 2.0 * x).cwiseAbs().mean(), 0.05);
  EXPECT_NEAR(result.dot(x) / x.squaredNorm(), 2.0, 0.06);
}

// Rows of cotangents divided by their sums have eigenvalues between 0 and 2, whatever the unit.
TEST(MeshLaplacianOfNormalizedCotangents, hasNoUnit)
{
  Mesh mesh = sphereMesh(2);
  const Laplacian one = laplacianOf(mesh, LaplacianWeights::NormalizedCotangent);
  mesh.vertices *= 10.0;
  const Laplacian ten = laplacianOf(mesh, LaplacianWeights::NormalizedCotangent);
  EXPECT_LT((one.mass - ten.mass).norm(), 1e-12);
  const auto count = static_cast<int>(one.mass.size()) - 1;
  const Values eigenvalues = laplacianEigenfunctions(one, count).eigenvalues;
  EXPECT_GE(eigenvalues.minCoeff(), 0.0);
  EXPECT_LE(eigenvalues.maxCoeff(), 2.0);
}

// Triangles without area and vertices without triangles make no infinity, and the energy remains
// positive.
TEST_P(MeshLaplacian, survivesSlivers)
{
  Mesh mesh = squareMesh(4, 0.3);
  const Eigen::Index vertices = mesh.vertices.cols();
  const Eigen::Index triangles = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, vertices + 3);
  mesh.vertices.col(vertices) = 0.5 * (mesh.vertices.col(0) + mesh.vertices.col(1));
  mesh.vertices.col(vertices + 1) = mesh.vertices.col(0);
  mesh.vertices.col(vertices + 2) = Vector3d(9.0, 0.0, 0.0); // of no triangle
  mesh.triangles.conservativeResize(3, triangles + 3);
  const auto middle = static_cast<Index>(vertices);
  mesh.triangles.col(triangles) << 0, middle, 1;         // three in a line
  mesh.triangles.col(triangles + 1) << 0, middle + 1, 1; // two at one place
  mesh.triangles.col(triangles + 2) << 2, 2, 2;
  const Laplacian laplacian = laplacianOf(mesh, GetParam());
  const Eigen::MatrixXd dense = laplacian.stiffness;
  EXPECT_TRUE(dense.allFinite());
  EXPECT_TRUE(laplacian.mass.allFinite());
  EXPECT_GT(laplacian.mass.minCoeff(), 0.0);
  if (laplacian.symmetric)
  {
    const Values eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues();
    EXPECT_GT(eigenvalues.minCoeff(), -1e-13 * eigenvalues.maxCoeff());
  }
}

// Heat spreads by weights that are not symmetric too: z decays by exp(-2 t).
TEST(MeshLaplacianOfMeanValues, diffuses)
{
  const Mesh mesh = sphereMesh(4);
  const Laplacian laplacian = laplacianOf(mesh, LaplacianWeights::MeanValue);
  const Values z = mesh.vertices.row(2);
  const Values heat = diffuse(laplacian, z, 0.25);
  EXPECT_LT((heat - std::exp(-0.5) * z).cwiseAbs().maxCoeff(), 0.03);
}

TEST(MeshLaplacianInput, isChecked)
{
  Mesh mesh = squareMesh(2, 0.0);
  const auto refusal = [&](LaplacianWeights weights)
  {
    try
    {
      laplacianOf(mesh, weights);
    }
    catch (const InvalidInput& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(LaplacianWeights::LocalScale), HasSubstr("Cotangent"));
  mesh.triangles(1, 3) = 9;
  EXPECT_THAT(refusal(LaplacianWeights::Cotangent), HasSubstr("found 9"));
  mesh.triangles(1, 3) = 1;
  mesh.vertices(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(LaplacianWeights::Cotangent), HasSubstr("finite"));
  mesh.vertices.setZero();
  EXPECT_THAT(refusal(LaplacianWeights::Cotangent), HasSubstr("area"));
  mesh.triangles.resize(3, 0);
  EXPECT_THAT(refusal(LaplacianWeights::Cotangent), HasSubstr("none"));
}

} // namespace
} // namespace SurfaceScalars
