#pragma once

#include "CrossedCells.h"

#include <vector>

namespace SurfaceScalars
{

/// The curve that f, linear on triangles, makes of one of the ascending levels. What it is made of
/// must outlive it.
struct LevelCurve
{
  const PointsRef& vertices;
  const ValuesRef& values;
  const std::vector<Index>& ranks; ///< of the values among the levels
  Index level;
  double isoValue; ///< of the level

  template <class Corners>
  bool meets(const Corners& corners) const
  {
    return rankRange(this->ranks, corners).crosses(this->level);
  }
  bool isAbove(Index vertex) const { return this->ranks[vertex] > this->level; }

  /// Of a triangle that the curve meets: the corner that is alone on its side, and the others.
  template <class Corners>
  Eigen::Matrix<Index, 3, 1> aloneFirst(const Corners& corners) const
  {
    const auto above = [&](int i) { return this->isAbove(corners[i]); };
    const int alone = above(0) == above(1) ? 2 : above(0) == above(2) ? 1 : 0;
    return { corners[alone], corners[(alone + 1) % 3], corners[(alone + 2) % 3] };
  }

  /// Where it meets an edge.
  Vector3d place(Index from, Index to) const
  {
    return crossingOf(this->vertices, this->values, from, to, this->isoValue);
  }
};

} // namespace SurfaceScalars
