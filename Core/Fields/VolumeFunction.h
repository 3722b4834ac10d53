#pragma once

#include "Basics.h"

#include <functional>

namespace SurfaceScalars
{

/// A function of space at a place (in the caller's coordinates), and its gradient if asked for (not
/// null).
using VolumeFunction = std::function<double(const Vector3d& place, Vector3d* gradient)>;

} // namespace SurfaceScalars
