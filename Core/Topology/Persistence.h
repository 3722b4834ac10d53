#pragma once

#include "CriticalPoint.h"
#include "NeighborGraph.h"
#include "SurfaceScalarsCoreExport.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// An extremum that vanishes at a saddle as the level passes it: two components of {f <= t}, or of
/// {f >= t}, become one there and the younger ends.
struct PersistencePair
{
  Index extremum;
  Index saddle;
  double persistence; ///< |f(saddle) - f(extremum)|
};

struct PersistencePairs
{
  std::vector<PersistencePair> minima; ///< by persistence, descending
  std::vector<PersistencePair> maxima;
};

/**
 * The extremum-saddle pairs of a function on the vertices of a graph, by union-find in the order of
 * the values, ties by index (design paper, sec. 2). Extrema that never vanish, one minimum and one
 * maximum per connected component, are in no pair.
 *
 * Time O(n log n), nearer to O(n) the smoother the function.
 *
 * @param values one per point of the graph, finite
 * @throws InvalidInput for another number of values; Aborted
 */
SURFACESCALARSCORE_EXPORT PersistencePairs persistencePairs(
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution = {});

/// Two critical points that cancel each other: indices into their list.
struct CriticalPair
{
  std::size_t extremum; ///< in volumes also a saddle, of the other kind
  std::size_t saddle;   ///< takes part in as many pairs as its multiplicity, at most
  double persistence;   ///< the difference of their values
};

/**
 * Gives critical points found off the samples their persistence. The components of {f <= t} and of
 * {f >= t} on the graph carry the critical extrema that lie in them; a saddle joins the components
 * around it at its own value, at which the younger extremum ends, and what it does not join is left
 * for the other sweep. Where the graph and the critical points differ:
 *
 * - extrema of the graph at which no critical point lies end unseen;
 * - an extremum whose component ends where there is no critical saddle, or in one that begins at a
 *   deeper sample that is not critical (at the boundary, say), has the graph's persistence;
 * - a second extremum in the same basin pairs with a saddle close by that is left over, or else
 *   has persistence 0;
 * - a saddle that only joins extrema of the graph has the largest persistence of those;
 * - one that joins nothing that the samples resolve has f's range if it is that of a handle: if a
 *   loop that descends from it on both sides, or one that rises, does not cut the surface in two.
 *   Otherwise it has the persistence of what is cut off (Jordan), or of the little that it joins;
 * - an uncertain point has the persistence of the graph's own extrema and merges close to it.
 *
 * The global extrema of a connected component have f's range, too. The persistence of a point in
 * several pairs is the largest.
 *
 * @param values f~ at the points of the graph, finite
 * @param reach of the fits that f~ is made of, in sampling steps: one centered at a critical point
 * and those around may see it a part of that apart
 * @returns the pairs of critical points, both known; removing a pair keeps the sum of the indices
 * @throws InvalidInput for another number of values; Aborted
 */
SURFACESCALARSCORE_EXPORT std::vector<CriticalPair> assignPersistence(
  std::vector<CriticalPoint>& points, const NeighborGraph& graph, const ValuesRef& values,
  double reach = 0.0, const Execution& execution = {});

/**
 * Removes the critical points of less persistence than `threshold` (f's unit): of a pair both, a
 * saddle of multiplicity m only after m pairs, until then its multiplicity falls. Results for
 * rising thresholds are nested.
 */
SURFACESCALARSCORE_EXPORT void removeBelow(
  std::vector<CriticalPoint>& points, const std::vector<CriticalPair>& pairs, double threshold);

} // namespace SurfaceScalars
