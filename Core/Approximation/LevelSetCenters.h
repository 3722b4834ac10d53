#pragma once

#include "ApproximationDomain.h"
#include "CenterSum.h"

namespace SurfaceScalars
{

/**
 * The paper's centers (sec. 4): those of stars, and points spread over the level sets of the
 * uniform optimal partition where these cross edges (C_iso). If they leave more than a quarter of
 * the simplices uncovered, that share of the centers is spread over the corners of these (C_ls).
 *
 * The paper looks for them where the distortion map jumps. But without plateaus nothing is
 * uncovered there, and plateaus, which have critical points, are in no interval of the map
 * (Documentation/meshless-paper.md has figures).
 *
 * @param stars vertices at distinct places @param count of all centers, if there are as many places
 * @param tolerance of the coverage, above 0 and below 1
 */
ChosenCenters levelSetCenters(const ApproximationDomain& domain, const ValuesRef& values,
  const std::vector<Index>& stars, std::size_t count, double tolerance, const Execution& execution);

} // namespace SurfaceScalars
