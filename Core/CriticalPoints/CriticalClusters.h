#pragma once

#include "CriticalClassifier.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The critical points that refined places stand for, with their types: from the turns of the
 * gradient around where these are clear, or the eigenvalues of the Hessian where they can be told
 * from noise and from the change of the Hessian around; elsewhere
 * places close to each other are one degenerate point, split by the fits, whose type is counted on
 * circles around them. What these do not tell either is uncertain, or regular.
 */
std::vector<TypedPoint> clusterPoints(
  const std::vector<RefinedPoint>& points, const CriticalScale& scale, const Execution& execution);

} // namespace SurfaceScalars
