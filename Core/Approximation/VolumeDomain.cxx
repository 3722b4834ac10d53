#include "VolumeDomain.h"

#include "VolumeCriticalPoints.h"

namespace SurfaceScalars
{

ApproximationDomain volumeDomain(const Points& vertices, const VolumeTopology& volume)
{
  return { vertices, volume.tetrahedra(),
    [&](const ValuesRef& values, const Execution& execution)
    { return volumeCriticalPoints(vertices, volume, values, execution); },
    [&](Index vertex)
    {
      const VertexRange link = volume.link(vertex);
      return std::vector<Index>(link.begin(), link.end());
    } };
}

} // namespace SurfaceScalars
