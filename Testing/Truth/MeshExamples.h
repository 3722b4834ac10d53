#pragma once

#include "TriangleMesh.h"
#include "Triangles.h"

namespace SurfaceScalars::Truth
{

/// An icosahedron whose triangles are divided in four `times` times, on the unit sphere:
/// 10 4^times + 2 vertices.
TriangleMesh subdividedSphere(int times);

/// A grid of around x across vertices on the torus of Torus.h, each moved along the surface by up
/// to `shake` of the distance to the next.
TriangleMesh griddedTorus(int around, int across, double shake, unsigned seed = 1);

/// A grid of count x count vertices on the unit square, those inside moved likewise: with boundary.
TriangleMesh griddedSquare(int count, double shake, unsigned seed = 1);

/// Both in one mesh, the vertices of the second after those of the first, nothing joined.
TriangleMesh together(const TriangleMesh& one, const TriangleMesh& other);

/// Moved and scaled such that the bounding box has its center at the origin and a diagonal of 2.
TriangleMesh centered(TriangleMesh mesh);

/// As the core takes them.
Triangles trianglesOf(const TriangleMesh& mesh);

} // namespace SurfaceScalars::Truth
