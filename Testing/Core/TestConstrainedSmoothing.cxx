#include "ConstrainedSmoothing.h"
#include "Meshes.h"
#include "SmoothingQueries.h"
#include "SmoothingRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

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

// The extrema are as many as the smooth function has, for threshold 0 but for those that f has not,
// one minimum and one maximum for 1, and near them: at vertices of nearly its values.
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
    auto last = static_cast<std::size_t>(
      std::count_if(smooth.critical.points.begin(), smooth.critical.points.end(),
        [&](const CriticalPoint& point) { return point.type == type; }));
    for (const double threshold : { 0.0, 0.005, 0.05, 0.2, 1.0 })
    {
      parameters.persistenceThreshold = threshold;
      const SmoothedFunction result = smoothFunction(mesh, noisy, parameters);
      const std::vector<Index> kept = verticesOf(result.critical.points, type);
      const auto expected =
        std::count_if(smooth.critical.points.begin(), smooth.critical.points.end(),
          [&](const CriticalPoint& point)
          { return point.type == type && point.persistence >= threshold * range; });
      EXPECT_LE(kept.size(), last);
      last = kept.size();
      if (threshold > 0.0)
      {
        EXPECT_EQ(last, std::max<std::size_t>(1, static_cast<std::size_t>(expected)));
      }
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
  const auto expectTheSame = [&](const SmoothingParameters& parameters)
  {
    smoothFunction(mesh, 2.0 * noisy, parameters);
    const Values fresh = smoothFunction(smoothingMesh(torus.mesh), noisy, parameters).values;
    EXPECT_EQ(smoothFunction(mesh, noisy, parameters).values, fresh);
    EXPECT_EQ(smoothFunction(mesh, noisy, parameters).values, fresh);
  };
  SmoothingParameters parameters = with(SmoothingMethod::FeaturePreserving, 0.05);
  for (const EpsilonChoice choice : { EpsilonChoice::GCV, EpsilonChoice::LCurve })
  {
    parameters.epsilonChoice = choice;
    expectTheSame(parameters);
    parameters.norms.metric = DataMetric::LumpedMass;
  }
  parameters.epsilonChoice = EpsilonChoice::Manual;
  for (const double epsilon : { 1e4, 1e6, 1e5 })
  {
    parameters.epsilon = epsilon;
    expectTheSame(parameters);
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
