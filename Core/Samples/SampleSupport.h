#pragma once

#include "Basics.h"

#include <vector>

namespace SurfaceScalars
{

/// How samples lie around a place of a surface.
struct SampleSupport
{
  double nearest; ///< distance to the nearest
  double beyond;  ///< how far the place is beyond the edge of the surface, less than 0 inside: all
                  ///< samples, but for outliers, lie at least that far to one side
};

/**
 * @param samples indices of points around the place, at least one
 * @param normal of the surface there, unit
 */
SampleSupport measureSupport(const Points& points, const std::vector<Index>& samples,
  const Vector3d& place, const Vector3d& normal);

} // namespace SurfaceScalars
