#pragma once

#include "ApproximationDomain.h"
#include "VolumeTopology.h"

namespace SurfaceScalars
{

/**
 * A volume as the domain of an approximation.
 *
 * With a threshold above 0, only saddles that end an extremum of more persistence are persistent:
 * how persistent the others are, which begin or end tunnels, is not computed
 * (volumeCriticalPoints()), and in noise there are many of them. With a threshold of 0 all are.
 *
 * @param vertices one place per vertex of the volume
 */
SURFACESCALARSCORE_EXPORT ApproximationDomain volumeDomain(
  const Points& vertices, const VolumeTopology& volume);

} // namespace SurfaceScalars
