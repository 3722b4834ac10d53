#pragma once

#include "LevelSets.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

inline bool isOutwards(const LevelSetPoint& point)
{
  return isOutwards(point.position, point.normal);
}

inline void orientOutwards(LevelSetPoint& point)
{
  if (!isOutwards(point))
  {
    point.normal = -point.normal;
  }
}

/// Turns a curve with consistent normals as a whole, as most of its points want it; larger values
/// stay to the left.
inline void orientOutwards(std::vector<LevelSetPoint>& curve)
{
  const auto outwards = std::count_if(
    curve.begin(), curve.end(), [](const LevelSetPoint& point) { return isOutwards(point); });
  if (2 * static_cast<std::size_t>(outwards) < curve.size())
  {
    std::reverse(curve.begin(), curve.end());
    for (LevelSetPoint& point : curve)
    {
      point.normal = -point.normal;
    }
  }
}

} // namespace SurfaceScalars
