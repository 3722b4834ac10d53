#pragma once

#include "ExtremalVertices.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The persistent extrema of a function for which another function has none.
 *
 * A maximum of f of persistence p owns the component of {f > f(maximum) - p} in which it lies: it
 * is the highest there. If another function is nowhere farther than d from f and p > 2 d, it has a
 * maximum in that component, of persistence at least p - 2 d, and it has as many of these as there
 * are such maxima of f (stability of persistence). So each takes one of the given maxima in its
 * component, the first that no other has taken; one that finds none left is returned. Components
 * are nested or disjoint, and the inner ones choose first: the number returned is as small as
 * possible. Minima likewise.
 *
 * Where f is flat or noisy its extrema are far from those of the function without the noise: a
 * distance would say little, the component is what noise of that size cannot change.
 *
 * Time O(n log^2 n).
 *
 * @param values f, one per vertex, finite
 * @param persistence extrema of more than this are asked for; a component's lowest and highest
 * vertex have the component's range
 * @param isAsked one per vertex, 0 for extrema of f that are not asked for; empty: all are
 * @returns vertices: minima, then maxima, each ascending
 */
SURFACESCALARSCORE_EXPORT std::vector<Index> unmatchedExtrema(const MeshTopology& mesh,
  const ValuesRef& values, const ExtremalVertices& matches, double persistence,
  const std::vector<char>& isAsked = {}, const Execution& execution = {});

/// The given extrema that the extrema of f that are asked for take so, each ascending: those first
/// that are given first.
SURFACESCALARSCORE_EXPORT ExtremalVertices takenExtrema(const MeshTopology& mesh,
  const ValuesRef& values, const ExtremalVertices& matches, const std::vector<char>& isAsked,
  const Execution& execution = {});

/**
 * As many extrema of f as can have a counterpart for themselves, in the components that they own;
 * where there are more than counterparts, the most persistent ones. So they are at most as many as
 * the given ones, and the lowest and the highest vertex of a component are among them if it has
 * any. Time O(n log^2 n).
 *
 * @param values f, one per vertex, finite
 * @param matches extrema of the other function
 * @returns vertices, each ascending
 */
SURFACESCALARSCORE_EXPORT ExtremalVertices extremaWithCounterpart(const MeshTopology& mesh,
  const ValuesRef& values, const ExtremalVertices& matches, const Execution& execution = {});

} // namespace SurfaceScalars
