#pragma once

#include "NeighborGraph.h"

namespace SurfaceScalars::Truth
{

inline NeighborQuery nearest(int count)
{
  return { count, 0.0 };
}

inline NeighborQuery within(double radius)
{
  return { 16, radius };
}

} // namespace SurfaceScalars::Truth
