#include "ConstrainedSmoothing.h"
#include "Meshes.h"
#include "SmoothingRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

SmoothingMesh smoothingMesh(const TriangleMesh& mesh)
{
  return SmoothingMesh(mesh.points, trianglesOf(mesh));
}

SmoothingParameters with(SmoothingMethod method, double threshold = 0.0)
{
  SmoothingParameters parameters;
  parameters.method = method;
  parameters.persistenceThreshold = threshold;
  return parameters;
}

std::vector<Index> verticesOf(const std::vector<CriticalPoint>& points, CriticalType type)
{
  std::vector<Index> result;
  for (const CriticalPoint& point : points)
  {
    if (point.type == type)
    {
      result.push_back(static_cast<Index>(point.input));
    }
  }
  return result;
}

void expectEqual(const CriticalCounts& a, const CriticalCounts& b)
{
  EXPECT_EQ(a.minima, b.minima);
  EXPECT_EQ(a.saddles, b.saddles);
  EXPECT_EQ(a.maxima, b.maxima);
}

double distance(const ValuesRef& a, const ValuesRef& b)
{
  return (a - b).lpNorm<Eigen::Infinity>();
}

class FeaturePreserving : public testing::TestWithParam<double>
{
};

INSTANTIATE_TEST_SUITE_P(Noise, FeaturePreserving, testing::Values(0.01, 0.05, 0.1));

double longestEdge(const TriangleMesh& mesh)
{
  double longest = 0.0;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    longest = std::max({ longest, (mesh.points.col(a) - mesh.points.col(b)).norm(),
      (mesh.points.col(b) - mesh.points.col(c)).norm(),
      (mesh.points.col(c) - mesh.points.col(a)).norm() });
  }
  return longest;
}

/// With four minima and four maxima on the sphere, all of them well curved.
SpaceFunction octants()
{
  return { "x y z + 0.05 x", [](const Vector3d& p) { return p.prod() + 0.05 * p.x(); }, {} };
}

// From noise with many times as many critical points come exactly the features of the function
// without it, each within the smoothing length of where it was, or an edge if that is longer;
// classified by brute force there is no other critical point, and nothing is called lost.
TEST_P(FeaturePreserving, findsTheFeaturesUnderNoise)
{
  const SmoothingCase sphere("sphere", subdividedSphere(5), octants(), 0.2);
  const SmoothingCase torus("torus", gridMesh(Grid::Torus, 100, 50), cosinesOfAngles(), 0.2);
  for (const SmoothingCase* one : { &sphere, &torus })
  {
    const SmoothingMesh mesh = smoothingMesh(one->mesh);
    const Values noisy = one->noisy(GetParam(), 1);
    const double threshold = one->threshold * one->range / (noisy.maxCoeff() - noisy.minCoeff());
    const SmoothedFunction result =
      smoothFunction(mesh, noisy, with(SmoothingMethod::FeaturePreserving, threshold));
    const SmoothingScore score = scoreOf(*one, result.values);
    EXPECT_GT(result.inputCounts.saddles, one->counts.saddles);
    EXPECT_TRUE(score.hasFeatures) << one->name;
    expectEqual(score.counts, result.outputCounts);
    EXPECT_LE(score.largestDistance,
      std::max(mesh.smoother({}).smoothingLength(result.epsilon), longestEdge(one->mesh)));
    EXPECT_TRUE(result.lost.empty());
    EXPECT_LT(score.meanSquareError, 0.7 * GetParam());
    EXPECT_EQ(result.largestError, distance(result.values, noisy));
  }
}

// The extrema are as many as the smooth function has, all for threshold 0, one minimum and one
// maximum for 1, and near them: at vertices of nearly its values.
TEST(ConstrainedSmoothing, keepsExtremaOfTheSmoothFunction)
{
  const SmoothingCase sphere("sphere", subdividedSphere(5), waves(), 0.06);
  const SmoothingMesh mesh = smoothingMesh(sphere.mesh);
  const Values noisy = sphere.noisy(0.05, 2);
  const double range = noisy.maxCoeff() - noisy.minCoeff();
  SmoothingParameters parameters = with(SmoothingMethod::Tikhonov);
  parameters.epsilonChoice = EpsilonChoice::Manual;
  parameters.epsilon = 1e7;
  const SmoothedFunction smooth = smoothFunction(mesh, noisy, parameters);
  EXPECT_GT(smooth.critical.points.size(), 30u);
  parameters.method = SmoothingMethod::FeaturePreserving;
  for (const CriticalType type : { CriticalType::Minimum, CriticalType::Maximum })
  {
    for (const double threshold : { 0.0, 0.01, 0.05, 0.2, 1.0 })
    {
      parameters.persistenceThreshold = threshold;
      const SmoothedFunction result = smoothFunction(mesh, noisy, parameters);
      const std::vector<Index> kept = verticesOf(result.critical.points, type);
      const auto expected =
        std::count_if(smooth.critical.points.begin(), smooth.critical.points.end(),
          [&](const CriticalPoint& point)
          { return point.type == type && point.persistence >= threshold * range; });
      EXPECT_EQ(kept.size(), std::max<std::size_t>(1, static_cast<std::size_t>(expected)));
      for (const Index vertex : kept)
      {
        EXPECT_NEAR(result.values[vertex], smooth.values[vertex], 0.05 * range);
      }
      EXPECT_LT(distance(result.values, smooth.values), (0.05 + 0.5 * threshold) * range);
    }
  }
}

// A spike of one vertex is no feature of the smooth function: it is named, whether or not it is the
// highest vertex of all.
TEST(ConstrainedSmoothing, namesWhatItLoses)
{
  const SmoothingCase sphere("sphere", subdividedSphere(5), tiltedHeight(), 0.5);
  const SmoothingMesh mesh = smoothingMesh(sphere.mesh);
  for (const double height : { 0.8, 5.0 })
  {
    Values spiked = sphere.noisy(0.01, 3);
    const Index spike = 1000;
    spiked[spike] += height * sphere.range;
    SmoothingParameters parameters = with(SmoothingMethod::FeaturePreserving, 0.05);
    parameters.epsilonChoice = EpsilonChoice::Manual;
    parameters.epsilon = 1e6;
    const SmoothedFunction result = smoothFunction(mesh, spiked, parameters);
    EXPECT_EQ(result.lost, std::vector<Index>{ spike }) << height;
  }
}

// Without noise the features are found as they are, and what is removed is less than the threshold.
TEST(ConstrainedSmoothing, losesNothingWithoutNoise)
{
  const SmoothingCase sphere("sphere", subdividedSphere(5), waves(), 0.06);
  const SmoothedFunction result = smoothFunction(smoothingMesh(sphere.mesh), sphere.clean,
    with(SmoothingMethod::FeaturePreserving, sphere.threshold));
  EXPECT_TRUE(result.lost.empty());
  EXPECT_TRUE(scoreOf(sphere, result.values).hasFeatures);
  EXPECT_LT(result.largestError, sphere.threshold * sphere.range);
}

// f + constant and scaling of f change nothing but the values; the unit of length nothing at all.
TEST(ConstrainedSmoothing, dependsOnNoUnit)
{
  const SmoothingCase torus("torus", gridMesh(Grid::Torus, 60, 30), waves(), 0.06);
  const SmoothingMesh mesh = smoothingMesh(torus.mesh);
  TriangleMesh large = torus.mesh;
  large.points *= 1000.0;
  const SmoothingMesh largeMesh = smoothingMesh(large);
  const Values noisy = torus.noisy(0.05, 4);
  for (const LaplacianWeights weights : { LaplacianWeights::Cotangent,
         LaplacianWeights::NormalizedCotangent, LaplacianWeights::MeanValue })
  {
    for (const DataMetric metric :
      { DataMetric::Identity, DataMetric::MassMatrix, DataMetric::LumpedMass })
    {
      for (const SmoothingEnergy energy :
        { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
      {
        SmoothingParameters parameters = with(SmoothingMethod::FeaturePreserving, 0.05);
        parameters.norms = { weights, metric, energy };
        parameters.epsilonChoice = EpsilonChoice::Manual;
        parameters.epsilon = energy == SmoothingEnergy::Harmonic ? 1e3 : 1e5;
        const SmoothedFunction result = smoothFunction(mesh, noisy, parameters);
        EXPECT_LT(result.largestError, 0.5 * torus.range);
        const SmoothedFunction shifted =
          smoothFunction(mesh, 8.0 * noisy + Values::Constant(noisy.size(), 100.0), parameters);
        EXPECT_LT(
          distance(shifted.values, 8.0 * result.values + Values::Constant(noisy.size(), 100.0)),
          1e-6);
        expectEqual(shifted.outputCounts, result.outputCounts);
        const SmoothedFunction enlarged = smoothFunction(largeMesh, noisy, parameters);
        EXPECT_LT(distance(enlarged.values, result.values), 1e-6);
        expectEqual(enlarged.outputCounts, result.outputCounts);
      }
    }
  }
}

// What a mesh keeps between runs changes nothing: a run after others is that on a new mesh.
TEST(ConstrainedSmoothing, isTheSameAfterOtherRuns)
{
  const SmoothingCase torus("torus", gridMesh(Grid::Torus, 60, 30), waves(), 0.06);
  const SmoothingMesh mesh = smoothingMesh(torus.mesh);
  const Values noisy = torus.noisy(0.05, 5);
  SmoothingParameters parameters = with(SmoothingMethod::FeaturePreserving, 0.05);
  parameters.epsilonChoice = EpsilonChoice::Manual;
  for (const double epsilon : { 1e4, 1e6, 1e5 })
  {
    parameters.epsilon = epsilon;
    smoothFunction(mesh, 2.0 * noisy, parameters);
    const SmoothedFunction again = smoothFunction(mesh, noisy, parameters);
    EXPECT_EQ(again.values, smoothFunction(smoothingMesh(torus.mesh), noisy, parameters).values);
  }
}

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

} // namespace
} // namespace SurfaceScalars::Truth
