#pragma once

#include "CurveTracer.h"

namespace SurfaceScalars
{

/**
 * Strings the samples of a level set along its traced curves, in their order: the curves of the
 * schemes whose samples are not on the curves that are traced (Linear, Unprojected). Samples closer
 * together than half a step give one point.
 */
std::vector<TracedCurve> threadSamples(
  const std::vector<TracedCurve>& curves, const std::vector<LevelSetPoint>& samples);

} // namespace SurfaceScalars
