#pragma once

#include "LevelSets.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

inline double distanceToSegment(const Vector3d& place, const Vector3d& a, const Vector3d& b)
{
  const Vector3d along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((place - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (place - a - t * along).norm();
}

inline Points positionsOf(const std::vector<LevelSetPoint>& points)
{
  Points positions(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    positions.col(static_cast<Eigen::Index>(i)) = points[i].position;
  }
  return positions;
}

inline double polylineLength(const std::vector<LevelSetPoint>& points, bool closed)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i].position - points[i - 1].position).norm();
  }
  if (closed && !points.empty())
  {
    length += (points.front().position - points.back().position).norm();
  }
  return length;
}

} // namespace SurfaceScalars
