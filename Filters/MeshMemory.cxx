#include "MeshMemory.h"

#include "EqualNumbers.h"

namespace SurfaceScalars
{

bool MeshMemory::has(const MeshedSurface& surface) const
{
  return this->mesh_ && this->pointOfVertex_ == surface.map.pointOfVertex &&
    equal(this->mesh_->vertices(), surface.vertices) &&
    equal(this->mesh_->topology().triangles(), surface.triangles);
}

const SmoothingMesh& MeshMemory::meshOf(const MeshedSurface& surface, const Execution& execution)
{
  if (!this->has(surface))
  {
    this->mesh_.reset(); // makes room: there may not be enough memory for two
    this->mesh_ = std::make_unique<const SmoothingMesh>(
      surface.vertices, surface.triangles, execution, surface.map.names());
    this->pointOfVertex_ = surface.map.pointOfVertex;
  }
  return *this->mesh_;
}

} // namespace SurfaceScalars
