#pragma once

#include "CriticalPoint.h"
#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// What a function shall look like around a vertex.
struct StarPattern
{
  Index vertex;
  CriticalType type; ///< Minimum, Saddle or Maximum
  int multiplicity;
  double leastCurvature;        ///< f's unit / length^2; positive
  std::vector<Vector3d> others; ///< offsets to places towards which a saddle rises where f is flat
};

/**
 * Differences of a critical point's value to those of its link, from a function that need not be
 * critical there (design.md): a quadratic function q in the tangent plane is fitted around the
 * vertex, its gradient dropped.
 *
 * - Of extrema and simple saddles its eigenvalues get the signs that are asked for, the smaller at
 *   least 0.3 of the larger in magnitude, that at least leastCurvature.
 * - A saddle of multiplicity m > 1 has no quadratic function: r^2 cos((m + 1) angle), turned as the
 *   function is and as curved.
 * - On the boundary angles count from it, and saddles are r^2 cos((m + 1) pi angle / total): what
 * is natural there has no derivative across it.
 *
 * Whether the link has as many changes of sign is another matter: closestSigns().
 *
 * @param field one value per vertex
 * @returns differences, in the order of the link
 */
std::vector<double> starTemplate(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& field, const StarPattern& pattern);

} // namespace SurfaceScalars
