#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// Corners of triangles, one triangle per column.
using Triangles = Eigen::Matrix<Index, 3, Eigen::Dynamic>;

} // namespace SurfaceScalars
