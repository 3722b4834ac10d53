#pragma once

#include "Execution.h"
#include "MeshTopology.h"

namespace SurfaceScalars
{

/// A noisy function and what it was smoothed to, one value per vertex.
struct NoisyFunction
{
  const MeshTopology& mesh;
  const Points& vertices;
  const ValuesRef& values;
  const Values& smooth;
  double length; ///< that smooth was smoothed with
  double noise;  ///< its standard deviation
};

/**
 * Where the function without the noise has an extremum, to judge by more of the surface than what
 * smoothing averages over. A scalar is often a smooth function of the place in space (a height, a
 * distance, a field), rough only as the surface is, and the surface is known. Then a polynomial of
 * the coordinates tells the values of the vertices among each other with the noise of thousands of
 * them averaged out.
 *
 * Quadrics are fitted to the values on ever larger windows around the vertex, the largest of which
 * counts that agrees with all smaller ones as far as noise allows (Lepski, 1991): up to there f is
 * one. If that is less than six smoothing lengths, f is no such function there, and the vertex
 * remains.
 *
 * Of the vertices that a path leads to along which smooth is nearly the same, within half the
 * window, the one with the extreme value of the quadric is taken; or rather that nearest to the
 * mean of those within a smoothing length of it that may be as extreme, weighted by the likelihood:
 * which one it is, noise may not tell.
 *
 * @param vertex near the extremum
 * @param tolerance by which smooth may differ from that at the vertex
 * @param sign 1 for a maximum, -1 for a minimum
 */
SURFACESCALARSCORE_EXPORT Index fittedExtremum(
  const NoisyFunction& function, Index vertex, double tolerance, double sign, const Poll& poll);

} // namespace SurfaceScalars
