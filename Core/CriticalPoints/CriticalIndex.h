#pragma once

#include "CriticalClassifier.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Makes types agree with the turns of the gradient of f~ around, which moves with the centers of
 * the fits, where Hessians are those of single ones: a place around which the gradient does not
 * turn is regular, one around which it turns otherwise than the Hessian says is uncertain. Then
 * the indices of points next to each other are balanced, those of places included that no point
 * was made of.
 *
 * @param places all that there are, with their own indices first, completed
 */
void settleIndices(std::vector<TypedPoint>& points, const std::vector<RefinedPoint>& places,
  const CriticalScale& scale, const Execution& execution);

} // namespace SurfaceScalars
