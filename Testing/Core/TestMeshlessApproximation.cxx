#include "ApproximationTruth.h"
#include "MeshlessApproximationTest.h"
#include "TetrahedralGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

/// How many of the points a walk around each vertex finds in the values, too.
std::size_t keptByWalking(const TriangleMesh& mesh, const MeshlessApproximation& result)
{
  const std::vector<CriticalPoint> found = Truth::meshCriticalPoints(mesh, result.values);
  std::size_t kept = 0;
  for (const CriticalPoint& asked : result.persistent)
  {
    kept += static_cast<std::size_t>(std::count_if(found.begin(), found.end(),
      [&](const CriticalPoint& point)
      {
        return point.input == asked.input && point.type == asked.type &&
          point.multiplicity == asked.multiplicity;
      }));
  }
  return kept;
}

// Stars are interpolated, so that each persistent critical point is one of u, at the same vertex
// and of the same type and multiplicity: on genus 0, 1 and 3, for few and many points and both ways
// to choose centers.
TEST(MeshlessApproximation, keepsPersistentCriticalPoints)
{
  std::size_t most = 0;
  for (const TriangleMesh& mesh :
    { octahedralSphere(16), torus(50), plateWithHoles(3, 3), gridMesh(Grid::Torus, 30, 20) })
  {
    for (const double frequency : { 0.5, 3.0 })
    {
      for (const CenterSelection selection :
        { CenterSelection::Greedy, CenterSelection::LevelSets })
      {
        const Values values = waves(mesh.points, frequency);
        ApproximationParameters parameters = withFraction(0.1);
        parameters.centerSelection = selection;
        const MeshlessApproximation result = approximated(mesh, values, parameters);
        // More than rounding where values are level and drawn apart
        EXPECT_LE(largestMissAtStars(mesh, values, result), 2e-7 * rangeOf(values));
        EXPECT_TRUE(result.lost.empty());
        EXPECT_EQ(keptByWalking(mesh, result), result.persistent.size());
        most = std::max(most, result.persistent.size());
      }
    }
  }
  EXPECT_GT(most, 50U);
}

// What is said of the result is so: values are those of the model, errors those of the values,
// prescribed points are the persistent ones that are kept.
TEST(MeshlessApproximation, saysWhatItIs)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = waves(mesh.points, 4.0);
  const MeshlessApproximation result = approximated(mesh, values, withFraction(0.1));

  const Values again = Field(result.model).evaluate(mesh.points, {}).values;
  EXPECT_LE((again - result.values).lpNorm<Eigen::Infinity>(), 1e-11 * rangeOf(values));
  const Values misses = (result.values - values).cwiseAbs();
  EXPECT_EQ(result.largestError, misses.maxCoeff());
  EXPECT_EQ(result.meanError, misses.mean());
  EXPECT_EQ(result.model.centers.cols(), result.askedCount);
  EXPECT_EQ(result.askedCount, result.starCount + std::lround(0.1 * 1026));
  EXPECT_EQ(std::count(result.prescribed.begin(), result.prescribed.end(), 1),
    static_cast<std::ptrdiff_t>(result.persistent.size()));
  EXPECT_EQ(result.prescribed.size(), result.critical.points.size());
  EXPECT_EQ(bytesOf(result.model), 8U * (4U * static_cast<unsigned>(result.askedCount) + 7U));
  EXPECT_GT(result.condition, 1.0);
}

// Linear functions are what the polynomial is: a cover is enough, whatever is asked for.
TEST(MeshlessApproximation, reproducesLinearFunctions)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = Vector3d(0.3, -0.5, 0.8).transpose() * mesh.points;
  const MeshlessApproximation result = approximated(mesh, values, withFraction(0.5));
  EXPECT_LE(result.largestError, 1e-13);
  EXPECT_LT(result.model.centers.cols(), result.askedCount / 2);
}

// With every vertex a center, u is f, also where nearly all are in stars.
TEST(MeshlessApproximation, interpolatesEverything)
{
  for (const int size : { 3, 8 })
  {
    const TriangleMesh mesh = octahedralSphere(size);
    Values values = waves(mesh.points, 4.0);
    addNoise(values, 0.1, 1); // symmetric ones are met at some vertices before these are centers
    const MeshlessApproximation result = approximated(mesh, values, withFraction(1.0));
    EXPECT_EQ(result.model.centers.cols(), mesh.points.cols());
    EXPECT_LE(result.largestError, 1e-12 * rangeOf(values));
  }
}

// In other units of f the error is the same fraction of its range.
TEST(MeshlessApproximation, doesNotDependOnTheUnitOfValues)
{
  const TriangleMesh mesh = octahedralSphere(12);
  const Values values = waves(mesh.points, 4.0);
  for (const LevelSetConstraints constraints : { LevelSetConstraints::Interpolating,
         LevelSetConstraints::LeastSquares, LevelSetConstraints::Minimax })
  {
    ApproximationParameters parameters = withFraction(0.1, 0.1);
    parameters.levelSetConstraints = constraints;
    const double error = approximated(mesh, values, parameters).largestError;
    for (const double unit : { 1e-250, 1e-160, 1e160, 1e250 })
    {
      const double other = approximated(mesh, unit * values, parameters).largestError;
      EXPECT_NEAR(other / unit, error, 0.01 * error) << unit;
    }
  }
}

// The more centers the smaller the error, which is below half of that of as many farthest points
// and below a quarter of that of the paper's centers.
TEST(MeshlessApproximation, approximatesBetterThanEvenCenters)
{
  const TriangleMesh mesh = torus(70);
  const Values values = waves(mesh.points, 4.0);
  double error = rangeOf(values);
  for (const double fraction : { 0.05, 0.1, 0.15 })
  {
    ApproximationParameters parameters = withFraction(fraction, 0.1);
    const MeshlessApproximation result = approximated(mesh, values, parameters);
    EXPECT_LT(result.largestError, 0.6 * error);
    error = result.largestError;
    if (result.model.centers.cols() >= 4 * result.starCount)
    {
      EXPECT_LE(error, 0.5 * farthestPointError(mesh.points, values, result.model.centers.cols()));
      parameters.centerSelection = CenterSelection::LevelSets;
      EXPECT_LE(error, 0.25 * approximated(mesh, values, parameters).largestError);
    }
  }
}

// Every kernel, its width chosen, is well conditioned and interpolates the stars.
TEST(MeshlessApproximation, isWellConditionedWithEveryKernel)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = waves(mesh.points, 4.0);
  for (const KernelType kernel : { KernelType::Gaussian, KernelType::Exponential,
         KernelType::Linear, KernelType::Cubic, KernelType::ThinPlate, KernelType::Multiquadric,
         KernelType::InverseMultiquadric, KernelType::Wendland, KernelType::Wu })
  {
    ApproximationParameters parameters = withFraction(0.1);
    parameters.kernel = kernel;
    const MeshlessApproximation result = approximated(mesh, values, parameters);
    EXPECT_LT(result.condition, 1e12) << nameOf(kernel);
    EXPECT_LE(largestMissAtStars(mesh, values, result), 1e-9 * rangeOf(values)) << nameOf(kernel);
    EXPECT_LT(result.largestError, 0.2 * rangeOf(values)) << nameOf(kernel);
    EXPECT_TRUE(result.lost.empty()) << nameOf(kernel);
  }
}

// The same to the bit with any number of threads.
TEST(MeshlessApproximation, doesNotDependOnThreads)
{
  const TriangleMesh mesh = torus(60);
  Values values = waves(mesh.points, 3.0);
  addNoise(values, 0.01, 1);
  for (const LevelSetConstraints constraints :
    { LevelSetConstraints::LeastSquares, LevelSetConstraints::Minimax })
  {
    ApproximationParameters parameters = withFraction(0.2, 0.2);
    parameters.centerSelection = constraints == LevelSetConstraints::Minimax
      ? CenterSelection::Greedy
      : CenterSelection::LevelSets;
    parameters.levelSetConstraints = constraints;
    const MeshlessApproximation one = approximated(mesh, values, parameters, 1);
    const MeshlessApproximation three = approximated(mesh, values, parameters, 3);
    EXPECT_EQ(one.values, three.values);
    EXPECT_EQ(one.model.centers, three.model.centers);
    EXPECT_EQ(one.model.coefficients, three.model.coefficients);
  }
}

// In a unit that is a million times larger or smaller, far from the origin, nothing changes but by
// rounding.
TEST(MeshlessApproximation, doesNotDependOnUnits)
{
  const TriangleMesh mesh = torus(40);
  const Values values = waves(mesh.points, 3.0);
  const MeshlessApproximation result = approximated(mesh, values, withFraction(0.1));
  for (const double unit : { 1e-6, 1e6 })
  {
    TriangleMesh scaled = mesh;
    scaled.points = (unit * mesh.points).colwise() + unit * Vector3d(3.0, 5.0, -4.0);
    const MeshlessApproximation other =
      approximated(scaled, unit * values.array() + unit, withFraction(0.1));
    EXPECT_NEAR(other.largestError, unit * result.largestError, 0.05 * other.largestError);
    EXPECT_TRUE(other.lost.empty());
  }
}

// Tetrahedra are approximated as triangles are, with what is critical there, here one vertex
// inside.
TEST(MeshlessApproximation, takesVolumes)
{
  const SimplicialMesh grid = tetrahedralGrid(10);
  const Values values = waves(grid.vertices, 4.0);
  const Index inside = 5 * 11 * 11 + 5 * 11 + 5;
  const auto onePoint = [&](const ValuesRef& of, const Execution&)
  {
    CriticalPoint point;
    point.position = grid.vertices.col(inside);
    point.input = inside;
    point.value = of[inside];
    point.persistence = rangeOf(of);
    return MeshCriticalPoints{ { point }, {} };
  };
  const ApproximationDomain domain{ grid.vertices, grid.simplices, onePoint, [](Index vertex) {
                                     return std::vector<Index>{ vertex - 1, vertex + 1 };
                                   } };
  for (const CenterSelection selection : { CenterSelection::Greedy, CenterSelection::LevelSets })
  {
    ApproximationParameters parameters = withFraction(0.2);
    parameters.centerSelection = selection;
    const MeshlessApproximation result = approximateMeshless(domain, values, parameters);
    EXPECT_EQ(result.starCount, 3);
    EXPECT_EQ(result.model.centers.cols(), 3 + 266);
    EXPECT_NEAR(result.values[inside], values[inside], 1e-11);
    EXPECT_LT(result.largestError, 0.05 * rangeOf(values));
  }
}

// Of whole numbers most stars have ties, which the order of the vertices breaks: the model itself
// has these critical points, evaluated by itself.
TEST(MeshlessApproximation, modelKeepsCriticalPointsWhereValuesAreLevel)
{
  const TriangleMesh mesh = octahedralSphere(20);
  const Values values = (6.0 * waves(mesh.points, 6.0)).array().round();
  ApproximationParameters parameters = withFraction(0.1);
  parameters.persistenceThreshold = 0.1;
  const MeshlessApproximation result = approximated(mesh, values, parameters);
  EXPECT_TRUE(result.lost.empty());
  const Values again = Field(result.model).evaluate(mesh.points, {}).values;
  const VertexTypes types = classifyVertices(topologyOf(mesh), again);
  ASSERT_GE(result.persistent.size(), 4U);
  for (const CriticalPoint& point : result.persistent)
  {
    EXPECT_EQ(types.types[point.input], point.type);
    EXPECT_EQ(static_cast<int>(types.multiplicities[point.input]), point.multiplicity);
  }
}

} // namespace
} // namespace SurfaceScalars
