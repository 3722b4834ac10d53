#include "ConstrainedSmoothing.h"
#include "Meshes.h"
#include "Sampling.h"
#include "SmoothingQueries.h"
#include "SmoothingRun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace SurfaceScalars::Truth
{
namespace
{

// Every component keeps its own lowest and highest vertex, also one on which f varies little, and
// one on which it does not vary.
TEST(ConstrainedSmoothing, keepsExtremaOfEachComponent)
{
  const TriangleMesh small = subdividedSphere(3);
  const TriangleMesh all = besideEachOther(besideEachOther(subdividedSphere(4), small), small);
  const SmoothingMesh mesh = smoothingMesh(all);
  Values values = all.points.row(2);
  const Eigen::Index each = small.points.cols();
  values.tail(each).setConstant(0.3);
  values.tail(2 * each).head(each) *= 1e-3;
  const SmoothedFunction result =
    smoothFunction(mesh, values, with(SmoothingMethod::FeaturePreserving, 1.0));
  expectEqual(result.outputCounts, { 3, 0, 3 });
  expectEqual(countsOf(meshCriticalPoints(all, result.values)), { 3, 0, 3 });
}

// A constant comes back as it is, its critical points those of the order of the vertices; four
// vertices are enough.
TEST(ConstrainedSmoothing, returnsConstants)
{
  const TriangleMesh sphere = subdividedSphere(2);
  const Values constant = Values::Constant(sphere.points.cols(), 2.5);
  for (const SmoothingMethod method :
    { SmoothingMethod::FeaturePreserving, SmoothingMethod::Tikhonov,
      SmoothingMethod::InterpolatingConstraints, SmoothingMethod::LeastSquaresConstraints })
  {
    const SmoothedFunction result = smoothFunction(smoothingMesh(sphere), constant, with(method));
    EXPECT_EQ(result.values, constant);
    expectEqual(result.outputCounts, countsOf(meshCriticalPoints(sphere, constant)));
    EXPECT_EQ(result.seminorm, 0.0);
  }
}

TEST(ConstrainedSmoothing, worksOnATetrahedron)
{
  TriangleMesh tetrahedron;
  tetrahedron.points.resize(3, 4);
  tetrahedron.points << 1, -1, -1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
  tetrahedron.triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
  const SmoothingMesh mesh = smoothingMesh(tetrahedron);
  Values values(4);
  values << 0.0, 1.0, 3.0, 2.0;
  for (const SmoothingMethod method :
    { SmoothingMethod::FeaturePreserving, SmoothingMethod::Tikhonov,
      SmoothingMethod::InterpolatingConstraints, SmoothingMethod::LeastSquaresConstraints })
  {
    const SmoothedFunction result = smoothFunction(mesh, values, with(method));
    EXPECT_TRUE(result.values.allFinite());
    expectEqual(result.outputCounts, { 1, 0, 1 });
  }
}

// On a square, with boundary: Euler's formula, in which points on the boundary count half, holds,
// and the extrema are those of the function without noise.
TEST(ConstrainedSmoothing, worksOnABoundary)
{
  const TriangleMesh square = gridMesh(Grid::Patch, 60, 60);
  const SmoothingMesh mesh = smoothingMesh(square);
  const SpaceFunction bump{ "bump",
    [](const Vector3d& p)
    { return std::sin(2.0 * Pi * p.x()) * std::sin(2.0 * Pi * p.y()) + p.x(); },
    {} };
  Values values = valuesOf(bump, square.points);
  const SmoothedFunction clean =
    smoothFunction(mesh, values, with(SmoothingMethod::FeaturePreserving, 0.05));
  const SmoothingCase noisySquare("square", square, bump, 0.05);
  values = noisySquare.noisy(0.03, 6);
  const SmoothedFunction result =
    smoothFunction(mesh, values, with(SmoothingMethod::FeaturePreserving, 0.05));
  EXPECT_EQ(result.outputCounts.minima, clean.outputCounts.minima);
  EXPECT_EQ(result.outputCounts.maxima, clean.outputCounts.maxima);
  int doubledIndex = 0;
  for (const CriticalPoint& point : result.critical.points)
  {
    const bool isBoundary = mesh.topology().isBoundary(static_cast<Index>(point.input));
    doubledIndex += (isBoundary ? 1 : 2) * indexOf(point);
  }
  EXPECT_EQ(doubledIndex, 2);
}

// Where a minimum would move to a vertex at which a maximum remains, it remains too.
TEST(ConstrainedSmoothing, movesNoExtremumOntoAnother)
{
  const auto smoothNoise = [](int count, unsigned seed, double epsilon)
  {
    const TriangleMesh square = gridMesh(Grid::Patch, count, count);
    Values noise = Values::Zero(square.points.cols());
    addNoise(noise, 0.3, seed);
    SmoothingParameters parameters;
    parameters.epsilonChoice = EpsilonChoice::Manual;
    parameters.epsilon = epsilon;
    return smoothFunction(smoothingMesh(square), noise, parameters);
  };
  for (const auto& [count, seed, epsilon] :
    { std::tuple{ 10, 1u, 1e4 }, std::tuple{ 20, 9u, 1e4 }, std::tuple{ 30, 15u, 1e5 } })
  {
    const SmoothedFunction result = smoothNoise(count, seed, epsilon);
    EXPECT_GE(result.outputCounts.minima, 1u);
    EXPECT_LE(result.outputCounts.minima, result.inputCounts.minima);
    EXPECT_GE(result.outputCounts.maxima, 1u);
    EXPECT_LE(result.outputCounts.maxima, result.inputCounts.maxima);
  }
}

// A slope on a square has one minimum and one maximum, and so has the result: what rings at the
// boundary is no feature.
TEST(ConstrainedSmoothing, addsNoneToASlope)
{
  for (const int count : { 20, 40, 60 })
  {
    const TriangleMesh square = gridMesh(Grid::Patch, count, count);
    const SmoothedFunction result = smoothFunction(smoothingMesh(square), square.points.row(0), {});
    EXPECT_EQ(result.outputCounts.minima, 1u) << count;
    EXPECT_EQ(result.outputCounts.saddles, 0u) << count;
    EXPECT_EQ(result.outputCounts.maxima, 1u) << count;
  }
}

// There are never more extrema than before, nor on closed meshes, by Euler's formula, more saddles.
TEST(ConstrainedSmoothing, addsNone)
{
  for (const TriangleMesh& mesh : { gridMesh(Grid::Torus, 60, 30), subdividedSphere(5) })
  {
    const SmoothingMesh smoothing = smoothingMesh(mesh);
    for (const SpaceFunction& function : { waves(), tiltedHeight() })
    {
      const Values clean = valuesOf(function, mesh.points);
      for (const double noise : { 0.0, 1e-6, 0.1 })
      {
        Values values = clean;
        addNoise(values, noise, 1);
        const SmoothedFunction result = smoothFunction(smoothing, values, {});
        EXPECT_LE(result.outputCounts.minima, result.inputCounts.minima);
        EXPECT_LE(result.outputCounts.saddles, result.inputCounts.saddles);
        EXPECT_LE(result.outputCounts.maxima, result.inputCounts.maxima);
      }
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
