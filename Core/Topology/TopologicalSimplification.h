#pragma once

#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * A function close to f whose minima and maxima are exactly the given vertices. Saddles follow: as
 * many as Euler's formula asks for.
 *
 * An order of the vertices with these extrema comes from the sweeps of Tierny and Pascucci (2012);
 * then the function that is monotone along the edges in this order and whose largest difference
 * from f is least: pits and the passes to them meet half way instead of being filled. No plateau is
 * left to chance: classifyVertices() finds these extrema in the values as they are.
 *
 * - If the given extrema are those of at least some persistence, no value changes by more than the
 *   largest persistence that is cancelled, usually by at most half of it, and those of the given
 *   extrema not at all (but for some units in the last place of the largest magnitude).
 * - If all extrema of f are given, nothing changes.
 * - A given minimum that is none is lowered to its lowest neighbor first; a maximum is lifted.
 *
 * Time O(n log n), of the order of sorting the values.
 *
 * @param values one per vertex, finite, at most half of the largest double in magnitude
 * @param minima vertices, at least one in every component; maxima likewise; in any order
 * @throws InvalidInput unless it is so, and for a vertex or two neighbors that shall both be
 * minima, or both be maxima, or one vertex that shall be both; Aborted
 */
SURFACESCALARSCORE_EXPORT Values keepExtrema(const MeshTopology& mesh, const ValuesRef& values,
  const std::vector<Index>& minima, const std::vector<Index>& maxima,
  const Execution& execution = {}, const VertexName& nameOf = {});

} // namespace SurfaceScalars
