#pragma once

#include "CurveTracer.h"

namespace SurfaceScalars
{

/// The same curve the other way round: with the other side of the surface up, so that larger values
/// stay to the left.
void reverse(TracedCurve& curve);

/**
 * Joins the ends of curves of one level that face each other across less than a step: pieces of one
 * curve whose tracing was stopped by noise. A curve whose own ends meet becomes closed. Ends at
 * saddles stay.
 */
std::vector<TracedCurve> joinEnds(std::vector<TracedCurve> curves);

} // namespace SurfaceScalars
