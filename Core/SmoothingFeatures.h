#pragma once

#include "ConstrainedFunction.h"
#include "ConstrainedSmoothing.h"
#include "FeatureMatching.h"

#include <vector>

namespace SurfaceScalars
{

/// f and what smoothing made of it.
struct SmoothingData
{
  const SmoothingMesh& mesh;
  const ValuesRef& input;
  Values smooth;             ///< Tikhonov's; empty where it is not needed
  ExtremalVertices promised; ///< those that FeaturePreserving keeps, by vertex
  double range;              ///< of the input
};

ExtremalVertices extremaOf(const std::vector<CriticalPoint>& points);

/// The extrema of the smooth function that are to be kept, and those of each component.
ExtremalVertices extremaToKeep(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

/**
 * Extrema of the smooth function, moved to where a function smoothed further has them: where
 * steepest steps lead from there. Those from which they lead to the same place remain where they
 * are, those whose value in the smooth function would differ by more than the tolerance, and those
 * that would get to a vertex, or as a minimum or maximum next to one, that another has.
 */
ExtremalVertices placed(const SmoothingData& data, const ExtremalVertices& extrema,
  const Values& further, double tolerance);

/// The values asked for at constrained vertices, by vertex.
std::vector<ValueConstraint> constraintsOf(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

} // namespace SurfaceScalars
