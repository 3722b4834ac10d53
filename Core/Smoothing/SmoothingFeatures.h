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
  std::vector<char> asked;   ///< extrema of the input to keep, by vertex; empty: of the smooth one
};

/// Where the extrema of the input are that MaskArray and DeltaSimplified choose, as
/// SmoothingData::asked; empty for others, which choose extrema of the smooth function.
std::vector<char> askedOfInput(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

/// The extrema of the smooth function that are to be kept, and those of each component: those that
/// are asked for of the input, here or elsewhere (FeatureMatching.h); else the chosen ones but for
/// those without a counterpart in the input: smoothing adds some, by ringing.
ExtremalVertices extremaToKeep(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

/// The values asked for at constrained vertices, by vertex.
std::vector<ValueConstraint> constraintsOf(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution);

} // namespace SurfaceScalars
