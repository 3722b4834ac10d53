#pragma once

#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// A vertex added within an edge.
struct EdgeVertex
{
  Index from;
  Index to;
  double fraction; ///< of the way
};

/// A mesh some of whose triangles are split.
struct RefinedMesh
{
  Points vertices; ///< those of the mesh, then the added ones
  Triangles triangles;
  std::vector<Index> origins;    ///< of which triangle of the mesh each one is a part
  std::vector<char> isSplit;     ///< by triangle: whether it is only a part
  std::vector<EdgeVertex> added; ///< in the order of the added vertices
};

/// A vertex that needs neighbors.
struct NeededLink
{
  Index vertex;
  Index size; ///< of the link, at least
};

/**
 * Splits the triangles at vertices with too few neighbors (design paper, sec. 3.1): edges of the
 * link are divided into equal parts, and the triangles at both sides with them. Functions that are
 * linear on the triangles remain what they are.
 *
 * @throws InvalidInput for links that would need parts smaller than a quarter
 */
SURFACESCALARSCORE_EXPORT RefinedMesh refineStars(
  const PointsRef& vertices, const MeshTopology& mesh, const std::vector<NeededLink>& needed);

} // namespace SurfaceScalars
