#pragma once

#include "CriticalClassifier.h"

#include <vector>

namespace SurfaceScalars
{

/// Counts the turns of the gradient on rings around points.
void encloseByRings(
  std::vector<RefinedPoint>& points, const CriticalScale& scale, const Execution& execution);

/**
 * Leaves out what the turns of the gradient of f~ around (Poincare and Hopf) do not agree with. It
 * moves with the centers of the fits, where Hessians are those of single ones:
 *
 * - a place around which the gradient does not turn is regular;
 * - one around which it turns otherwise than the Hessian says is uncertain;
 * - a point too close to its partner for both to be found is left out, too: a ring around it
 *   encloses less than what is found there.
 *
 * Points without such rings stay as they are.
 */
void settleIndices(std::vector<TypedPoint>& points);

} // namespace SurfaceScalars
