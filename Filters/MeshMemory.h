#pragma once

#include "EqualNumbers.h"
#include "SurfaceVertices.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

/**
 * The mesh that was worked on last, a SmoothingMesh or DesignMesh with what it keeps, for filters
 * that run again with other parameters or the next time step.
 *
 * Compared by content, for a time step brings new arrays of the same points and triangles.
 */
template <class Mesh>
class MeshMemory
{
public:
  /// A surface as a mesh to work on. Valid until the next call.
  const Mesh& meshOf(const MeshedSurface& surface, const Execution& execution)
  {
    if (!this->has(surface))
    {
      this->mesh_.reset(); // makes room: there may not be enough memory for two
      this->mesh_ = std::make_unique<const Mesh>(
        surface.vertices, surface.triangles, execution, surface.map.names());
      this->pointOfVertex_ = surface.map.pointOfVertex;
    }
    return *this->mesh_;
  }

private:
  bool has(const MeshedSurface& surface) const
  {
    return this->mesh_ && this->pointOfVertex_ == surface.map.pointOfVertex &&
      equal(this->mesh_->vertices(), surface.vertices) &&
      equal(this->mesh_->topology().triangles(), surface.triangles);
  }

  std::unique_ptr<const Mesh> mesh_;
  std::vector<vtkIdType> pointOfVertex_; ///< by which the mesh names its vertices
};

} // namespace SurfaceScalars
