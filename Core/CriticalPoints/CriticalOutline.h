#pragma once

#include "CriticalModel.h"
#include "CriticalRefinement.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

using PlaceList = std::vector<const RefinedPoint*>;

/**
 * The sum of the indices of places next to each other, in a row or a heap: the turns of the
 * gradient of f~ along an ellipse around all of them (Poincare and Hopf). Among ellipses more or
 * less close to them, that one counts on which the gradient exceeds its standard error the most,
 * for there an error of f~ is least likely to change its turns.
 *
 * @param group at least one place
 * @param others places nearby that are not in the group; they stay outside
 * @returns none where no ellipse stays on the surface, others are too close, or the row is long
 */
std::optional<int> indexAround(
  CriticalModel& model, const PlaceList& group, const PlaceList& others);

} // namespace SurfaceScalars
