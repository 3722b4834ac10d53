#pragma once

#include "Tikhonov.h"

namespace SurfaceScalars
{

/// How epsilon is chosen. The numbers are fixed.
enum class EpsilonChoice
{
  GCV = 0,    ///< generalized cross-validation: least ||f - x||^2 / (1 - trace / n)^2
  LCurve = 1, ///< largest curvature of log energy over log distance (Hansen and O'Leary, 1993)
  Manual = 2
};

/// How smoothing depends on epsilon; one entry per epsilon, ascending.
struct ParameterCurve
{
  Values epsilons;
  Values residuals; ///< ||f - x||_W
  Values seminorms; ///< sqrt(energy), the Sobolev semi-norm of the paper
  Values gcv;
  Values curvatures; ///< of the L-curve
};

/// (range and number of epsilons; probes for the trace; cost)
SURFACESCALARSCORE_EXPORT ParameterCurve parameterCurve(
  const TikhonovSmoother& smoother, const ValuesRef& values, const Execution& execution = {});

/// @param choice GCV or LCurve @returns an epsilon
SURFACESCALARSCORE_EXPORT double chooseEpsilon(const ParameterCurve& curve, EpsilonChoice choice);

} // namespace SurfaceScalars
