#include "VolumeCriticalPoints.h"

#include "CriticalPairs.h"
#include "MeshValues.h"
#include "Tunnels.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 4096; // vertices per block of a parallel loop

/// How many components the lower and the upper link of a vertex have, on the glued volume.
struct LinkParts
{
  Index lower = 0;
  Index upper = 0;
};

class LinkCounter
{
public:
  LinkCounter(const VolumeTopology& volume, const ValuesRef& values)
    : volume_(volume)
    , isBelow_{ values.data() }
  {
  }

  LinkParts count(Index vertex)
  {
    const VertexRange link = this->volume_.link(vertex);
    this->findEdges(vertex, link);
    this->isLower_.clear();
    for (const Index neighbor : link)
    {
      this->isLower_.push_back(this->isBelow_(neighbor, vertex) ? 1 : 0);
    }
    this->join(link.size());
    this->onBoundary_.assign(link.size(), 0);
    if (this->volume_.isBoundary(vertex))
    {
      this->markBoundary();
    }
    LinkParts parts;
    for (Index place = 0; place < link.size(); ++place)
    {
      if (this->parents_[place] == place)
      {
        const bool isInside = this->volume_.isBoundary(vertex) && this->onBoundary_[place] == 0;
        (this->isLower_[place] ? parts.lower : parts.upper) += isInside ? 2 : 1;
      }
    }
    return parts;
  }

private:
  using Edge = std::array<Index, 2>; ///< places in the link, ascending

  /// Those of the triangles of the link, each once per triangle.
  void findEdges(Index vertex, VertexRange link)
  {
    this->edges_.clear();
    for (const Index tetrahedron : this->volume_.star(vertex))
    {
      std::array<Index, 3> places{};
      std::size_t count = 0;
      for (const Index corner : this->volume_.tetrahedra().col(tetrahedron))
      {
        if (corner != vertex)
        {
          places[count++] =
            static_cast<Index>(std::lower_bound(link.begin(), link.end(), corner) - link.begin());
        }
      }
      std::sort(places.begin(), places.end());
      this->edges_.push_back({ places[0], places[1] });
      this->edges_.push_back({ places[0], places[2] });
      this->edges_.push_back({ places[1], places[2] });
    }
  }

  void join(Index count)
  {
    this->parents_.resize(count);
    for (Index place = 0; place < count; ++place)
    {
      this->parents_[place] = place;
    }
    for (const Edge& edge : this->edges_)
    {
      if (this->isLower_[edge[0]] == this->isLower_[edge[1]])
      {
        const auto [first, second] = std::minmax({ this->rootOf(edge[0]), this->rootOf(edge[1]) });
        this->parents_[second] = first;
      }
    }
  }

  Index rootOf(Index place) const
  {
    while (this->parents_[place] != place)
    {
      place = this->parents_[place];
    }
    return place;
  }

  /// At their roots, the parts with an edge of only one triangle at one of their vertices.
  void markBoundary()
  {
    std::sort(this->edges_.begin(), this->edges_.end());
    for (std::size_t i = 0; i < this->edges_.size(); ++i)
    {
      const Edge& edge = this->edges_[i];
      const bool isAlone = (i == 0 || this->edges_[i - 1] != edge) &&
        (i + 1 == this->edges_.size() || this->edges_[i + 1] != edge);
      if (isAlone)
      {
        this->onBoundary_[this->rootOf(edge[0])] = 1;
        this->onBoundary_[this->rootOf(edge[1])] = 1;
      }
    }
  }

  const VolumeTopology& volume_;
  ValueOrder isBelow_;
  std::vector<Edge> edges_;
  std::vector<char> isLower_; ///< of the vertices of the link
  std::vector<Index> parents_;
  std::vector<char> onBoundary_;
};

CriticalType typeOf(const LinkParts& parts)
{
  if (parts.lower == 0 || parts.upper == 0)
  {
    return parts.lower == 0 ? CriticalType::Minimum : CriticalType::Maximum;
  }
  if (parts.lower == 1 && parts.upper == 1)
  {
    return CriticalType::Regular;
  }
  return parts.upper > parts.lower ? CriticalType::TwoSaddle : CriticalType::Saddle;
}

/// The critical points, each at most once among the starts of a sublevel set and its merges, and
/// once among those of a superlevel set.
struct CriticalVertices
{
  std::vector<CriticalPoint> points;
  std::vector<Index> below; ///< of each vertex: the minimum or 1-saddle
  std::vector<Index> above; ///< the maximum or 2-saddle
};

CriticalVertices criticalVertices(
  const PointsRef& vertices, const ValuesRef& values, const VolumeTypes& types)
{
  CriticalVertices critical;
  critical.below.assign(types.types.size(), 0);
  critical.above.assign(types.types.size(), 0);
  for (Index vertex = 0; vertex < types.types.size(); ++vertex)
  {
    const auto add = [&](CriticalType type, Index multiplicity, std::vector<Index>& pointOfVertex)
    {
      pointOfVertex[vertex] = static_cast<Index>(critical.points.size());
      critical.points.push_back(criticalVertex(vertices, values, vertex, type, multiplicity));
    };
    if (types.types[vertex] == CriticalType::Minimum)
    {
      add(CriticalType::Minimum, 1, critical.below);
    }
    if (types.oneSaddles[vertex] > 0)
    {
      add(CriticalType::Saddle, types.oneSaddles[vertex], critical.below);
    }
    if (types.twoSaddles[vertex] > 0)
    {
      add(CriticalType::TwoSaddle, types.twoSaddles[vertex], critical.above);
    }
    if (types.types[vertex] == CriticalType::Maximum)
    {
      add(CriticalType::Maximum, 1, critical.above);
    }
  }
  return critical;
}

} // namespace

VolumeTypes classifyVolumeVertices(
  const VolumeTopology& volume, const ValuesRef& values, const Execution& execution)
{
  checkVertexValues(volume.vertexCount(), values);
  VolumeTypes result;
  result.types.resize(volume.vertexCount());
  result.oneSaddles.resize(volume.vertexCount());
  result.twoSaddles.resize(volume.vertexCount());
  parallelFor(volume.vertexCount(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      LinkCounter counter(volume, values);
      for (std::size_t vertex = begin; vertex < end; ++vertex)
      {
        const LinkParts parts = counter.count(static_cast<Index>(vertex));
        result.types[vertex] = typeOf(parts);
        result.oneSaddles[vertex] = parts.lower > 0 ? parts.lower - 1 : 0;
        result.twoSaddles[vertex] = parts.upper > 0 ? parts.upper - 1 : 0;
      }
    });
  for (Index vertex = 0; vertex < volume.vertexCount(); ++vertex)
  {
    result.counts.minima += result.types[vertex] == CriticalType::Minimum ? 1 : 0;
    result.counts.maxima += result.types[vertex] == CriticalType::Maximum ? 1 : 0;
    result.counts.oneSaddles += result.oneSaddles[vertex];
    result.counts.twoSaddles += result.twoSaddles[vertex];
  }
  return result;
}

MeshCriticalPoints volumeCriticalPoints(const PointsRef& vertices, const VolumeTopology& volume,
  const ValuesRef& values, const Execution& execution)
{
  checkVertexPlaces(volume.vertexCount(), vertices, "volume");
  const VolumeTypes types = classifyVolumeVertices(volume, values, execution.part(0.0, 0.1));
  const Execution ofTrees = execution.part(0.1, 0.2);
  const auto neighborsOf = [&](Index vertex) { return volume.link(vertex); };
  const ValueOrder isBelow{ values.data() };
  const MergeTrees trees = volume.isClosed()
    ? MergeTreesBuilder(volume.vertexCount(), neighborsOf, isBelow, ofTrees).build()
    : mirroredMergeTrees(volume, values, ofTrees);
  CriticalVertices critical = criticalVertices(vertices, values, types);
  PairCollector collector(volume, values, std::move(critical.points));
  collector.add(trees.sublevel, critical.below);
  collector.add(trees.superlevel, critical.above);
  const VertexOrder order =
    orderByValue(values, ExtremumSigns(volume.vertexCount(), 0), execution.part(0.2, 0.3));
  const auto addTunnels = [&](bool isRelative, const Execution& ofTunnels)
  {
    for (const Tunnel& tunnel : tunnelsOf(volume, order, isRelative, ofTunnels))
    {
      if (types.twoSaddles[tunnel.twoSaddle] > 0) // not so where the volume is no manifold
      {
        collector.add(critical.below[tunnel.oneSaddle], critical.above[tunnel.twoSaddle]);
      }
    }
  };
  addTunnels(false, execution.part(0.3, 0.6));
  if (!volume.isClosed())
  {
    addTunnels(true, execution.part(0.6, 0.9));
  }
  MeshCriticalPoints result = collector.conclude();
  execution.report(1.0);
  return result;
}

VolumeCounts volumeCountsOf(const std::vector<CriticalPoint>& points)
{
  VolumeCounts counts;
  for (const CriticalPoint& point : points)
  {
    Index& count = point.type == CriticalType::Minimum ? counts.minima
      : point.type == CriticalType::Saddle             ? counts.oneSaddles
      : point.type == CriticalType::TwoSaddle          ? counts.twoSaddles
                                                       : counts.maxima;
    count += static_cast<Index>(point.multiplicity);
  }
  return counts;
}

} // namespace SurfaceScalars
