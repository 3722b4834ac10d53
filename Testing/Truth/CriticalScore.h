#pragma once

#include "CriticalPoint.h"

#include <functional>
#include <limits>
#include <vector>

namespace SurfaceScalars::Truth
{

/// How well critical points were found; counts and errors of several runs can be pooled.
struct CriticalScore
{
  int exactCount = 0;
  int foundCount = 0; ///< with a type: Uncertain ones are counted apart
  int uncertainCount = 0;
  int rightCount = 0;    ///< pairs of found and exact with the same type and multiplicity
  double errorSum = 0.0; ///< of the pairs' distances
  double squaredErrorSum = 0.0;
  double errorMaximum = 0.0;

  double precision() const; ///< share of the found points that are right
  double recall() const;    ///< share of the exact points that are found
  double meanError() const;
  double rootMeanSquareError() const;
  CriticalScore inUnitsOf(double length) const; ///< the same with other errors
  void add(const CriticalScore& other);
};

/**
 * Pairs found with exact critical points of the same type and multiplicity, nearest first, each at
 * most once.
 *
 * @param radius pairs are not further apart
 * @param counts where a point is judged; elsewhere it may be found or not. Empty = everywhere
 */
CriticalScore scoreCriticalPoints(const std::vector<CriticalPoint>& found,
  const std::vector<CriticalPoint>& exact, double radius,
  const std::function<bool(const Vector3d&)>& counts = {});

/// A quarter of the smallest distance between two of the points: nearer, there is no doubt which
/// one is meant. Infinite for a single point.
double unambiguousRadius(const std::vector<CriticalPoint>& points);

} // namespace SurfaceScalars::Truth
