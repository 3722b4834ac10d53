#pragma once

#include "ExtremaSweep.h"

namespace SurfaceScalars
{

/**
 * Values near f that rise along every edge to the later vertex in the order. Of equal values the
 * vertex of higher index counts as the higher, so that classifyVertices() finds the types of the
 * order.
 *
 * A vertex gets the mean of the largest f on ascending paths to it and of the least f on ascending
 * paths from it: no function monotone along the edges has a lesser largest difference from f. A
 * given minimum keeps its value, a floor for all that is above it; so does a given maximum, if no
 * floor is higher. What is level then rises by the least step that the largest magnitude allows.
 *
 * @param values finite, at most half of the largest double in magnitude
 * @param signs of the extrema of the order
 * @throws Aborted
 */
Values fitMonotone(const MeshTopology& mesh, const VertexOrder& order, const ValuesRef& values,
  const ExtremumSigns& signs, const Execution& execution);

} // namespace SurfaceScalars
