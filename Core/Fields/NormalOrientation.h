#pragma once

#include "NeighborGraph.h"
#include "PolynomialNeighborhood.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/// Unit normals, of either sign, of the surface at the points of a graph: those of polynomials of
/// degree 2 over the tangent plane. Zero where the samples lie on a line. @throws Aborted
SURFACESCALARSCORE_EXPORT Points estimateNormals(
  const NeighborGraph& graph, const FitSize& size, const Execution& execution = {});

/**
 * Turns normals so that those of neighbors agree: along the spanning tree of the neighbor graph
 * with the smallest sum of 1 - |<n_i, n_j>|, which leaves out the edges across creases and between
 * sheets where it can (Hoppe et al. 1992). Each connected component of the graph as a whole is
 * turned as most of its points want it: away from the center of the points (see Orientation.h).
 *
 * Time O(e log e) for e edges; 12 bytes per edge. @throws Aborted
 */
SURFACESCALARSCORE_EXPORT void orientNormals(
  const NeighborGraph& graph, Points& normals, const Execution& execution = {});

} // namespace SurfaceScalars
