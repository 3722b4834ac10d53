#pragma once

#include "Basics.h"
#include "Execution.h"

#include <vector>

namespace SurfaceScalars
{

/// The order of points along a Morton curve through their bounding box. Equal points are adjacent,
/// in input order.
std::vector<Index> mortonOrder(const PointsRef& points, const Execution& execution);

} // namespace SurfaceScalars
