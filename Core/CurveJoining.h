#pragma once

#include "CurveTracer.h"

namespace SurfaceScalars
{

/**
 * Joins the ends of curves of one level that face each other across less than a step: pieces of one
 * curve whose tracing was stopped by noise. A curve whose own ends meet becomes closed. Ends at
 * saddles stay.
 */
std::vector<TracedCurve> joinEnds(std::vector<TracedCurve> curves);

} // namespace SurfaceScalars
