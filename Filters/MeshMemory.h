#pragma once

#include "ConstrainedSmoothing.h"
#include "SurfaceVertices.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

/**
 * The mesh that was smoothed on last, with its topology, Laplacians and factors, for filters that
 * run again with other parameters or the next time step.
 *
 * Compared by content, for a time step brings new arrays of the same points and triangles.
 */
class MeshMemory
{
public:
  /// A surface as a mesh to smooth on. Valid until the next call.
  const SmoothingMesh& meshOf(const MeshedSurface& surface, const Execution& execution);

private:
  bool has(const MeshedSurface& surface) const;

  std::unique_ptr<const SmoothingMesh> mesh_;
  std::vector<vtkIdType> pointOfVertex_; ///< by which the mesh names its vertices
};

} // namespace SurfaceScalars
