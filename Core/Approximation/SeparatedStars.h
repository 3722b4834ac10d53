#pragma once

#include "ApproximationDomain.h"

namespace SurfaceScalars
{

/**
 * Values near f in which each of these critical vertices is at least 1e-7 of f's range above its
 * lower neighbors and below its higher ones, ties by index. An approximation that meets them but
 * for rounding errors has these critical points, where f itself is level, as whole numbers are.
 *
 * Values rise by as little as that takes; those of other vertices remain.
 *
 * @param points critical vertices of the values
 */
Values withSeparatedStars(const ApproximationDomain& domain, const ValuesRef& values,
  const std::vector<CriticalPoint>& points);

} // namespace SurfaceScalars
