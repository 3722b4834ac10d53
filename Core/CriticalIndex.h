#pragma once

#include "CriticalClassifier.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Makes types agree with the turns of the gradient of f~ around (Poincare and Hopf), which moves
 * with the centers of the fits, where Hessians are those of single ones:
 *
 * - a place around which the gradient does not turn is regular;
 * - one around which it turns otherwise than the Hessian says is uncertain, and so is one that
 *   circles around its parts type against the sum of these;
 * - what is left out has index 0 in total: a saddle and an extremum that are close to each other
 *   may be left out or uncertain together, one of them alone gets the type that the turns tell,
 *   unless it is on a ridge or f is too coarsely sampled there for its curvature to be seen.
 *
 * @param places all that there are, with their own indices first, completed
 */
void settleIndices(std::vector<TypedPoint>& points, const std::vector<RefinedPoint>& places);

} // namespace SurfaceScalars
