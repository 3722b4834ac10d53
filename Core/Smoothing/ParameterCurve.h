#pragma once

#include "Tikhonov.h"

#include <map>

namespace SurfaceScalars
{

/// How epsilon is chosen. The numbers are fixed.
enum class EpsilonChoice
{
  GCV = 0,    ///< generalized cross-validation: least mean (f - x)^2 / (1 - trace / n)^2
  LCurve = 1, ///< the corner of log seminorm over log residual, where its curvature is positive and
              ///< largest (Hansen and O'Leary, 1993); as GCV if it has none
  Manual = 2
};

/// How smoothing depends on epsilon; one entry per epsilon, ascending.
struct ParameterCurve
{
  Values epsilons;
  Values residuals;  ///< ||f - x||_W
  Values seminorms;  ///< sqrt(energy), the Sobolev semi-norm of the paper
  Values gcv;        ///< mean of (f - x)^2 over the vertices / (1 - trace / n)^2, f's unit squared
  Values curvatures; ///< of the L-curve, positive at its corner; 0 where a norm is 0
};

/// 1 - trace / n by log10 of epsilon: does not depend on f.
using NoiseShares = std::map<double, double>;

/**
 * Smooths with epsilons for lengths from the size of the surface, sqrt(area), to half an edge,
 * further as long as the best one is the last, and closer about the best: some 15 to 20.
 *
 * Cross-validation predicts each vertex from the others and counts all alike, as noise of vertices
 * does, whatever the metric: weighted by areas, it would take the noise of small triangles for
 * detail. The trace, of f -> x, is estimated with random signs, the same ones each time
 * (Hutchinson, 1990): as many as make a thousand values. What the curvature takes of derivatives, d
 * log residual^2 / d log epsilon, comes from one more solution.
 *
 * Takes some twenty times as long as smooth(), half of that with known shares.
 *
 * @param choice about whose best epsilon the curve is refined, GCV or LCurve
 * @param known of earlier calls with this smoother; is added to. May be null
 * @throws as TikhonovSmoother::smooth()
 */
SURFACESCALARSCORE_EXPORT ParameterCurve parameterCurve(const TikhonovSmoother& smoother,
  const ValuesRef& values, const Execution& execution = {},
  EpsilonChoice choice = EpsilonChoice::GCV, NoiseShares* known = nullptr);

/// The best epsilon of the curve, between its entries. Of equally good ones, as for constant f, the
/// least.
/// @param choice GCV or LCurve
SURFACESCALARSCORE_EXPORT double chooseEpsilon(const ParameterCurve& curve, EpsilonChoice choice);

} // namespace SurfaceScalars
