#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

struct Ball
{
  Vector3d center;
  double radius = 0.0;
};

} // namespace SurfaceScalars
