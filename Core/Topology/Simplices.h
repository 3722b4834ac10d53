#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// Corners of edges (2 rows), triangles (3) or tetrahedra (4), one simplex per column. Triangles
/// are taken as they are.
using Simplices = Eigen::Matrix<Index, Eigen::Dynamic, Eigen::Dynamic>;
using SimplicesRef = Eigen::Ref<const Simplices>;

} // namespace SurfaceScalars
