#include "Error.h"
#include "Functions.h"
#include "LaplacianFunctions.h"
#include "Queries.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::nearest;
using Truth::randomPlane;
using Truth::randomSphere;
using Truth::select;

using Function = std::function<double(const Vector3d&)>;

/// A point set with f given at some of its points, and known at all.
struct Problem
{
  Points points; ///< in the order of the graph
  Laplacian laplacian;
  std::vector<ValueConstraint> constraints;
};

Problem problemOn(const PointsRef& input, const std::function<bool(const Vector3d&)>& isGiven,
  const Function& given, LaplacianWeights weights = LaplacianWeights::LocalScale)
{
  const NeighborGraph graph(input, nearest(16));
  Problem problem{ graph.points().colwise() + graph.origin(), pointSetLaplacian(graph, weights),
    {} };
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    if (isGiven(problem.points.col(i)))
    {
      problem.constraints.push_back({ i, given(problem.points.col(i)) });
    }
  }
  return problem;
}

Values solutionOf(const Problem& problem)
{
  return harmonicFunction(problem.laplacian, problem.constraints);
}

/// Root of the mean square over all points.
double errorOf(const Problem& problem, const Function& exact)
{
  const Values errors = solutionOf(problem) - Truth::valuesOf(exact, problem.points);
  return errors.norm() / std::sqrt(static_cast<double>(errors.size()));
}

constexpr double CapHeight = 0.9;

/// The caps above and below are 1 and 0; harmonic between them.
double betweenCaps(const Vector3d& place)
{
  const double height = std::clamp(place.z(), -CapHeight, CapHeight);
  return 0.5 + 0.5 * std::atanh(height) / std::atanh(CapHeight);
}

bool isInCap(const Vector3d& place)
{
  return std::abs(place.z()) >= CapHeight;
}

/// Four times as dense above the equator as below.
Points skewedSphere(int count, unsigned seed)
{
  Truth::Random random(seed);
  return select(randomSphere(count, seed + 1),
    [&](const Vector3d& place) { return place.z() > 0.0 || random.uniform() < 0.25; });
}

// Between two caps of a sphere the solution converges to the exact one; where the density jumps by
// a factor of four it is at most twice as far from it.
TEST(HarmonicFunction, convergesOnASphereWhateverTheDensity)
{
  double last = std::numeric_limits<double>::infinity();
  for (const int count : { 4000, 16000, 64000 })
  {
    const double even =
      errorOf(problemOn(randomSphere(count, 1), isInCap, betweenCaps), betweenCaps);
    // 8/5 as many are drawn, to have as many.
    const double skewed =
      errorOf(problemOn(skewedSphere(count * 8 / 5, 2), isInCap, betweenCaps), betweenCaps);
    EXPECT_LT(even, 1.5 / std::sqrt(count));
    EXPECT_LT(even, 0.7 * last);
    EXPECT_LT(skewed, 2.0 * even);
    last = even;
  }
}

// On a flat ring the solution converges to the logarithm of the radius.
TEST(HarmonicFunction, convergesToTheLogarithmOnARing)
{
  const Function logarithm = [](const Vector3d& place) { return std::log(place.norm()); };
  const auto isGiven = [](const Vector3d& place)
  { return place.norm() < 0.35 || place.norm() > 0.95; };
  const auto isInRing = [](const Vector3d& place)
  { return place.norm() > 0.3 && place.norm() < 1.0; };
  double last = std::numeric_limits<double>::infinity();
  for (const int count : { 5000, 20000, 80000 })
  {
    const Points ring = select(randomPlane(count, 3), isInRing);
    const double error = errorOf(problemOn(ring, isGiven, logarithm), logarithm);
    EXPECT_LT(error, 2.5 / std::sqrt(count));
    EXPECT_LT(error, 0.7 * last);
    last = error;
  }
}

// In a square with linear values on its rim the function is linear.
TEST(HarmonicFunction, isLinearInASquare)
{
  const Function linear = [](const Vector3d& place) { return 2.0 * place.x() - place.y() + 3.0; };
  const auto isRim = [](const Vector3d& place) { return place.lpNorm<Eigen::Infinity>() > 0.95; };
  EXPECT_LT(errorOf(problemOn(randomPlane(20000, 4), isRim, linear), linear), 0.02);
}

// Where weights are positive the function lies between the values given, which are kept exactly;
// everywhere else it is the weighted mean of its neighbors.
TEST(HarmonicFunction, obeysTheMaximumPrinciple)
{
  Truth::Random random(5);
  const Points sphere = skewedSphere(20000, 6);
  for (const LaplacianWeights weights : { LaplacianWeights::Gaussian,
         LaplacianWeights::DensityNormalized, LaplacianWeights::LocalScale })
  {
    const auto isGiven = [&](const Vector3d&) { return random.uniform() < 0.001; };
    const Problem problem = problemOn(
      sphere, isGiven, [&](const Vector3d&) { return random.uniform(-3.0, 5.0); }, weights);
    const Values f = solutionOf(problem);
    Values imbalance = problem.laplacian.stiffness * f;
    double least = 5.0;
    double most = -3.0;
    for (const auto& [vertex, value] : problem.constraints)
    {
      EXPECT_EQ(f[vertex], value);
      imbalance[vertex] = 0.0;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    EXPECT_GE(f.minCoeff(), least - 1e-8 * (most - least));
    EXPECT_LE(f.maxCoeff(), most + 1e-8 * (most - least));
    const Values diagonal = problem.laplacian.stiffness.diagonal();
    EXPECT_LT(imbalance.cwiseQuotient(diagonal).lpNorm<Eigen::Infinity>(), 1e-8 * (most - least));
  }
}

// Two points suffice; the unit and the offset of the values change nothing but them.
TEST(HarmonicFunction, followsUnitAndOffsetOfTheValues)
{
  Problem problem = problemOn(
    randomSphere(10000, 7), [](const Vector3d&) { return false; }, betweenCaps);
  problem.constraints = { { 17, 0.0 }, { 9000, 1.0 } };
  const Values f = solutionOf(problem);
  EXPECT_GT(f.maxCoeff() - f.minCoeff(), 0.999);
  problem.constraints = { { 17, 1e9 }, { 9000, 1e9 + 1.0 } };
  EXPECT_LT((solutionOf(problem).array() - 1e9 - f.array()).abs().maxCoeff(), 1e-6);
  problem.constraints = { { 17, 0.0 }, { 9000, 1e-300 } };
  EXPECT_LT((solutionOf(problem) * 1e300 - f).lpNorm<Eigen::Infinity>(), 1e-12);
  problem.constraints = { { 17, -1e308 }, { 9000, 1e308 } };
  EXPECT_LT((0.5e-308 * solutionOf(problem).array() + 0.5 - f.array()).abs().maxCoeff(), 1e-12);
}

// Equal values make a constant function, exactly; several equal constraints at a vertex are one.
TEST(HarmonicFunction, isConstantBetweenEqualValues)
{
  Problem problem = problemOn(
    randomSphere(5000, 8), [](const Vector3d&) { return false; }, betweenCaps);
  problem.constraints = { { 3, 0.1 }, { 4000, 0.1 }, { 3, 0.1 } };
  EXPECT_TRUE((solutionOf(problem).array() == 0.1).all());
}

// With a value at every vertex nothing is left to solve.
TEST(HarmonicFunction, keepsValuesThatAreAllGiven)
{
  const Problem problem = problemOn(
    randomSphere(500, 9), [](const Vector3d&) { return true; }, betweenCaps);
  EXPECT_EQ(solutionOf(problem), Truth::valuesOf(betweenCaps, problem.points));
}

/// A square of (count - 1)^2 cells, the inner vertices moved at random.
struct SquareMesh
{
  Points vertices;
  Triangles triangles;
};

SquareMesh squareMesh(int count)
{
  Truth::Random random(10);
  SquareMesh mesh{ Truth::squareGrid(count, 1.0), Triangles(3, 2 * (count - 1) * (count - 1)) };
  Eigen::Index triangle = 0;
  for (int j = 0; j + 1 < count; ++j)
  {
    for (int i = 0; i + 1 < count; ++i)
    {
      const auto corner = static_cast<Index>(j * count + i);
      const auto above = corner + static_cast<Index>(count);
      mesh.triangles.col(triangle++) << corner, corner + 1, above + 1;
      mesh.triangles.col(triangle++) << corner, above + 1, above;
      if (i > 0 && j > 0)
      {
        mesh.vertices.col(corner) +=
          Vector3d(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.0);
      }
    }
  }
  return mesh;
}

// On a planar mesh linear functions are reproduced, by symmetric weights and by others.
TEST(HarmonicFunction, reproducesLinearFunctionsOnAMesh)
{
  const int count = 100;
  const SquareMesh mesh = squareMesh(count);
  const Values exact = mesh.vertices.row(0) - 2.0 * mesh.vertices.row(1);
  std::vector<ValueConstraint> rim;
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      if (std::min(i, j) == 0 || std::max(i, j) == count - 1)
      {
        const auto vertex = static_cast<Index>(j * count + i);
        rim.push_back({ vertex, exact[vertex] });
      }
    }
  }
  for (const LaplacianWeights weights : { LaplacianWeights::Cotangent,
         LaplacianWeights::NormalizedCotangent, LaplacianWeights::MeanValue })
  {
    const Laplacian laplacian = meshLaplacian(mesh.vertices, mesh.triangles, weights);
    const Values f = harmonicFunction(laplacian, rim);
    EXPECT_LT((f - exact).lpNorm<Eigen::Infinity>(), 1e-7);
  }
}

/// The sentence with which constraints are refused.
std::string refusalOf(const Laplacian& laplacian, const std::vector<ValueConstraint>& constraints,
  const VertexName& nameOf = {})
{
  try
  {
    harmonicFunction(laplacian, constraints, {}, nameOf);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "not refused";
}

// Constraints that do not determine a function are refused, saying where and why.
TEST(HarmonicFunction, refusesUnusableConstraints)
{
  Points two = randomPlane(600, 11);
  two.row(0).tail(200).array() += 100.0;
  const Problem problem = problemOn(
    two, [](const Vector3d&) { return false; }, betweenCaps);
  const Laplacian& laplacian = problem.laplacian;
  const double infinity = std::numeric_limits<double>::infinity();
  const auto has = [](const std::string& text, const std::string& part)
  { return text.find(part) != std::string::npos ? "" : text; };

  EXPECT_EQ(has(refusalOf(laplacian, {}), "at least 1 constraint"), "");
  EXPECT_EQ(has(refusalOf(laplacian, { { 600, 1.0 } }), "600 vertices"), "");
  EXPECT_EQ(has(refusalOf(laplacian, { { 7, infinity } }), "inf at point 7"), "");
  EXPECT_EQ(has(refusalOf(laplacian, { { 7, 1.0 }, { 7, 2.5 } }), "1 and 2.5 at point 7"), "");
  EXPECT_EQ(
    has(refusalOf(laplacian, { { 7, 1.0 }, { 7, 2.5 } }, [](Index) { return 42; }), "at point 42"),
    "");

  const bool isLeft = problem.points(0, 0) < 50.0;
  Index other = 0;
  while ((problem.points(0, other) < 50.0) == isLeft)
  {
    ++other;
  }
  const std::string sentence = "1 without one, among them that of point " + std::to_string(other) +
    (isLeft ? " (200 points)" : " (400 points)");
  EXPECT_EQ(has(refusalOf(laplacian, { { 0, 1.0 } }), sentence), "");
}

// Progress never falls and ends at 1; refusing it stops the solution. Threads change nothing.
TEST(HarmonicFunction, reportsProgressAndAborts)
{
  const Problem problem = problemOn(randomSphere(40000, 12), isInCap, betweenCaps);
  std::vector<double> reported;
  const Execution watched{ 2,
    [&](double fraction)
    {
      reported.push_back(fraction);
      return true;
    } };
  const Values f = harmonicFunction(problem.laplacian, problem.constraints, watched);
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GT(reported.size(), 20u);
  EXPECT_EQ(reported.back(), 1.0);
  EXPECT_EQ(f, harmonicFunction(problem.laplacian, problem.constraints, { 1, {} }));
  for (const double limit : { 0.0, 0.1, 0.5, 0.99 })
  {
    const Execution stopped{ 2, [=](double fraction) { return fraction <= limit; } };
    EXPECT_THROW(harmonicFunction(problem.laplacian, problem.constraints, stopped), Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars
