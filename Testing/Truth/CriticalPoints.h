#pragma once

#include "Functions.h"
#include "Torus.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/// Where the gradient of f on the torus vanishes.
struct CriticalPoint
{
  Vector2d angles;
  double value;
  int index; ///< of Poincare and Hopf: 1 at minima and maxima, -1 at saddles
};

/**
 * All critical points of f on the closed torus, by Newton's method from a grid of starts; values to
 * rounding. Only nondegenerate ones are meant to exist: then the indices sum to the Euler
 * characteristic 0.
 */
std::vector<CriticalPoint> criticalPoints(const SpaceFunction& function);

/// Extrema of f on the two boundary circles of the cut torus: there curves begin to cross the
/// boundary.
std::vector<double> boundaryCriticalValues(const SpaceFunction& function);

/// Every value at which the level sets of f on the torus change: ascending, nearly equal ones once.
/// First and last are f's range.
std::vector<double> criticalValues(const SpaceFunction& function, Torus torus);

/**
 * `count` iso-values spread evenly over the range of f, each moved away from critical values until
 * none is closer than `margin` of the range.
 */
std::vector<double> regularIsoValues(
  const std::vector<double>& criticalValues, int count, double margin);

} // namespace SurfaceScalars::Truth
