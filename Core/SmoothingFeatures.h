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
  Values smooth; ///< Tikhonov's; empty where it is not needed
  double range;  ///< of the input
};

ExtremalVertices extremaOf(const std::vector<CriticalPoint>& points);

/// The extrema of the smooth function that are to be kept, and those of each component.
ExtremalVertices extremaToKeep(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

/// The values asked for at constrained vertices, by vertex.
std::vector<ValueConstraint> constraintsOf(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

} // namespace SurfaceScalars
