#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// Corners of tetrahedra, one tetrahedron per column.
using Tetrahedra = Eigen::Matrix<Index, 4, Eigen::Dynamic>;

} // namespace SurfaceScalars
