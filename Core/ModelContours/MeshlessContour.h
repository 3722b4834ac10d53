#pragma once

#include "Field.h"
#include "LevelSets.h"
#include "Triangles.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

struct MeshlessContourParameters
{
  std::vector<double> isoValues; ///< any order, duplicates count once
  double tolerance = 0.0;        ///< of the distance between curves and level sets, length; 0 =
                                 ///< 1e-3 of the median edge
  int maximumRefinement = 8;     ///< how often a triangle is cut in four, 0 to 20
};

struct MeshlessContours
{
  LevelSets sets;                    ///< neighborCount and samples are of no meaning
  double tolerance = 0.0;            ///< that was used
  double largestDeviation = 0.0;     ///< of a segment from the level set, to first order, length
  std::size_t evaluations = 0;       ///< of u, with or without derivatives
  std::size_t evaluatedVertices = 0; ///< of the mesh, at which u was needed
  std::size_t undefinedCount = 0;    ///< triangles and pieces left out, as u is not defined there
  double farDistance = 0.0;          ///< twice the widest spacing of centers, length
  double farShare = 0.0;             ///< of the curves' length: farther than that from every center
};

/**
 * The level sets of a function u of space on a triangle mesh (design paper, sec. 6.1): the curves
 * {p on the mesh: u(p) = alpha}, as ordered polylines whose points are on both.
 *
 * Triangles are cut, with their neighbors, edge to edge, until each segment is closer to the level
 * set than the tolerance; edges are crossed at the root of u - alpha. Halving edges divides the
 * error by four. Where the Taylor polynomial of u excludes a level set, for whole blocks of
 * triangles at once, u is not evaluated; components no edge of a triangle crosses are found if they
 * are wider than the finest pieces. A place belongs to the lower side if u < alpha, else to the
 * upper.
 *
 * An alpha within 1e-6 of u's range from a saddle's value, of u restricted to the mesh, is
 * critical: the 2 + 2 m branches meet at the saddle, and those that return to it are loops (see
 * joinArcs()).
 *
 * Curves are closed or end at the boundary, at an edge of more than two triangles, or where a local
 * scheme is not defined. Local schemes jump a little: there a segment may be off by the jump, and
 * closes it.
 *
 * Larger values lie to the left, seen against the normals, which agree along a curve and, as a
 * whole, with how its triangles run.
 *
 * @param vertices 3 x n, finite, length units @param triangles corners below n; not necessarily a
 * manifold
 * @throws InvalidInput for unusable parameters, or a mesh without triangles; Aborted
 */
SURFACESCALARSCORE_EXPORT MeshlessContours traceMeshlessContours(const Field& field,
  const PointsRef& vertices, const Triangles& triangles,
  const MeshlessContourParameters& parameters, const Execution& execution = {});

} // namespace SurfaceScalars
