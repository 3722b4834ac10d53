#pragma once

#include "Basics.h"
#include "Execution.h"
#include "FieldApproximation.h"
#include "NeighborGraph.h"
#include "RadialKernel.h"
#include "SurfaceScalarsCoreExport.h"
#include "VolumeFunction.h"

#include <vector>

namespace SurfaceScalars
{

/// What the samples of a level set are put on.
enum class SurfaceModel
{
  MLS = 0,        ///< the moving least-squares surface
  RBF = 1,        ///< the zero set of local sums of radial functions
  Unprojected = 2 ///< nothing: they stay on the edges of the neighbor graph
};

enum class CurveFit
{
  Interpolate = 0, ///< curves through the points found
  LeastSquares = 1 ///< a smooth spline near them (sec. 4.2)
};

struct ContourParameters
{
  std::vector<double> isoValues; ///< any order, duplicates count once
  Scheme scheme = Scheme::ParameterizedMLS;
  SurfaceModel surface = SurfaceModel::MLS;
  VolumeFunction volumeFunction; ///< if set, F is this function exactly (sec. 4.3); called from one
                                 ///< thread at a time
  int polynomialDegree = 2;      ///< 1 to 4
  int neighborCount = 0;         ///< used by the local fits; 0 if a search radius was given
  double searchRadius = 0.0;     ///< length; > 0 replaces neighborCount
  KernelType kernel = KernelType::Cubic; ///< of LocalRBF, Hybrid and SurfaceModel::RBF
  double kernelWidth = 0.0; ///< h of (2) and (6) and of the kernel, length; 0 = from the sampling
  double linkDistance =
    0.0; ///< widest hole bridged, in sampling steps; 0 = the widest gap of random sampling
  double tolerance = 1e-7;    ///< of the projection onto the level set, in sampling steps
  int maximumIterations = 20; ///< of that projection
  CurveFit fit = CurveFit::Interpolate;
  double sampleSpacing = 0.0; ///< distance of curve points, length; 0 = as traced
};

/// A point of a level set on the surface.
struct LevelSetPoint
{
  Vector3d position;     ///< in the caller's coordinates: NeighborGraph::origin() is added
  Vector3d normal;       ///< of the surface, unit
  double residual = 0.0; ///< first-order distance to the common zero of F - alpha and g, length
  bool converged = false;
};

/// A connected component of a level set, as an ordered polyline. Larger values of f lie to the
/// left, seen against the normals.
struct LevelSetCurve
{
  std::size_t level = 0; ///< index into LevelSets::isoValues
  int component = 0;     ///< 0, 1, ... within the level
  bool closed = false;   ///< the last point is joined to the first, which is not repeated
  double length = 0.0;
  std::vector<LevelSetPoint> points;
};

/// One sample of a level set: where it meets an edge of the neighbor graph, projected (sec. 4.1).
struct LevelSetSample
{
  std::size_t level = 0;
  LevelSetPoint point;
};

struct LevelSets
{
  std::vector<double> isoValues;     ///< ascending, distinct
  std::vector<int> componentCounts;  ///< per iso-value: the evolution of the level sets (sec. 4.3)
  std::vector<LevelSetCurve> curves; ///< by iso-value, then by component
  std::vector<LevelSetSample> samples; ///< by iso-value
  int neighborCount = 0;               ///< used by the local fits; 0 if a search radius was given
};

/**
 * The level sets of a function known at the points of a neighbor graph, as ordered curves
 * (point-set paper, sec. 4).
 *
 * Edges whose ends lie on different sides of an iso-value give samples, which are projected onto {F
 * = alpha, g = 0}, (14). From them the curves are traced by prediction and correction: linking
 * samples by distance, as the paper does, joins and breaks curves at random where the sampling is
 * random. The paper's averages (6), (2) can be chosen; the default fits polynomials to surface and
 * function over the tangent plane, which is some thousand times more accurate.
 *
 * A sample belongs to the lower side if f < alpha, to the upper if f >= alpha: plateaus at an
 * iso-value are on the upper side. An iso-value within 1e-6 of f's range from a saddle's value, or
 * closer than the samples tell, is critical: the 2 + 2 m branches of a saddle of multiplicity m (up
 * to 4) meet at one point (sec. 5.2). A branch that returns to its saddle is a loop, which begins
 * there; branches between different saddles are loops around larger values; what ends at the
 * boundary is a curve from there to the saddle. Saddles are found by ParameterizedMLS and Linear,
 * for f known at the points.
 *
 * @param values one per point of the graph, finite
 * @throws InvalidInput for unusable parameters or too few points; Aborted
 */
SURFACESCALARSCORE_EXPORT LevelSets traceLevelSets(const NeighborGraph& graph,
  const ValuesRef& values, const ContourParameters& parameters, const Execution& execution = {});

} // namespace SurfaceScalars
