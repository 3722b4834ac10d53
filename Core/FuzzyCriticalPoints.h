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
  int polynomialDegree = 2;              ///< 1 to 4
  int neighborCount = 0;                 ///< k of the local fits; 0 = from sampling and noise
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
  Values probability; ///< 0 to 1
  Points gradient;    ///< of f~ on the surface: tangential, f's unit per length
  Points normal;      ///< unit, outwards as isOutwards()
  std::vector<CriticalType>
    type; ///< that of a critical point at the sample nearest to it, else Regular
};

struct FuzzyCriticalPoints
{
  std::vector<CriticalPoint> points; ///< by value, ascending
  SampleCriticality samples;
  int indexSum = 0;      ///< of the points; the Euler characteristic where the surface is closed
  int neighborCount = 0; ///< used by the local fits; 0 if a search radius was given
};

/**
 * The critical points of a function known at the points of a neighbor graph, and the probability
 * that each sample is one (point-set paper, sec. 5; design paper, sec. 5).
 *
 * (Algorithm, errata of (15) and of pi, significance, boundaries, noise: to be written by whoever
 * implements it.)
 *
 * @param values one per point of the graph, finite
 * @throws InvalidInput for unusable parameters or too few points; Aborted
 */
SURFACESCALARSCORE_EXPORT FuzzyCriticalPoints findCriticalPoints(const NeighborGraph& graph,
  const ValuesRef& values, const CriticalPointParameters& parameters,
  const Execution& execution = {});

} // namespace SurfaceScalars
