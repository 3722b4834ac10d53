#pragma once

#include "ExtremumFit.h"
#include "FeatureMatching.h"

namespace SurfaceScalars
{

/**
 * Extrema of the smooth function, moved to where a function smoothed further has them: where
 * steepest steps lead from there; then to where fits over larger windows have them (ExtremumFit.h).
 * Neither step is made from which the value of the smooth function would differ by more than the
 * tolerance, to a place that steps from another extremum lead to as well, to a vertex that another
 * has, or as a minimum or maximum next to one.
 *
 * @param further one value per vertex
 */
ExtremalVertices placed(const NoisyFunction& function, const ExtremalVertices& extrema,
  const Values& further, double tolerance, const Execution& execution = {});

} // namespace SurfaceScalars
