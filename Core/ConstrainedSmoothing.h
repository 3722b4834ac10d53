#pragma once

#include "ConstrainedFunction.h"
#include "MeshCriticalPoints.h"
#include "ParameterCurve.h"

#include <map>
#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// The numbers are fixed.
enum class SmoothingMethod
{
  FeaturePreserving = 0,
  Tikhonov = 1,
  InterpolatingConstraints = 2,
  LeastSquaresConstraints = 3
};

/// Which vertices keep their values. The numbers are fixed.
enum class ConstraintChoice
{
  AllCriticalPoints = 0,
  DeltaSimplified = 1,
  Persistent = 2,
  MaskArray = 3
};

struct SmoothingParameters
{
  SmoothingMethod method = SmoothingMethod::FeaturePreserving;
  LaplacianWeights weights = LaplacianWeights::Cotangent;
  DataMetric metric = DataMetric::Identity;
  SmoothingEnergy energy = SmoothingEnergy::Biharmonic;
  EpsilonChoice epsilonChoice = EpsilonChoice::GCV;
  double epsilon = 1e5; ///< if chosen by hand
  ConstraintChoice constraints = ConstraintChoice::Persistent;
  double persistenceThreshold = 0.0; ///< fractions of f's range
  double delta = 0.0;
  std::vector<char> mask;     ///< per vertex, for MaskArray
  bool includeOneStars = true;
  bool smoothedStars = true; ///< star values from smoothed f
};

/// A mesh and what is worth keeping between runs on it: topology, Laplacians, factors.
class SURFACESCALARSCORE_EXPORT SmoothingMesh
{
public:
  SmoothingMesh(Points vertices, const Triangles& triangles, const Execution& execution = {},
    const VertexName& nameOf = {});

  const Points& vertices() const;
  const MeshTopology& topology() const;
  /// Made when first asked for.
  const TikhonovSmoother& smoother(LaplacianWeights weights, DataMetric metric,
    SmoothingEnergy energy, const Execution& execution = {}) const;
};

struct SmoothedFunction
{
  Values values;
  double epsilon = 0.0;
  ParameterCurve curve; ///< empty if epsilon was chosen by hand
  MeshCriticalPoints critical; ///< of values, classified again
  CriticalCounts inputCounts;
  CriticalCounts outputCounts;
  double largestError = 0.0; ///< max |values - f|
  double seminorm = 0.0;     ///< sqrt of the energy of values
  std::vector<Index> lost; ///< vertices of f's persistent critical points without a counterpart
};

/**
 * Smooths f on a mesh (smoothing paper, sec. 4) and keeps its features.
 *
 * FeaturePreserving: Tikhonov smoothing; the extrema of the smooth function whose persistence is at least
 * the threshold; keepExtrema() of these: no other critical points but the saddles that Euler's
 * formula asks for. (...)
 */
SURFACESCALARSCORE_EXPORT SmoothedFunction smoothFunction(const SmoothingMesh& mesh,
  const ValuesRef& values, const SmoothingParameters& parameters, const Execution& execution = {});

} // namespace SurfaceScalars
