#pragma once

#include "CriticalClassifier.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Makes the indices of points next to each other sum to the index of an outline around all of them
 * (Poincare and Hopf), where the gradient of f~ is larger than among them: along ridges, and where
 * a saddle and an extremum are about to cancel, fits may find one of a pair only, or a point twice.
 *
 * Until the sum is right, the point of which least is to be seen becomes regular, or a regular one
 * around which the gradient turns, if more of that is to be seen, gets a type. Where outlines do
 * not tell, nothing changes.
 */
void balanceIndices(
  std::vector<TypedPoint>& points, const CriticalScale& scale, const Execution& execution);

} // namespace SurfaceScalars
