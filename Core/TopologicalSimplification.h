#pragma once

#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// A function and a strict order of the vertices that agrees with it and decides ties.
struct OrderedFunction
{
  Values values;
  std::vector<Index> order; ///< vertices, ascending
};

/**
 * A function close to f whose minima and maxima are exactly the given ones, by the sweeps of Tierny
 * and Pascucci (2012): from the minima upwards in the order of the values, the values met lifted to
 * the highest before, then the same from the maxima down, until no other extrema are left. Saddles
 * follow: as many as Euler's formula asks for. Where f is changed the result is flat, and only the order says
 * up from down.
 *
 * @param values one per vertex, finite
 * @param minima at least one in every component, minima of f; maxima likewise
 * @throws InvalidInput ...; Error if extrema are left (named) after (some) rounds; Aborted
 */
SURFACESCALARSCORE_EXPORT OrderedFunction keepExtrema(const MeshTopology& mesh,
  const ValuesRef& values, const std::vector<Index>& minima, const std::vector<Index>& maxima,
  const Execution& execution = {});

/// The order written into the values: each the next double above the one before, or more, so that
/// classifying them again gives the types that the order gives.
SURFACESCALARSCORE_EXPORT Values strictValues(const OrderedFunction& function);

} // namespace SurfaceScalars
