#pragma once

#include "CriticalModel.h"

#include <vector>

namespace SurfaceScalars
{

/// Where a fit sees a critical point.
struct CriticalCandidate
{
  Vector3d place; ///< relative to the cloud of the scale
  double reach;   ///< radius of the fit
  double
    offset; ///< from the center of the fit, in radii: the smaller, the more it is to be trusted
};

struct CriticalSweep
{
  SampleCriticality samples;
  Values values;                             ///< f~ at the samples
  std::vector<CriticalCandidate> candidates; ///< in the order of the samples
};

/**
 * f~ at all samples, and where it seems to be critical. A fit serves the samples around its center:
 * a run along the Morton order that is short compared with the fit's radius.
 */
CriticalSweep sweepSamples(const NeighborGraph& graph, const CriticalScale& scale,
  ProbabilityModel probabilityModel, const Execution& execution);

} // namespace SurfaceScalars
