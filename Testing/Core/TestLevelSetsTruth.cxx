#include "TruthRun.h"

#include <gtest/gtest.h>

#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

void expectAccurate(const TruthResult& result)
{
  EXPECT_LE(result.score.pointMean(), 0.01);
  EXPECT_LE(result.score.pointMaximum, 0.1);
  EXPECT_LE(result.score.exactMaximum, 0.1);
  EXPECT_LE(result.score.exactInnerMaximum, 0.1) << "further than 2 steps from the cut";
}

// Sample a torus at random, closed or cut open: for at least 99% of the iso-values that are a
// percent of the range away from critical values the number of curves is that of the exact level
// set, each closed or open as it should be.
TEST(LevelSetsTruth, findsTheRightCurvesAnywhere)
{
  TruthResult all;
  for (const TruthCase& truthCase : truthCases())
  {
    for (const int pointCount : { 5000, 20000 })
    {
      for (const unsigned seed : { 1u, 2u, 3u })
      {
        TruthSampling sampling;
        sampling.pointCount = pointCount;
        sampling.seed = seed;
        const TruthResult result = runTruth(truthCase, sampling);
        if (result.rightFraction() < 1.0)
        {
          std::cout << describe(truthCase, sampling) << "\n" << result.disagreements;
        }
        all.add(result);
      }
    }
  }
  EXPECT_GE(all.rightFraction(), 0.99) << all.disagreements;
}

/// One of truthCases().
class LevelSetsTruthOf : public testing::TestWithParam<int>
{
};

// With 100,000 samples the curves lie within 0.1 sampling steps of the exact level set, 0.01 in the
// mean, and cover it as closely.
TEST_P(LevelSetsTruthOf, isAccurateWithManySamples)
{
  const TruthCase& truthCase = truthCases()[static_cast<std::size_t>(GetParam())];
  TruthSampling sampling;
  sampling.pointCount = 100000;
  const TruthResult result = runTruth(truthCase, sampling);
  EXPECT_GE(result.rightFraction(), 0.99) << result.disagreements;
  expectAccurate(result);
}

std::string caseName(const testing::TestParamInfo<int>& info)
{
  return std::string(info.param < 2 ? "Height" : "Saddle") +
    (info.param % 2 == 0 ? "Closed" : "Cut");
}

INSTANTIATE_TEST_SUITE_P(Torus, LevelSetsTruthOf, testing::Range(0, 4), caseName);

} // namespace
} // namespace SurfaceScalars::Truth
