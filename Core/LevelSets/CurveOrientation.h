#pragma once

#include "LevelSets.h"
#include "Orientation.h"

#include <algorithm>
#include <vector>

namespace SurfaceScalars
{

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
