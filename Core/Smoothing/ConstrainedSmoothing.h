#pragma once

#include "MeshCriticalPoints.h"
#include "ParameterCurve.h"
#include "SmoothingMesh.h"

#include <vector>

namespace SurfaceScalars
{

/// The numbers are fixed.
enum class SmoothingMethod
{
  FeaturePreserving = 0,
  Tikhonov = 1,                 ///< (3), (5)
  InterpolatingConstraints = 2, ///< (6)
  LeastSquaresConstraints = 3   ///< (7)
};

/// Which critical points are kept, or constrained. The numbers are fixed.
enum class ConstraintChoice
{
  AllCriticalPoints = 0,
  DeltaSimplified = 1, ///< those of f of more than `delta`
  Persistent = 2,      ///< those of at least `persistenceThreshold`
  MaskArray = 3        ///< marked vertices
};

struct SmoothingParameters
{
  SmoothingMethod method = SmoothingMethod::FeaturePreserving;
  SmoothingNorms norms;
  EpsilonChoice epsilonChoice = EpsilonChoice::GCV;
  double epsilon = 1e5; ///< if chosen by hand
  ConstraintChoice constraints = ConstraintChoice::Persistent;
  double persistenceThreshold = 0.0; ///< fraction of f's range, 0 to 1
  double delta = 0.0;                ///< fraction of f's range, 0 to 1
  std::vector<char> mask;            ///< one per vertex, for MaskArray
  bool includeOneStars = true;       ///< constrains the neighbors of constrained vertices too
  bool smoothedStars = true;         ///< to values of smoothed f, not of f
};

struct SmoothedFunction
{
  Values values;               ///< in f's unit, one per vertex
  double epsilon = 0.0;        ///< 0 where none was needed
  ParameterCurve curve;        ///< empty if epsilon was chosen by hand or not needed
  MeshCriticalPoints critical; ///< of values, ties by index
  CriticalCounts inputCounts;
  CriticalCounts outputCounts;
  double largestError = 0.0; ///< max |values - f|
  double seminorm = 0.0;     ///< root of the energy of values
  std::vector<Index> lost;   ///< extrema of FeaturePreserving that are not there, see below
};

/**
 * Smooths f on a mesh and keeps its features (smoothing paper, sec. 4).
 *
 * FeaturePreserving, in four steps:
 * 1. Tikhonov regularization, epsilon by generalized cross-validation unless chosen otherwise.
 * 2. The extrema of the smooth function that `constraints` chooses are to be kept; by default those
 *    whose persistence is at least the threshold. A persistence of at most 1e-9 of f's range, there
 *    or in f, is rounding, and an extremum without a counterpart in f is ringing: no features.
 *    MaskArray and DeltaSimplified choose extrema of f: for each the smooth function's at that
 *    vertex is kept, else the lowest, or highest, that no other takes in the component that it owns
 *    (FeatureMatching.h). A mark on another extremum of the smooth function keeps that too. The
 *    lowest and the highest vertex of each component are always kept.
 * 3. Where an extremum is, is a matter of the gradient, in which noise is stronger than in the
 *    values: each moves to the place it has if f is smoothed with 1.5 times the smoothing length,
 *    then to where a quadric in space has it that fits f on a large window, if one does
 *    (ExtremumFit.h), unless the values there and here differ by more than the noise that is left.
 * 4. keepExtrema(): all other extrema, and the saddles that cancel them, are removed. The values
 *    are classified again, and compared with f: see `lost`.
 *
 * What is promised, and what is not:
 * - The result has exactly as many minima and maxima as are kept, near those of the smooth
 * function: not at those of f, where noise has moved them. One that is not at its vertex when the
 * values are classified again would be in `lost`. They are not more than f has, unless marks add
 * some.
 * - On a closed mesh there are as many saddles, counted with multiplicity, as Euler's formula asks
 *   for; the two of each handle always remain. Where they lie is not promised.
 * - The result differs from Tikhonov's only around extrema that were removed or moved, by about
 *   half of the persistence removed; there it is nearly flat.
 * - How far an extremum is from that of f without noise depends on how curved f is there, and how
 *   smooth in space: within the smoothing length nearly always in the cases of
 *   Documentation/smoothing-accuracy.md, farther where f is flat.
 * - Every chosen extremum of f whose persistence exceeds the threshold (0 but for Persistent) by
 *   more than noise explains, and every marked one of persistence above 0, has one of the result
 *   for itself, in the component that it owns, or is in `lost`. Noise explains 2 d, with
 *   d = s sqrt(2 log(2 n / 0.01)): of n independent normal errors of standard deviation s, all are
 *   below d with probability 0.99. s is measured on differences from the mean of the neighbors, by
 *   their median, which single spikes do not move. Where noise is much stronger in places than
 *   elsewhere, or depends on that of the neighbors, more is called lost than is.
 *
 * InterpolatingConstraints and LeastSquaresConstraints constrain vertices, and with includeOneStars
 * their neighbors. Critical points of f, or marked vertices, keep values of f; `Persistent` ones,
 * if smoothedStars, are those of smoothed f and keep its values, as all neighbors do then. Neither
 * the type of constrained vertices nor the absence of other critical points is promised: the
 * paper's claim that they remain critical holds if their stars are constrained to the same
 * function, and does not exclude others. Of LeastSquaresConstraints, epsilon is that of smoothing
 * f.
 *
 * A constant f comes back as it is.
 *
 * @param values f, one per vertex, finite
 * @throws InvalidInput for other values, thresholds outside [0, 1], epsilon not above 0, a mask of
 * another length or without a marked vertex; for constraints that leave a component without any, or
 * are none; Error if a solver fails; Aborted
 */
SURFACESCALARSCORE_EXPORT SmoothedFunction smoothFunction(const SmoothingMesh& mesh,
  const ValuesRef& values, const SmoothingParameters& parameters, const Execution& execution = {});

} // namespace SurfaceScalars
