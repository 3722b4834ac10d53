#pragma once

#include "CriticalPoint.h"
#include "SurfaceNewton.h"

#include <vector>

namespace SurfaceScalars
{

/// Where one search from a candidate leads.
struct Arrival
{
  SurfaceSearch search;
  int steps = 0; ///< of this search and those in vain before it
};

/// Where the searches from one candidate lead: to points of its type.
struct Arrivals
{
  std::vector<Arrival> found; ///< different ones
  double residual = 0.0;      ///< at the candidate itself
};

/// How far points may lie that are the same, length: a fraction of the spacing of the mesh.
double reachOf(const SurfaceSearch& search);

/**
 * Searches for critical points of u from each candidate, a critical vertex of the mesh: for one of
 * its type, or several if it is a saddle of that multiplicity. First from the vertex on the charts
 * next to the place, then on its own chart, then from its neighbors, until there are enough.
 * Critical vertices of the boundary are not searched from.
 *
 * @param tolerance of the tangential gradient; 0 = u is constant: no searches @throws Aborted
 */
std::vector<Arrivals> searchFromAll(const PointsRef& vertices, const MeshTopology& mesh,
  const Field& u, const std::vector<CriticalPoint>& candidates, double tolerance,
  const Execution& execution);

} // namespace SurfaceScalars
