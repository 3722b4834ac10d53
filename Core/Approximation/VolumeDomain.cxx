#include "VolumeDomain.h"

#include "VolumeCriticalPoints.h"

#include <cstddef>

namespace SurfaceScalars
{
namespace
{

/// Makes removeBelow() take away what saddles have beyond the extrema that they end: as often a
/// pair of no persistence, with themselves.
void addTunnels(MeshCriticalPoints& critical)
{
  std::vector<int> left;
  for (const CriticalPoint& point : critical.points)
  {
    const bool isSaddle =
      point.type == CriticalType::Saddle || point.type == CriticalType::TwoSaddle;
    left.push_back(isSaddle ? point.multiplicity : 0);
  }
  for (const CriticalPair& pair : critical.pairs)
  {
    --left[pair.saddle];
  }
  for (std::size_t point = 0; point < left.size(); ++point)
  {
    for (; left[point] > 0; --left[point])
    {
      critical.pairs.push_back({ point, point, 0.0 });
    }
  }
}

} // namespace

ApproximationDomain volumeDomain(const Points& vertices, const VolumeTopology& volume)
{
  return { vertices, volume.tetrahedra(),
    [&](const ValuesRef& values, const Execution& execution)
    {
      MeshCriticalPoints critical = volumeCriticalPoints(vertices, volume, values, execution);
      addTunnels(critical);
      return critical;
    },
    [&](Index vertex)
    {
      const VertexRange link = volume.link(vertex);
      return std::vector<Index>(link.begin(), link.end());
    } };
}

} // namespace SurfaceScalars
