#pragma once

#include "Functions.h"
#include "TriangleMesh.h"

namespace SurfaceScalars::Truth
{

/**
 * A triangle mesh of the closed surface {g = 0} with its vertices on it: where g crosses the edges
 * of a grid of tetrahedra, then relaxed along the surface so that triangles become even.
 *
 * @param radius half the width of a cube about the origin that contains the surface
 * @param cells of the grid along each side; finer than anything the surface has
 */
TriangleMesh implicitMesh(const SpaceFunction& implicit, double radius, int cells);

} // namespace SurfaceScalars::Truth
