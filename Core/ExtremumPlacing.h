#pragma once

#include "ExtremumFit.h"
#include "FeatureMatching.h"

namespace SurfaceScalars
{

/**
 * Extrema of the smooth function, moved to where a function smoothed further has them: where
 * steepest steps lead from there; then to where fits over larger windows have them (ExtremumFit.h).
 * Those from which steps lead to the same place remain where they are, those whose value in the
 * smooth function would differ by more than the tolerance, and those that would get to a vertex, or
 * as a minimum or maximum next to one, that another has.
 *
 * @param further one value per vertex
 */
ExtremalVertices placed(const NoisyFunction& function, const ExtremalVertices& extrema,
  const Values& further, double tolerance, const Execution& execution = {});

} // namespace SurfaceScalars
