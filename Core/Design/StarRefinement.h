#pragma once

#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// A vertex added within an edge, between vertices of the mesh or such added before.
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
  std::vector<Index> origins;    ///< of which triangle of the mesh each one is a part, ascending
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
 * Splits the triangles at vertices with too few neighbors (design paper, sec. 3.1): the edges of
 * the link are divided into 2, 3 or 4 equal parts, as few as suffice, and the triangles at both
 * sides with them. An edge in two such links gets the larger number of parts. Of needing vertices
 * next to each other one comes after the other, since each divides edges that end at the other,
 * which changes its neighbors, not their number.
 *
 * The surface, the directions of its triangles and functions that are linear on them remain what
 * they are. No vertex loses neighbors, and meshes on which none is needed remain as they are.
 *
 * @param needed a vertex may be there more than once
 * @param nameOf vertices, for messages
 * @throws InvalidInput for more neighbors than parts of a quarter give, and for two triangles with
 * the same corners
 */
SURFACESCALARSCORE_EXPORT RefinedMesh refineStars(const PointsRef& vertices,
  const MeshTopology& mesh, const std::vector<NeededLink>& needed, const VertexName& nameOf = {});

} // namespace SurfaceScalars
