#pragma once

#include "CurveScore.h"
#include "ExactLevelSet.h"
#include "Functions.h"
#include "LevelSets.h"
#include "Torus.h"

#include <string>
#include <vector>

namespace SurfaceScalars::Truth
{

/// One function on one torus with twenty exact level sets, to which every run is compared.
struct TruthCase
{
  SpaceFunction function;
  Torus torus;
  double range;                  ///< of f
  std::vector<double> isoValues; ///< a percent of the range away from critical values
  std::vector<ExactLevelSet> exact;
};

TruthCase makeTruthCase(const SpaceFunction& function, Torus torus, int isoValueCount = 20);

/// The two functions on the closed and on the cut torus; made once.
const std::vector<TruthCase>& truthCases();

/// What is sampled, and how it is disturbed.
struct TruthSampling
{
  int pointCount = 20000;
  unsigned seed = 1;
  double pointNoise = 0.0; ///< standard deviation per coordinate, fraction of the diagonal
  double valueNoise = 0.0; ///< standard deviation, fraction of f's range
};

/// How well a run did; lengths in sampling steps.
struct TruthResult
{
  int isoValueCount = 0;
  int rightCount = 0; ///< iso-values with the right number of closed and of open curves
  CurveScore score;   ///< in steps
  double samplingStep = 0.0;
  double pointNoiseInSteps = 0.0;
  int neighborCount = 0;
  double seconds = 0.0;      ///< for tracing, without the graph
  std::string disagreements; ///< a line per wrong iso-value

  double rightFraction() const;
  void add(const TruthResult& other); ///< pools runs; keeps this run's step
};

/// Samples the case and traces its iso-values with the parameters, whose isoValues are replaced.
TruthResult runTruth(const TruthCase& truthCase, const TruthSampling& sampling,
  const ContourParameters& parameters = {});

/// "tilted height on the closed torus, 20000 points, seed 1"
std::string describe(const TruthCase& truthCase, const TruthSampling& sampling);

} // namespace SurfaceScalars::Truth
