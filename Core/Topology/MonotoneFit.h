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
 * paths from it: no function monotone along the edges has a lesser largest difference from f. Some
 * vertices keep their values, which are floors for all that is above them and ceilings for what is
 * below; where a floor is above a ceiling, the ceiling holds. What is level then rises by the least
 * step that the largest magnitude allows.
 *
 * @param values finite, at most half of the largest double in magnitude
 * @param isKept not 0 for the vertices that keep their values
 * @throws Aborted
 */
Values fitMonotone(const MeshTopology& mesh, const VertexOrder& order, const ValuesRef& values,
  const ExtremumSigns& isKept, const Execution& execution);

} // namespace SurfaceScalars
