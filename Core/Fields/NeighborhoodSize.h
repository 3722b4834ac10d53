#pragma once

#include "PointCloud.h"

namespace SurfaceScalars
{

/// Neighbors of a fit of degree 2 where there is no noise.
constexpr int UsualNeighborCount = 28;

/**
 * The number of neighbors for local fits of a degree, from sampling and noise: the one with the
 * smallest estimated mean square error of a level set's position at the median of sites spread over
 * the samples. The noise is what the best fit leaves over; its share in the error falls as 1/k;
 * what larger neighborhoods leave over in addition is their bias. Neighborhoods less than three
 * times as wide as the noise is thick say nothing about the surface and are not considered.
 *
 * @param values f at the points of the cloud, or empty: then only the surface is looked at
 */
int chooseNeighborCount(
  const PointCloud& cloud, const Values& values, int degree, const Execution& execution);

} // namespace SurfaceScalars
