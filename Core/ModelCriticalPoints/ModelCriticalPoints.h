#pragma once

#include "Field.h"
#include "MeshCriticalPoints.h"

#include <vector>

namespace SurfaceScalars
{

/// What became of a candidate; the numbers are written to files.
enum class RefinementEnd
{
  Refined,
  OnBoundary,   ///< not searched from: it is critical along the boundary
  NoDerivative, ///< u or the surface has no derivatives there
  NotPredicted, ///< on no fit around have the values a critical point of its type
  Taken,        ///< only points were found that others stand for
  OutOfSteps,   ///< nothing was found in 10 steps
  NotFound      ///< nor in fewer, where all predictions lead
};

/// A critical point of a function of space restricted to the smooth surface that a mesh samples.
struct ModelCriticalPoint
{
  CriticalPoint
    point; ///< `input` is the nearest vertex, the residual there, -1 without derivatives
  std::size_t origin = 0;                     ///< the critical vertex that it came from
  RefinementEnd end = RefinementEnd::Refined; ///< others remain at that vertex
  int iterations = 0; ///< Newton steps, those of searches in vain included: at most 10

  bool isRefined() const { return this->end == RefinementEnd::Refined; }
};

struct ModelCriticalPoints
{
  std::vector<ModelCriticalPoint> points; ///< by origin
  double gradientScale = 0.0;             ///< what residuals are small against
  std::size_t merged = 0;                 ///< candidates that led where another one does
  std::size_t vanished = 0;               ///< candidates that u has no critical point for
};

/// The root mean square, over the area, of the gradient of the function that is linear on the
/// triangles: value's unit per length; 0 where values are constant but for rounding.
SURFACESCALARSCORE_EXPORT double gradientScale(
  const PointsRef& vertices, const Triangles& triangles, const ValuesRef& values);

/**
 * The critical points of u off the vertices (design paper, sec. 5), from those of its values at the
 * vertices: on the smooth surface of MeshChart, to a tangential gradient of 1e-10 of
 * gradientScale() by SurfaceNewton, in at most 10 steps for each candidate.
 *
 * The critical vertices obey Euler's formula; so does what becomes of them. From each one of the
 * interior a point of its own type is searched for, on the chart on which the polynomial through
 * u's values predicts one: its own, that of the vertex next to there, or a neighbor's; from a
 * saddle of multiplicity m several, as u has m simple ones for it. Of several that lead to one
 * point the most persistent stands for it, or a critical vertex of the boundary next to it. An
 * extremum and a saddle which are a pair (MeshCriticalPoints::pairs) and neither of which stands
 * for a point were made by the triangles: both vanish, and the sum of the indices stays. For what
 * is not explained so there is a point on some smooth surface: it is searched for on the other fits
 * to the vertices around. What is not found there either, and critical vertices of the boundary,
 * remain vertices.
 * A pair of critical points of u closer to each other than the mesh is fine, of which the vertices
 * show nothing, is not searched for.
 *
 * Where u is constant, or has no second derivatives, vertices remain.
 *
 * @param values of u at the vertices
 * @param candidates as meshCriticalPoints() finds them for these values; some may be left out
 * @throws InvalidInput if the numbers of vertices, values and places differ; Aborted
 */
SURFACESCALARSCORE_EXPORT ModelCriticalPoints refineOnModel(const PointsRef& vertices,
  const MeshTopology& mesh, const ValuesRef& values, const Field& u,
  const MeshCriticalPoints& candidates, const Execution& execution = {});

/// The sum of the indices; of points on the boundary half. Its Euler characteristic, if no
/// candidate is left out.
SURFACESCALARSCORE_EXPORT double indexSum(
  const std::vector<ModelCriticalPoint>& points, const MeshTopology& mesh);

} // namespace SurfaceScalars
