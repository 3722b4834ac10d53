#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"
#include "TruthRun.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace SurfaceScalars::Truth
{
namespace
{

/// 100,000 samples on all tori, disturbed.
TruthResult runNoisy(double pointNoise, double valueNoise)
{
  TruthSampling sampling;
  sampling.pointCount = 100000;
  sampling.pointNoise = pointNoise;
  sampling.valueNoise = valueNoise;
  TruthResult all;
  for (const TruthCase& truthCase : truthCases())
  {
    const TruthResult result = runTruth(truthCase, sampling);
    std::cout << describe(truthCase, sampling) << ": right " << result.rightCount << " of "
              << result.isoValueCount << ", mean " << result.score.pointMean() << ", k "
              << result.neighborCount << "\n"
              << result.disagreements;
    all.add(result);
  }
  return all;
}

// Averaging over enough neighbors removes most noise: with normal noise on the points, the curves
// are right for 90% of the iso-values and in the mean closer to the exact ones than 0.3 of its
// standard deviation.
TEST(LevelSetsNoise, isReducedOnPoints)
{
  for (const double noise : { 0.005, 0.01 })
  {
    const TruthResult result = runNoisy(noise, 0.0);
    EXPECT_GE(result.rightFraction(), 0.9) << noise;
    EXPECT_LE(result.score.pointMean(), 0.3 * result.pointNoiseInSteps) << noise;
  }
}

// The same for noise of 1% of the range on f: within 0.35 sampling steps in the mean.
TEST(LevelSetsNoise, isReducedOnValues)
{
  const TruthResult result = runNoisy(0.0, 0.01);
  EXPECT_GE(result.rightFraction(), 0.9);
  EXPECT_LE(result.score.pointMean(), 0.35);
}

// With too few neighbors for the noise curves may break or multiply, but none runs on and on:
// together they are not much longer than the circles they stand for.
TEST(LevelSetsNoise, tooFewNeighborsDoNotRunAway)
{
  const auto squaredRadius = [](const Vector3d& p) { return p.squaredNorm(); };
  for (const unsigned seed : { 1u, 2u, 3u })
  {
    const Points points = randomPlane(20000, seed);
    Values values = valuesOf(squaredRadius, points);
    addNoise(values, 0.02, seed + 1);
    for (const int neighborCount : { 8, 24, 50, 100 })
    {
      ContourParameters parameters = at({ 0.09, 0.25, 0.49 });
      parameters.neighborCount = neighborCount;
      std::vector<double> lengths(3, 0.0);
      for (const LevelSetCurve& curve : trace(points, values, parameters).levelSets.curves)
      {
        lengths[curve.level] += curve.length;
      }
      for (std::size_t level = 0; level < 3; ++level)
      {
        const double circumference = 2.0 * Pi * std::sqrt(parameters.isoValues[level]);
        EXPECT_LT(lengths[level], 5.0 * circumference) << neighborCount << ", " << seed;
      }
    }
  }
}

// However noise turns and joins curves, along most of each closed one larger values lie to the
// left.
TEST(LevelSetsNoise, leavesLargerValuesToTheLeft)
{
  const SpaceFunction function = tiltedHeight();
  const Points exact = randomTorus(8000, Torus::Closed, 3);
  Values values = valuesOf(function, exact);
  Points points = exact;
  addNoise(points, 0.01, 4);
  ContourParameters parameters = at({});
  for (int i = 1; i < 80; ++i)
  {
    parameters.isoValues.push_back(-1.0 + 0.025 * i);
  }
  parameters.neighborCount = 20; // too few for the noise: curves break, wind and are joined
  const Traced traced = trace(points, values, parameters);
  int closed = 0;
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    double left = 0.0;
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      const LevelSetPoint& here = curve.points[i];
      const Vector3d chord = curve.points[(i + 1) % curve.points.size()].position - here.position;
      left += here.normal.cross(chord).dot(function.gradient(here.position));
    }
    closed += curve.closed ? 1 : 0;
    EXPECT_TRUE(!curve.closed || left > 0.0) << curve.level << ", " << curve.component;
  }
  EXPECT_GT(closed, 50);
}

} // namespace
} // namespace SurfaceScalars::Truth
