#pragma once

#include "ApproximationDomain.h"
#include "VolumeTopology.h"

namespace SurfaceScalars
{

/// A volume as the domain of an approximation.
/// @param vertices one place per vertex of the volume
SURFACESCALARSCORE_EXPORT ApproximationDomain volumeDomain(
  const Points& vertices, const VolumeTopology& volume);

} // namespace SurfaceScalars
