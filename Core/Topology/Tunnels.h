#pragma once

#include "VertexOrder.h"
#include "VolumeTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// A class of loops of {f <= t}, by the vertices at which it begins and ends.
struct Tunnel
{
  Index oneSaddle;
  Index twoSaddle;
};

/**
 * The pairs of dimension 1 of a function on a volume, over Z2: at its 1-saddle a loop closes that
 * bounds nothing, nor does with older ones, and at its 2-saddle it does. Those that begin and end
 * at one vertex and those that never end are left out.
 *
 * Simplices that come with the same vertex are paired first (LowerStarPairing), which leaves
 * triangles and edges about as many as there are saddles. Union-find along the tetrahedra takes the
 * triangles away that begin a void. The boundaries of the others are reduced as columns of the
 * boundary matrix are, where the pairs make the columns of all triangles that they contain
 * (Guillou, Vidal and Tierny 2023, sec. 4).
 *
 * Memory: 24 bytes per edge, 4 per tetrahedron and what the reduced boundaries take.
 *
 * @param order of the vertices
 * @param isRelative to the boundary: without the simplices on it. The pairs on a volume glued to
 * its mirror image are those of the volume and, if an image comes right after its vertex, with the
 * images in place of the vertices those relative to the boundary: the volume is a retract
 * @returns by twoSaddle, in the order
 * @throws Aborted
 */
std::vector<Tunnel> tunnelsOf(const VolumeTopology& volume, const VertexOrder& order,
  bool isRelative, const Execution& execution);

} // namespace SurfaceScalars
