#pragma once

#include "CriticalScore.h"
#include "Functions.h"
#include "FuzzyCriticalPoints.h"
#include "Surfaces.h"
#include "TruthRun.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/// A function on a closed surface with its exact critical points.
struct CriticalCase
{
  ClosedSurface surface;
  SpaceFunction function;
  std::vector<CriticalPoint> exact;
  double range; ///< of f

  CriticalCase(ClosedSurface on, SpaceFunction of);
};

/// Samples of a case, undisturbed and disturbed.
struct CriticalSamples
{
  Points exactPoints;
  Points points;
  Values values;
  double samplingStep; ///< of the undisturbed points

  CriticalSamples(const CriticalCase& criticalCase, const TruthSampling& sampling);
};

/// What one run found, or several together.
struct CriticalResult
{
  CriticalScore score; ///< errors in sampling steps
  int runCount = 0;
  int rightIndexSums = 0; ///< runs whose index sum is the Euler characteristic
  int neighborCount = 0;
  double seconds = 0.0; ///< for the critical points, without the graph
  double graphSeconds = 0.0;

  void add(const CriticalResult& other);
};

CriticalResult runCritical(const CriticalCase& criticalCase, const TruthSampling& sampling);

/// The same for the seeds 1 to `seeds` of points and noise.
CriticalResult runSeeds(const CriticalCase& criticalCase, TruthSampling sampling, unsigned seeds);

/// Tilted height on the sphere and on the torus, cos 3u cos 2v on the torus; made once.
const std::vector<CriticalCase>& criticalCases();

} // namespace SurfaceScalars::Truth
