#pragma once

#include "NeighborGraph.h"

namespace SurfaceScalars
{

// What polynomials over tangent planes need of their samples. All throw InvalidInput.

/// One finite value per point.
void checkSampleValues(const ValuesRef& values, const NeighborGraph& graph);

/// Enough points and, unless it is 0, a large enough NeighborCount for polynomials of this degree.
void checkPointCount(const NeighborGraph& graph, int degree, int neighborCount);

/// The samples must spread over a surface: on a line they determine neither normals nor curves.
/// Told by the directions to neighbors, not by the shape of the whole, which one stray point can
/// stretch.
void checkSpread(const NeighborGraph& graph);

} // namespace SurfaceScalars
