#include "ExtremalVertices.h"

#include "ValueOrder.h"

#include <algorithm>
#include <limits>

namespace SurfaceScalars
{

ExtremalVertices extremaOf(const std::vector<CriticalPoint>& points)
{
  ExtremalVertices result;
  for (const CriticalPoint& point : points)
  {
    if (point.type == CriticalType::Minimum)
    {
      result.minima.push_back(static_cast<Index>(point.input));
    }
    else if (point.type == CriticalType::Maximum)
    {
      result.maxima.push_back(static_cast<Index>(point.input));
    }
  }
  return result;
}

void addComponentExtrema(
  ExtremalVertices& extrema, const MeshTopology& topology, const Values& function)
{
  constexpr Index None = std::numeric_limits<Index>::max();
  const ValueOrder isBelow{ function.data() };
  std::vector<Index> lowest(topology.componentCount(), None);
  std::vector<Index> highest(topology.componentCount(), None);
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    Index& low = lowest[topology.component(vertex)];
    Index& high = highest[topology.component(vertex)];
    low = low == None || isBelow(vertex, low) ? vertex : low;
    high = high == None || isBelow(high, vertex) ? vertex : high;
  }
  const auto add = [](std::vector<Index>& to, const std::vector<Index>& some)
  {
    to.insert(to.end(), some.begin(), some.end());
    std::sort(to.begin(), to.end());
    to.erase(std::unique(to.begin(), to.end()), to.end());
  };
  add(extrema.minima, lowest);
  add(extrema.maxima, highest);
}

} // namespace SurfaceScalars
