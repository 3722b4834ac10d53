#include "Functions.h"
#include "MeshExamples.h"
#include "Tikhonov.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::Mesh;
using Truth::squareMesh;

constexpr int Size = 320; // squares of a side: 103,041 vertices, above which nothing is factored

Values waves(const Mesh& mesh)
{
  return Truth::valuesOf(
    [](const Vector3d& p) { return std::sin(5 * p.x()) * std::cos(3 * p.y()); }, mesh.vertices);
}

struct Problem
{
  Problem(const Mesh& mesh, double epsilon, SmoothingEnergy energy = SmoothingEnergy::Biharmonic)
    : laplacian(std::make_shared<Laplacian>(
        meshLaplacian(mesh.vertices, mesh.triangles, LaplacianWeights::Cotangent)))
    , smoother(laplacian,
        metricMatrix(DataMetric::LumpedMass, *laplacian, mesh.vertices, mesh.triangles), energy)
    , solution(waves(mesh))
  {
    // t A (f - x) = S A^-1 S x
    const Values image = (laplacian->stiffness * solution).cwiseQuotient(laplacian->mass);
    const Values energyImage = (laplacian->stiffness * image).cwiseQuotient(laplacian->mass);
    f = solution + energyImage / smoother.weight(epsilon);
  }

  std::shared_ptr<const Laplacian> laplacian;
  TikhonovSmoother smoother;
  Values solution;
  Values f;
};

void expectSolution(const Mesh& mesh, double epsilon)
{
  const Problem problem(mesh, epsilon);
  const Values found = problem.smoother.smooth(problem.f, epsilon, { 2, {} });
  EXPECT_LT((found - problem.solution).lpNorm<Eigen::Infinity>(),
    1e-7 * problem.f.lpNorm<Eigen::Infinity>());
}

// With f from S A^-1 S x + t A x = t A f, smoothing finds x on a mesh too large to be factored:
// where details of the size of the square are smoothed, and where x is nearly f.
TEST(TikhonovOfManyVertices, findsAKnownSolution)
{
  expectSolution(squareMesh(Size, 0.0), 1e2);
  expectSolution(squareMesh(Size, 0.3), 1e9);
}

/// The vertices in random order.
void shuffle(Mesh& mesh)
{
  std::vector<Index> places(static_cast<std::size_t>(mesh.vertices.cols()));
  std::iota(places.begin(), places.end(), Index(0));
  std::shuffle(places.begin(), places.end(), std::mt19937(1));
  const Points before = mesh.vertices;
  for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
  {
    mesh.vertices.col(places[vertex]) = before.col(static_cast<Eigen::Index>(vertex));
  }
  mesh.triangles = mesh.triangles.unaryExpr([&](Index vertex) { return places[vertex]; }).eval();
}

// The same where areas differ by a thousand and some triangles have none, in any order.
TEST(TikhonovOfManyVertices, survivesIrregularTriangles)
{
  Mesh mesh = squareMesh(Size, 0.3);
  const auto places = mesh.vertices.topRows(2).array();
  mesh.vertices.topRows(2) = (places * (places + 0.03)).eval();
  for (Eigen::Index i = 3000; i < 100000; i += 3137)
  {
    mesh.vertices.col(i) = mesh.vertices.col(i + 1);
  }
  shuffle(mesh);
  expectSolution(mesh, 1e9);
}

// The number of threads and what was solved before change no bit.
TEST(TikhonovOfManyVertices, dependsOnNothingElse)
{
  const Problem problem(squareMesh(Size, 0.3), 1e8);
  const Values once = problem.smoother.smooth(problem.f, 1e8, { 1, {} }, 1e-2);
  problem.smoother.smooth(problem.f, 1e6, { 3, {} }, 1e-2);
  EXPECT_EQ(problem.smoother.smooth(problem.f, 1e8, { 3, {} }, 1e-2), once);
}

} // namespace
} // namespace SurfaceScalars
