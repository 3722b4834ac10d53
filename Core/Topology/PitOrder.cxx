#include "PitOrder.h"

#include <algorithm>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr Index Entry = 0;
constexpr Index Rim = 1;
constexpr Index Unseen = std::numeric_limits<Index>::max();

} // namespace

PitOrder::PitOrder(const MeshTopology& mesh, std::vector<char> isLast)
  : mesh_(mesh)
  , isLast_(std::move(isLast))
  , nodeOf_(mesh.vertexCount(), Rim)
{
}

void PitOrder::sort(Index entry, std::vector<Index>& pit, std::size_t first)
{
  const auto begin = pit.begin() + static_cast<std::ptrdiff_t>(first);
  const auto last =
    std::partition(begin, pit.end(), [this](Index vertex) { return this->isLast_[vertex] == 0; });
  std::for_each(begin, last, [this](Index vertex) { this->nodeOf_[vertex] = Unseen; });
  this->nodeOf_[entry] = Entry;
  this->nodes_ = { { entry, Entry, Entry, nullptr, Entry, Rim, true },
    { entry, Entry, Entry, nullptr, Entry, Rim, false } };
  std::for_each(begin, last,
    [=](Index vertex)
    {
      const VertexRange link = this->mesh_.link(vertex);
      if (this->nodeOf_[vertex] == Unseen &&
        std::any_of(link.begin(), link.end(),
          [this](Index neighbor) { return this->nodeOf_[neighbor] == Rim; }))
      {
        this->search(vertex);
      }
    });
  for (Index node = Rim + 1; node < this->nodes_.size(); ++node)
  {
    this->insert(node);
  }
  std::for_each(begin, last, [this](Index vertex) { this->nodeOf_[vertex] = Rim; });
  this->nodeOf_[entry] = Rim;
  auto place = begin;
  for (Index node = this->nodes_[Entry].after; node != Rim; node = this->nodes_[node].after)
  {
    *place++ = this->nodes_[node].vertex;
  }
}

/// Depth first, from a vertex at the rim.
void PitOrder::search(Index root)
{
  const auto enter = [this](Index vertex, Index parent)
  {
    const auto node = static_cast<Index>(this->nodes_.size());
    this->nodeOf_[vertex] = node;
    this->nodes_.push_back(
      { vertex, parent, node, this->mesh_.link(vertex).begin(), node, node, false });
    return node;
  };
  for (Index node = enter(root, Rim); node != Rim;)
  {
    Node& here = this->nodes_[node];
    if (here.next == this->mesh_.link(here.vertex).end())
    {
      Node& parent = this->nodes_[here.parent];
      parent.low = std::min(parent.low, here.low);
      node = here.parent;
      continue;
    }
    const Index neighbor = *here.next++;
    if (this->nodeOf_[neighbor] == Unseen)
    {
      node = enter(neighbor, node);
    }
    else
    {
      here.low = std::min(here.low, this->nodeOf_[neighbor]);
    }
  }
}

/// Before or after its parent, in the direction in which its low node lies.
void PitOrder::insert(Index node)
{
  Node& here = this->nodes_[node];
  Node& parent = this->nodes_[here.parent];
  const bool isBefore = this->nodes_[here.low].isMinus;
  here.before = isBefore ? parent.before : here.parent;
  here.after = isBefore ? here.parent : parent.after;
  this->nodes_[here.before].after = node;
  this->nodes_[here.after].before = node;
  parent.isMinus = !isBefore;
}

} // namespace SurfaceScalars
