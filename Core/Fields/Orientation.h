#pragma once

#include "Basics.h"

#include <cmath>

namespace SurfaceScalars
{

/**
 * Whether the normal at a place (relative to the center of the cloud) is turned the usual way: away
 * from the center, or, where it is nearly at right angles to that, with its largest component
 * positive (terrain: upwards).
 */
inline bool isOutwards(const Vector3d& position, const Vector3d& normal)
{
  const double outwards = normal.dot(position);
  if (std::abs(outwards) > 0.1 * position.norm())
  {
    return outwards > 0.0;
  }
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  return normal[largest] > 0.0;
}

} // namespace SurfaceScalars
