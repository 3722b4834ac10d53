#pragma once

#include "CriticalPoint.h"
#include "Execution.h"
#include "FieldApproximation.h"
#include "NeighborGraph.h"
#include "RadialKernel.h"
#include "SurfaceScalarsCoreExport.h"
#include "VolumeFunction.h"

#include <vector>

namespace SurfaceScalars
{

/// How probable it is that a sample is critical.
enum class ProbabilityModel
{
  Gradient = 0, ///< exp(-g^T S^-1 g / 2): how well "the gradient is zero" agrees with the samples
  NormalAngle =
    1 ///< |cos| of the angle between the gradient of a given F and the normal (sec. 5.2)
};

struct CriticalPointParameters
{
  Scheme scheme = Scheme::ParameterizedMLS;
  int polynomialDegree = 2; ///< 1 to 4, of the fits to noise; 1 is taken for 2, without which there
                            ///< is no Hessian. Where there is no noise, it is one more
  int neighborCount = 0;    ///< k of the local fits; 0 = from sampling and noise
  double searchRadius = 0.0;             ///< length; > 0 replaces neighborCount
  KernelType kernel = KernelType::Cubic; ///< of LocalRBF and Hybrid
  double kernelWidth = 0.0;              ///< length; 0 = from the sampling
  ProbabilityModel probabilityModel = ProbabilityModel::Gradient;
  VolumeFunction volumeFunction; ///< F that f samples; needed by NormalAngle, which uses no other
  double probabilityThreshold =
    0.0; ///< critical points whose samples all have less are left out; 0 = automatic
  double persistenceThreshold =
    0.0;              ///< fraction of f's range; critical points with less are left out
  bool refine = true; ///< move critical points off the samples, to where the gradient is zero
};

/// At the points of the graph, in its order.
struct SampleCriticality
{
  Values probability; ///< 0 to 1; where f is constant, 0
  Points gradient;    ///< of f~ on the surface: tangential, f's unit per length
  Points normal;      ///< unit, outwards as isOutwards()
  std::vector<CriticalType>
    type; ///< that of a critical point at the sample nearest to it, else Regular
};

struct FuzzyCriticalPoints
{
  std::vector<CriticalPoint> points; ///< by value, ascending
  SampleCriticality samples;
  int indexSum = 0;      ///< of the points, uncertain ones counting nothing. Where the surface is
                         ///< closed, its Euler characteristic: an odd one misses a point
  int neighborCount = 0; ///< used by the local fits; 0 if a search radius was given
};

/**
 * The critical points of a function known at the points of a neighbor graph, and the probability
 * that each sample is one (point-set paper, sec. 5; design paper, sec. 5).
 *
 * Polynomials of surface and f over the tangent plane, (4)(5), are fitted all over the surface,
 * each for the samples around its center. Where one of them is critical, Newton's method follows
 * with fits centered anew until the center is critical itself: a solution of
 *
 *   grad F - <grad F, n> n = 0,  g = 0
 *
 * (the paper's (15) asks for <grad F, n> = 0, which is the opposite, and has one equation too few).
 *
 * Types come from the turns of the gradient of f~ on small circles around, 1 or -1, where circles
 * of several sizes agree (Poincare and Hopf), or else from the eigenvalues of the Hessian on the
 * surface where they are larger than their standard errors allow for by chance. Elsewhere, as at a
 * monkey saddle, whose Hessian is zero, f~ is followed on circles around: with 2 + 2m changes of
 * sign against its value in the middle it is a saddle of multiplicity m, with none an extremum,
 * with two regular. Where noise, or a ridge, hides the signs too the point is Uncertain: one for
 * each run of a ridge. At last the indices of points closer to each other than the radius of the
 * fits are made to sum to the index of an outline around all of them, on which the gradient is
 * larger: a pair too close for both to be found is found as a whole or not at all.
 *
 * The neighborhoods are the smallest in which Hessians can be told from the noise, which is what
 * the fits leave over; large ones are fitted to averages of blocks of samples. Places beyond or at
 * the edge of the sampled surface are no critical points: fits extrapolate there, and extrema of f
 * on the boundary have a gradient. Plateaus have none, and constant functions.
 *
 * The probability is pi = exp(-g^T S^-1 g / 2), g the gradient at the sample and S its mean square
 * error if the sample were the one next to a critical point: the covariance and the bias of g, and
 * (0.55 step)^2 H H^T. It is larger than 0.1 at the samples next to nine of ten critical points, as
 * chi-squared with two degrees of freedom wants, or more. (The paper's |cos| of the angle between
 * grad F and n is 0 at every sample of a surface whose F is constant along its normals, and noise
 * for others; it is offered for an F that is known in space: NormalAngle. F then is that function,
 * called from one thread at a time, whatever the scheme.)
 *
 * Time O(n log n). Results do not depend on the number of threads.
 *
 * @param values one per point of the graph, finite
 * @throws InvalidInput for unusable parameters (Linear and GlobalRBF have no local f~ of use here),
 * too few points, or points on a line; Aborted
 */
SURFACESCALARSCORE_EXPORT FuzzyCriticalPoints findCriticalPoints(const NeighborGraph& graph,
  const ValuesRef& values, const CriticalPointParameters& parameters,
  const Execution& execution = {});

} // namespace SurfaceScalars
