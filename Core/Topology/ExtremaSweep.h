#pragma once

#include "MeshTopology.h"
#include "VertexOrder.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * A strict order near the given one whose minima and maxima are exactly the given vertices: the
 * sweeps of Tierny and Pascucci (Generalized Topological Simplification of Scalar Fields on
 * Surfaces, 2012).
 *
 * A sweep visits the vertices from the minima upwards, always the lowest that is next to a visited
 * one: pits are entered over their rims, after which each vertex but the given has a lower
 * neighbor. Given maxima stay: a link is connected, and all of it lower. Then the same from the
 * maxima downwards, which can leave minima within what was one pit or peak. One round is usual, two
 * are what white noise takes; but narrow strips can take as many as they have vertices (no bound
 * was known). After a few rounds pits and peaks are therefore ordered by PitOrder, which leaves
 * neither minima nor maxima in them: one such round is enough, always.
 *
 * Time O(n), and O(log n) for each vertex in a pit or on a peak.
 *
 * @param order in which the given vertices are extrema; at least one of each in every component
 * @throws Aborted
 */
VertexOrder orderWithExtrema(const MeshTopology& mesh, VertexOrder order,
  const ExtremumSigns& signs, const Execution& execution);

} // namespace SurfaceScalars
