#pragma once

#include "MeshTopology.h"
#include "TriangleMesh.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/// A square grid, each square cut in two, and what its sides are glued to.
enum class Grid
{
  Patch,
  Cylinder, ///< columns around
  Moebius,  ///< columns around, upside down where they meet
  Torus
};

/// Meshes of a known Euler characteristic.

/// 1, 0, 0 and 0. @param columns at least 3, rows too, in squares
TriangleMesh gridMesh(Grid grid, int columns, int rows);

/// The unit sphere, an octahedron each of whose triangles is cut in four again and again: 2.
TriangleMesh subdividedSphere(int levels);

/// The unit sphere, an octahedron whose edges are cut into segments and whose triangles into their
/// squares: 2. 4 segments^2 + 2 vertices.
TriangleMesh octahedralSphere(int segments);

/// The surface of a plate with holes in a row: 2 - 2 holes. @param levels as of the sphere
TriangleMesh plateWithHoles(int holes, int levels);

/// The meshes beside each other, not joined.
TriangleMesh besideEachOther(const TriangleMesh& one, const TriangleMesh& other);

/// Each triangle in four. New vertices lie in the middles of the edges.
TriangleMesh subdivided(const TriangleMesh& mesh);

struct ShuffledMesh
{
  TriangleMesh mesh;
  std::vector<int> names; ///< the new index of each vertex
};

/// The same surface: vertices and triangles in random order, each triangle in a random direction.
ShuffledMesh shuffled(const TriangleMesh& mesh, unsigned seed);

struct NamedMesh
{
  const char* name;
  TriangleMesh mesh;
  int eulerCharacteristic;
  bool isClosed;
};

/// Small ones: spheres, a torus, genus 0 to 3, with boundary and with a twist.
std::vector<NamedMesh> meshesOfAllKinds();

/// As the core wants them.
Triangles trianglesOf(const TriangleMesh& mesh);
MeshTopology topologyOf(const TriangleMesh& mesh, int threadCount = 0);

} // namespace SurfaceScalars::Truth
