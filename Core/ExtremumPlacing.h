#pragma once

#include "FeatureMatching.h"

namespace SurfaceScalars
{

/**
 * Extrema of the smooth function, moved to where a function smoothed further has them: where
 * steepest steps lead from there. Those from which they lead to the same place remain where they
 * are, those whose value in the smooth function would differ by more than the tolerance, and those
 * that would get to a vertex, or as a minimum or maximum next to one, that another has.
 *
 * @param smooth one value per vertex, as is further
 */
ExtremalVertices placed(const MeshTopology& mesh, const Values& smooth,
  const ExtremalVertices& extrema, const Values& further, double tolerance);

} // namespace SurfaceScalars
