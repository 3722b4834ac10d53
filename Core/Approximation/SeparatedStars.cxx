#include "SeparatedStars.h"

#include "ValueOrder.h"

#include <algorithm>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double LeastStep = 1e-7; // of f's range: above what interpolation misses

using Edge = std::pair<Index, Index>; ///< from the higher to the lower vertex

std::vector<Edge> edgesOf(const ApproximationDomain& domain,
  const std::vector<CriticalPoint>& points, const ValueOrder& isBelow)
{
  std::vector<Edge> edges;
  for (const CriticalPoint& point : points)
  {
    const auto vertex = static_cast<Index>(point.input);
    for (const Index neighbor : domain.link(vertex))
    {
      edges.push_back(
        isBelow(neighbor, vertex) ? Edge{ vertex, neighbor } : Edge{ neighbor, vertex });
    }
  }
  return edges;
}

} // namespace

Values withSeparatedStars(const ApproximationDomain& domain, const ValuesRef& values,
  const std::vector<CriticalPoint>& points)
{
  const double step = LeastStep * (values.maxCoeff() - values.minCoeff());
  const ValueOrder isBelow{ values.data() };
  std::vector<Edge> edges = edgesOf(domain, points, isBelow);
  std::sort(edges.begin(), edges.end(),
    [&](const Edge& a, const Edge& b) { return isBelow(a.first, b.first); });
  Values separated = values;
  for (const auto& [higher, lower] : edges) // a lower vertex has its value by then
  {
    separated[higher] = std::max(separated[higher], separated[lower] + step);
  }
  return separated;
}

} // namespace SurfaceScalars
