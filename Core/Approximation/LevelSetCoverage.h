#pragma once

#include "Execution.h"
#include "Simplices.h"
#include "SurfaceScalarsCoreExport.h"

#include <vector>

namespace SurfaceScalars
{

/// How much of a mesh level sets meet. Shares are of its area; of its volume for tetrahedra.
struct LevelSetCoverage
{
  /// [k - 1] is c_k: the share of the simplices that the 2^k - 1 values between 2^k equal parts of
  /// f's range meet; 0 to 1, rising. None for a constant.
  std::vector<double> coverages;
  bool isStationary = true;  ///< unless 2^20 parts were not enough
  Values isoValues;          ///< of the last of them, ascending: the uniform optimal partition
  std::vector<char> covered; ///< by simplex: whether these meet it

  /// The global coverage.
  double global() const { return this->coverages.empty() ? 0.0 : this->coverages.back(); }
};

/**
 * Discrete and global coverage (design paper, sec. 4). A value meets a simplex if it is not outside
 * the range of its corners; each simplex counts once.
 *
 * The dichotomy ends where the coverage is stationary: no further step, up to 2^30 parts or as many
 * as numbers can tell apart, changes it by the tolerance times its limit, and the step that changes
 * it most is done. (The paper stops at the first step below the tolerance itself, which for values
 * crowded in a small part of the range, or beside large plateaus, is the very first.) The limit of
 * c_k is the share of the simplices on which f is not constant, whatever f: it is 1 unless f has
 * plateaus, and says nothing of how level sets are distributed. What does is how many of them it
 * takes.
 *
 * Time O(n): which power of 2 is the first to meet a simplex follows from its own range.
 *
 * @param vertices 3 x n, finite @param simplices triangles or tetrahedra, corners below n
 * @param values one per vertex, finite
 * @param tolerance share of what values can meet, above 0 and below 1
 * @throws InvalidInput unless it is so, and for a mesh without area or volume; Aborted
 */
SURFACESCALARSCORE_EXPORT LevelSetCoverage levelSetCoverage(const PointsRef& vertices,
  const SimplicesRef& simplices, const ValuesRef& values, double tolerance,
  const Execution& execution = {});

/// The 2^k - 1 values between 2^k equal parts of f's range, ascending. Those of a smaller k are
/// among them, to the bit.
/// @param k 1 to 30, less where rounding makes values equal @throws InvalidInput
SURFACESCALARSCORE_EXPORT Values dyadicIsoValues(const ValuesRef& values, int k);

} // namespace SurfaceScalars
