#pragma once

#include "DesignMesh.h"
#include "MeshCriticalPoints.h"
#include "NearestVertices.h"
#include "ParameterCurve.h"
#include "RadialKernel.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// The numbers are fixed.
enum class DesignApproach
{
  MeshBased = 0, ///< least energy on the mesh (design paper, sec. 3.2)
  Meshless = 1   ///< a sum of radial functions, taken at the vertices (sec. 3.3)
};

/// The numbers are fixed.
enum class DesignConstraints
{
  Interpolating = 0, ///< (2): the values are met
  LeastSquares = 1   ///< (3): the values are approached
};

/// A critical point that is asked for.
struct CriticalRequest
{
  Index vertex = 0;
  CriticalType type = CriticalType::Maximum; ///< Minimum, Saddle or Maximum
  int multiplicity = 1;                      ///< m of a saddle
  std::optional<double> value;               ///< none: chosen
  std::vector<double> star; ///< values of the link, in its order, with `value`; empty: chosen
};

struct DesignParameters
{
  DesignApproach approach = DesignApproach::MeshBased;
  DesignConstraints constraints = DesignConstraints::Interpolating;
  SmoothingEnergy energy = SmoothingEnergy::Biharmonic; ///< MeshBased
  DataMetric metric = DataMetric::Identity;             ///< MeshBased
  KernelType kernel = KernelType::Cubic;                ///< Meshless; Harmonic: centers are offset
  double kernelWidth = 0.0;                             ///< Meshless; length, 0 = automatic
  EpsilonChoice epsilonChoice = EpsilonChoice::LCurve;  ///< LeastSquares; not GCV
  double epsilon = 1e5;                                 ///< LeastSquares, if chosen by hand
  bool cleanUp = false; ///< removes critical points that nothing requires
};

struct DesignedFunction
{
  Values values;                ///< one per vertex
  MeshCriticalPoints critical;  ///< of values, ties by index
  std::vector<char> prescribed; ///< by critical point: asked for, with this type and multiplicity
  std::vector<std::size_t> missing; ///< requests that are not critical so in values, ascending
  double epsilon = 0.0;             ///< 0 where none was needed
  ParameterCurve curve;             ///< LeastSquares; empty if epsilon was chosen by hand
};

/// Neighbors that a critical point needs to be what is asked for: 2 + 2 m changes of sign around an
/// interior vertex, m + 1 along the link of one on the boundary (see classifyVertices()); 1 for
/// extrema.
SURFACESCALARSCORE_EXPORT Index neededLinkSize(
  const MeshTopology& mesh, const CriticalRequest& request);

/**
 * The critical points of a template function with its values there and around them (design paper,
 * sec. 3.4): of a Laplacian eigenfunction, say.
 *
 * @param persistenceThreshold fraction of the function's range, 0 to 1
 * @throws InvalidInput for values that are not finite; Aborted
 */
SURFACESCALARSCORE_EXPORT std::vector<CriticalRequest> requestsOf(const PointsRef& vertices,
  const MeshTopology& mesh, const ValuesRef& templateValues, double persistenceThreshold,
  const Execution& execution = {});

/**
 * A smooth function with chosen critical points (design paper, sec. 3).
 *
 * In two passes. The first makes a smooth function through the values that are given; extrema
 * without one get values below, or above, all of these (0 and 1 if none is given). It says what
 * saddles without a value have, and what the surroundings of each point should look like
 * (starTemplate()). The second has all values of the points and of their neighbors:
 *
 * - Interpolating (2): they are met exactly, so that each point is critical as asked for. MeshBased
 *   functions have the least energy of all that do, Meshless ones are sums of radial functions.
 *   (||L f||, which the paper calls Dirichlet's energy, is the biharmonic one.)
 * - LeastSquares (3): energy(x) + t (x - f)^T W (x - f) over these vertices is least, t =
 *   epsilon / area^2 biharmonic, epsilon / area harmonic; Meshless, 1 / epsilon is added to the
 *   diagonal of the kernel's matrix. Points may be lost: `missing`.
 *
 * What is asked for need not obey Euler's formula, nor does least energy exclude other extrema, as
 * biharmonic functions may rise above all given values: others are added, see `prescribed`. Nothing
 * is added to what harmonic functions have anyway (Documentation/design-accuracy.md). With cleanUp
 * what is not needed is removed, see withoutUnneeded().
 *
 * A design that differs from one before on this mesh in one point takes about an eighth of its
 * time.
 *
 * @param requests at least one in each connected component, at different vertices with neighbors
 * enough (refineStars())
 * @param nameOf what messages call a request: "critical point 3" for the fourth unless given
 * @throws InvalidInput that names requests for unusable ones, such that exclude each other, as
 * neighbors may, and parameters out of range; Error if a solver fails; Aborted
 */
SURFACESCALARSCORE_EXPORT DesignedFunction designFunction(const DesignMesh& mesh,
  const std::vector<CriticalRequest>& requests, const DesignParameters& parameters,
  const Execution& execution = {}, const PlaceName& nameOf = {});

} // namespace SurfaceScalars
