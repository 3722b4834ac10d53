#include "TruthRun.h"

#include <gtest/gtest.h>

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

// Averaging over enough neighbours removes most noise: with normal noise on the points, the curves
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

} // namespace
} // namespace SurfaceScalars::Truth
