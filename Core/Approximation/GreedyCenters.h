#pragma once

#include "CenterSum.h"

namespace SurfaceScalars
{

/**
 * Centers where they are needed: those of stars, a cover of all vertices by a third of the others,
 * and in rounds the vertices where the sum through all of them misses f most, apart from each
 * other. All but the last rounds look at some vertices only, spread over all. In the end, centers
 * that others make up for are exchanged for vertices that are missed most, as long as that takes
 * little beside the rounds.
 *
 * @param stars vertices at distinct places @param count of all centers; fewer are chosen where the
 * sum is f to rounding, or there are no other places
 * @param sum is made anew in each round
 */
ChosenCenters greedyCenters(const Points& vertices, const ValuesRef& values,
  const std::vector<Index>& stars, std::size_t count, int dimension, CenterSum& sum,
  const Execution& execution);

} // namespace SurfaceScalars
