#pragma once

#include "SurfaceScalarsCoreExport.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Signs along the link of a vertex that change a given number of times and agree with wanted
 * numbers as well as possible: the sum of sign times number is largest. By dynamic programming;
 * time O(link size * changes).
 *
 * @param wanted one number per vertex of the link
 * @param forced 1, -1, or 0 where the sign is free
 * @param isClosed whether the last vertex is next to the first
 * @param changes of sign; even if closed
 * @returns 1 or -1 for each; empty if there are no such signs
 */
SURFACESCALARSCORE_EXPORT std::vector<int> closestSigns(
  const std::vector<double>& wanted, const std::vector<int>& forced, bool isClosed, int changes);

} // namespace SurfaceScalars
