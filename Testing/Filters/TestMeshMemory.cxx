// What is kept of a mesh between runs.

#include "MeshMemory.h"

#include "ConstrainedSmoothing.h"
#include "Error.h"

#include <gtest/gtest.h>

using namespace SurfaceScalars;

namespace
{

/// A tetrahedron whose vertices are the points from `first` on.
MeshedSurface tetrahedron(vtkIdType first = 0)
{
  MeshedSurface surface;
  surface.vertices.resize(3, 4);
  surface.vertices << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  surface.triangles.resize(3, 4);
  surface.triangles << 0, 0, 0, 1, 1, 2, 3, 3, 2, 3, 1, 2;
  surface.map.pointOfVertex = { first, first + 1, first + 2, first + 3 };
  return surface;
}

// Building anything reports progress, and so is given up.
Execution stopped()
{
  Execution execution;
  execution.progress = [](double) { return false; };
  return execution;
}

} // namespace

// The same content in other arrays is the same mesh: nothing is built.
TEST(MeshMemory, recognizesTheMeshByItsContent)
{
  MeshMemory<SmoothingMesh> memory;
  memory.meshOf(tetrahedron(), {});
  EXPECT_NO_THROW(memory.meshOf(tetrahedron(), stopped()));
}

// Other places, triangles or names of vertices are another mesh.
TEST(MeshMemory, tellsMeshesApart)
{
  MeshedSurface moved = tetrahedron();
  moved.vertices(0, 1) = 2.0;
  MeshedSurface turned = tetrahedron();
  turned.triangles.col(0).reverseInPlace();
  for (const MeshedSurface& other : { moved, turned, tetrahedron(5) })
  {
    MeshMemory<SmoothingMesh> memory;
    memory.meshOf(tetrahedron(), {});
    EXPECT_THROW(memory.meshOf(other, stopped()), Aborted);
    EXPECT_EQ(memory.meshOf(other, {}).vertices(), other.vertices);
  }
}

// What was given up is not kept.
TEST(MeshMemory, keepsNothingThatWasGivenUp)
{
  MeshMemory<SmoothingMesh> memory;
  EXPECT_THROW(memory.meshOf(tetrahedron(), stopped()), Aborted);
  EXPECT_THROW(memory.meshOf(tetrahedron(), stopped()), Aborted);
  EXPECT_NO_THROW(memory.meshOf(tetrahedron(), {}));
}
