#pragma once

#include "ApproximationDomain.h"
#include "Field.h"

#include <cstddef>
#include <string>
#include <vector>

namespace SurfaceScalars
{

/// How the centers beside the stars of critical points are chosen. The numbers are fixed.
enum class CenterSelection
{
  Greedy = 0,   ///< a cover, then vertices where the error is largest
  LevelSets = 1 ///< the paper's: points of level sets that cover the surface
};

/// What the values at centers beside the stars are. The numbers are fixed.
enum class LevelSetConstraints
{
  Interpolating = 0, ///< f's
  LeastSquares = 1,  ///< those that come nearest to f at four times as many places
  Minimax = 2        ///< those with which u misses f by least where it does so most
};

struct ApproximationParameters
{
  CenterSelection centerSelection = CenterSelection::Greedy;
  LevelSetConstraints levelSetConstraints = LevelSetConstraints::Interpolating;
  KernelType kernel = KernelType::Cubic; ///< not Harmonic
  double kernelWidth = 0.0;              ///< length; 0 = automatic
  double regularization = 0.0;     ///< see RadialBasisFit; above 0 not even stars are interpolated
  double sampleFraction = 0.01;    ///< centers beside the stars, per vertex: above 0, at most 1
  double coverageTolerance = 1e-4; ///< of LevelSets: see levelSetCoverage()
  double persistenceThreshold = 0.0; ///< of the critical points that are kept, fraction of f's
                                     ///< range; 0 = all
};

struct MeshlessApproximation
{
  FieldModel model;        ///< u: scheme GlobalRBF
  bool isConstant = false; ///< f, but for rounding: nothing is critical
  Values values;           ///< u at the vertices, as Field(model) evaluates it but for rounding

  std::vector<CriticalPoint> persistent; ///< of f, interpolated with their links
  std::vector<std::size_t> lost;         ///< of these: not so in u, ascending
  MeshCriticalPoints critical;           ///< of `values`, ties by index
  std::vector<char> prescribed;          ///< by critical point: one of f's persistent ones
  /// Critical points of f that were left out as not persistent.
  std::size_t leftOut = 0;

  double largestError = 0.0; ///< |u - f| over all vertices, f's unit
  double meanError = 0.0;
  double condition = 0.0;      ///< estimate, of the system that was solved
  std::string widthRemark;     ///< see remarkOnWidth()
  Eigen::Index starCount = 0;  ///< centers that are critical or next to such a vertex
  Eigen::Index askedCount = 0; ///< centers that sampleFraction asks for, with the stars
};

/**
 * A function on n vertices by a sum of k << n radial functions and a linear polynomial (design
 * paper, sec. 4): u = sum a_i phi(|p - c_i|) + b + c . p.
 *
 * Persistent critical points and their links are centers and interpolated, so that each of them is
 * critical in u, too, at the same vertex, with the same type and multiplicity. (Where f is level
 * there, values are drawn apart by 1e-7 of its range.) sampleFraction * n centers more, at least 4,
 * follow f between them:
 *
 * - Greedy: a sparse cover, then in rounds the vertices where u misses f most, apart from each
 *   other; in the end, centers that matter least are exchanged for such vertices. Fewer are chosen
 *   where u is f to rounding.
 * - LevelSets, the paper's C_iso: evenly spread points of the level sets of the uniform optimal
 *   partition (levelSetCoverage()). Where these cover less than three quarters, the rest, on which
 *   f is nearly constant, gets its share, too (C_ls; "close to zero" in the paper is a misprint for
 *   "close to 1": sets that cover the surface need nothing more).
 *
 * LeastSquares: (4) of the paper is square, so that nothing there is least squares. Here the stars
 * are interpolated, and the values at the k other centers are those with which u comes nearest to f
 * at 4 k places, centers among them: a well-conditioned system whatever the places. Minimax: those
 * with which the largest error over all vertices is least, but for a few percent.
 *
 * There are at most MostDenseCenters: `askedCount` says how many were asked for. With k >= 4
 * starCount the largest error of Greedy with Minimax is below half that of interpolation at as many
 * farthest points, and below a quarter of that of LevelSets, where the former is within 3% of f's
 * range and within half of that of half as many: no choice makes up for noise, or for details that
 * fit between the centers (Documentation/approximation-accuracy.md).
 *
 * Time O(k^3 + n k), memory O(k^2 + n); Minimax takes up to 20 times the memory, two gigabytes at
 * most, and from a thousand centers on several times as long. Results do not depend on the number
 * of threads.
 *
 * @param values one per vertex, finite
 * @throws InvalidInput for unusable values and parameters, more stars than MostDenseCenters, and a
 * system that is singular at machine precision, as Gaussians of the paper's widths make it; Aborted
 */
SURFACESCALARSCORE_EXPORT MeshlessApproximation approximateMeshless(
  const ApproximationDomain& domain, const ValuesRef& values,
  const ApproximationParameters& parameters, const Execution& execution = {});

/// What a user should know of a result, one sentence each: fewer centers than asked for, too few
/// beside the stars, a kernel too narrow, a system in need of regularization, critical points lost.
SURFACESCALARSCORE_EXPORT std::vector<std::string> remarksOn(const MeshlessApproximation& result);

/// What a GlobalRBF model takes to store: centers, coefficients and polynomial, as doubles.
SURFACESCALARSCORE_EXPORT std::size_t bytesOf(const FieldModel& model);

} // namespace SurfaceScalars
