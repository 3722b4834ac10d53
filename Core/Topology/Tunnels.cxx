#include "Tunnels.h"

#include "LowerStarPairing.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1024; // vertices per block
constexpr Index None = StarPairs::None;

/// A volume whose simplices are paired in the lower stars of its vertices.
struct PairedVolume
{
  explicit PairedVolume(const VolumeTopology& volume)
    : blocks((volume.vertexCount() + Grain - 1) / Grain)
    , firstEdges(1, 0)
    , tetrahedra(static_cast<Index>(volume.tetrahedra().cols()) + 1)
  {
  }

  /// In the order in which they are met; None if it is left out.
  /// @param last, end places of its vertices, last > end
  Index edge(Index last, Index end) const
  {
    const std::vector<StarPairs::Edge>& edges = this->blocks[last / Grain].edges;
    const Index begin = this->firstEdges[last / Grain * Grain];
    const auto stop = edges.begin() + (this->firstEdges[last + 1] - begin);
    const auto found = std::lower_bound(edges.begin() + (this->firstEdges[last] - begin), stop, end,
      [](const StarPairs::Edge& edge, Index other) { return edge.end < other; });
    return found == stop || found->end != end ? None : this->firstEdges[last] + found->turn;
  }

  /// The place of the vertex that an edge comes with.
  Index lastVertex(Index edge) const
  {
    return static_cast<Index>(
      std::upper_bound(this->firstEdges.begin(), this->firstEdges.end(), edge) -
      this->firstEdges.begin() - 1);
  }

  std::vector<StarPairs> blocks;
  std::vector<Index> firstEdges; ///< of each place, and the end
  DisjointSets tetrahedra;       ///< and the outside; each attached to the next along the pairs
};

PairedVolume pairVolume(const VolumeTopology& volume, const VertexOrder& order, bool isRelative,
  const Execution& execution)
{
  PairedVolume paired(volume);
  parallelFor(volume.vertexCount(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      LowerStarPairing pairing(
        volume, order, isRelative, paired.blocks[begin / Grain], paired.tetrahedra);
      for (std::size_t place = begin; place < end; ++place)
      {
        pairing.add(static_cast<Index>(place));
      }
    });
  for (const StarPairs& block : paired.blocks)
  {
    for (const Index count : block.counts)
    {
      paired.firstEdges.push_back(paired.firstEdges.back() + count);
    }
  }
  return paired;
}

using EdgePair = std::array<Index, 2>;

/// Of each edge, the others of the triangle that it is paired with, None for those left out; itself
/// twice if there is no such triangle.
std::vector<EdgePair> otherEdges(const PairedVolume& paired, const Execution& execution)
{
  std::vector<EdgePair> result(paired.firstEdges.back());
  parallelFor(paired.firstEdges.size() - 1, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      auto edge = paired.blocks[begin / Grain].edges.begin();
      for (std::size_t place = begin; place < end; ++place)
      {
        const Index first = paired.firstEdges[place];
        for (Index i = first; i < paired.firstEdges[place + 1]; ++i, ++edge)
        {
          const auto [a, b] = edge->ofTriangle;
          const Index number = first + edge->turn;
          result[number] = a == None ? EdgePair{ number, number }
                                     : EdgePair{ paired.edge(static_cast<Index>(place), b),
                                         paired.edge(std::max(a, b), std::min(a, b)) };
        }
      }
    });
  return result;
}

/// The unpaired triangles that end a tunnel or begin a void that never ends, in the order in which
/// they are met. What comes after some simplex falls into parts, the outside one of them: going
/// back, the other triangles join two of them, and began what the later of these closed.
std::vector<UnpairedTriangle> endingTriangles(PairedVolume& paired, const Execution& execution)
{
  std::vector<UnpairedTriangle> result;
  for (auto block = paired.blocks.rbegin(); block != paired.blocks.rend(); ++block)
  {
    for (auto triangle = block->triangles.rbegin(); triangle != block->triangles.rend(); ++triangle)
    {
      const Index first = paired.tetrahedra.find(triangle->tetrahedra[0]);
      const Index second = paired.tetrahedra.find(triangle->tetrahedra[1]);
      if (first == second)
      {
        result.push_back(*triangle);
      }
      else
      {
        paired.tetrahedra.attach(first, second);
      }
    }
    execution.report(0.0);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

/// A sum of edges over Z2: a heap, the last edge on top, in which equal ones cancel.
class Chain
{
public:
  template <class Edges>
  void add(const Edges& edges)
  {
    for (const Index edge : edges)
    {
      if (edge != None)
      {
        this->edges_.push_back(edge);
        std::push_heap(this->edges_.begin(), this->edges_.end());
      }
    }
  }

  /// Takes the last edge out. @returns None for the empty sum
  Index popLast()
  {
    while (!this->edges_.empty())
    {
      const Index last = this->pop();
      if (this->edges_.empty() || this->edges_.front() != last)
      {
        return last;
      }
      this->pop();
    }
    return None;
  }

  std::vector<Index> takeAll()
  {
    std::vector<Index> all;
    for (Index last = this->popLast(); last != None; last = this->popLast())
    {
      all.push_back(last);
    }
    return all;
  }

private:
  Index pop()
  {
    std::pop_heap(this->edges_.begin(), this->edges_.end());
    const Index last = this->edges_.back();
    this->edges_.pop_back();
    return last;
  }

  std::vector<Index> edges_;
};

/// Reduces the boundaries of triangles one after the other.
class BoundaryReduction
{
public:
  BoundaryReduction(const PairedVolume& paired, const Execution& execution)
    : paired_(paired)
    , others_(otherEdges(paired, execution))
  {
  }

  /// The last edge of the loop that a triangle fills: the loop began with it. None if others have
  /// filled it already.
  Index edgeOf(const UnpairedTriangle& triangle, const Poll& poll)
  {
    const auto [a, b, c] = triangle.corners;
    Chain loop;
    loop.add(
      std::array{ this->paired_.edge(a, b), this->paired_.edge(a, c), this->paired_.edge(b, c) });
    for (Index last = loop.popLast(); last != None; last = loop.popLast())
    {
      if (this->others_[last][0] != last)
      {
        this->add(this->others_[last], loop, poll);
        continue;
      }
      const auto [reduced, isNew] = this->rests_.try_emplace(last);
      if (isNew)
      {
        reduced->second = loop.takeAll();
        return last;
      }
      this->add(reduced->second, loop, poll);
    }
    return None;
  }

private:
  static constexpr std::size_t EdgesBetweenPolls = 1 << 18;

  template <class Edges>
  void add(const Edges& edges, Chain& loop, const Poll& poll)
  {
    loop.add(edges);
    this->added_ += edges.size();
    if (this->added_ > EdgesBetweenPolls)
    {
      this->added_ = 0;
      poll();
    }
  }

  const PairedVolume& paired_;
  std::vector<EdgePair> others_;
  std::unordered_map<Index, std::vector<Index>> rests_; ///< of reduced boundaries, by last edges
  std::size_t added_ = 0;                               ///< since the last poll
};

} // namespace

std::vector<Tunnel> tunnelsOf(const VolumeTopology& volume, const VertexOrder& order,
  bool isRelative, const Execution& execution)
{
  PairedVolume paired = pairVolume(volume, order, isRelative, execution.part(0.0, 0.5));
  const std::vector<UnpairedTriangle> triangles = endingTriangles(paired, execution.part(0.5, 0.5));
  BoundaryReduction reduction(paired, execution.part(0.5, 0.6));
  const Execution ofReduction = execution.part(0.6, 1.0);
  std::vector<Tunnel> tunnels;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto poll = [&]()
    { ofReduction.report(static_cast<double>(i) / static_cast<double>(triangles.size())); };
    const Index last = triangles[i].corners[0];
    const Index edge = reduction.edgeOf(triangles[i], poll);
    const Index first = edge == None ? last : paired.lastVertex(edge);
    if (first != last)
    {
      tunnels.push_back({ order.vertexAt(first), order.vertexAt(last) });
    }
  }
  execution.report(1.0);
  return tunnels;
}

} // namespace SurfaceScalars
