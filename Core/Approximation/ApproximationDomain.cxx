#include "ApproximationDomain.h"

#include "VolumeCriticalPoints.h"
#include "VolumeDomain.h"

namespace SurfaceScalars
{
namespace
{

template <auto criticalPoints, class Topology>
ApproximationDomain domainOf(
  const Points& vertices, const SimplicesRef& simplices, const Topology& topology)
{
  return { vertices, simplices,
    [&](const ValuesRef& values, const Execution& execution)
    { return criticalPoints(vertices, topology, values, execution); },
    [&](Index vertex)
    {
      const VertexRange link = topology.link(vertex);
      return std::vector<Index>(link.begin(), link.end());
    } };
}

} // namespace

ApproximationDomain surfaceDomain(const Points& vertices, const MeshTopology& mesh)
{
  return domainOf<meshCriticalPoints>(vertices, mesh.triangles(), mesh);
}

ApproximationDomain volumeDomain(const Points& vertices, const VolumeTopology& volume)
{
  return domainOf<volumeCriticalPoints>(vertices, volume.tetrahedra(), volume);
}

} // namespace SurfaceScalars
