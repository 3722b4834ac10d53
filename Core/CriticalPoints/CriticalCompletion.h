#pragma once

#include "CriticalRefinement.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Counts the turns of the gradient of f~ on rings around places and adds the places that these
 * rings enclose but candidates do not lead to: by Poincare and Hopf the index within a ring is the
 * sum of those of the places there, so where it is not, one is missing. Most often that is the
 * other one of a saddle and an extremum that are close to each other. Cells around which the
 * gradient turns tell where it is.
 *
 * Afterwards the first of the enclosed indices is that of the place itself: the indices of all
 * places sum to the Euler characteristic wherever rings are clear.
 */
void completePlaces(
  std::vector<RefinedPoint>& points, const CriticalScale& scale, const Execution& execution);

} // namespace SurfaceScalars
