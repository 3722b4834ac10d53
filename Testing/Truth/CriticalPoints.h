#pragma once

#include "CriticalPoint.h"
#include "Functions.h"
#include "Surfaces.h"
#include "Torus.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/**
 * All critical points of f on a closed surface, by Newton's method from many samples of it;
 * positions and values to rounding. Only nondegenerate ones are meant to exist: then their indices
 * sum to the Euler characteristic.
 */
std::vector<CriticalPoint> criticalPoints(
  const ClosedSurface& surface, const SpaceFunction& function);

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
