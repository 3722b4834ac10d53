#include "ApproximationDomain.h"

namespace SurfaceScalars
{

ApproximationDomain surfaceDomain(const Points& vertices, const MeshTopology& mesh)
{
  return { vertices, mesh.triangles(),
    [&](const ValuesRef& values, const Execution& execution)
    { return meshCriticalPoints(vertices, mesh, values, execution); },
    [&](Index vertex)
    {
      const VertexRange link = mesh.link(vertex);
      return std::vector<Index>(link.begin(), link.end());
    } };
}

} // namespace SurfaceScalars
