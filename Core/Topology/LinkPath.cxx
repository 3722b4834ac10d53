#include "LinkPath.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr Index Loose = ~Index(0);

Index vertexOf(const std::vector<LinkEdge>& edges, Index end)
{
  const LinkEdge& edge = edges[end / 2];
  return end % 2 == 0 ? edge.from : edge.to;
}

} // namespace

LinkShape LinkPath::follow(const std::vector<LinkEdge>& edges)
{
  const LinkShape shape = this->joinEnds(edges);
  if (shape == LinkShape::Branching)
  {
    return shape;
  }
  const Index start = shape == LinkShape::Cycle ? 0 : this->loose_;
  Index end = start;
  bool isReversed = false;
  this->vertices_.assign(1, vertexOf(edges, start));
  do
  {
    isReversed = isReversed || end == 1;
    const Index other = end ^ 1u;
    this->vertices_.push_back(vertexOf(edges, other));
    end = this->partners_[other];
  } while (end != Loose && end != start);
  if (isReversed)
  {
    std::reverse(this->vertices_.begin(), this->vertices_.end());
  }
  return this->vertices_.size() == edges.size() + 1 ? shape : LinkShape::Separate;
}

LinkShape LinkPath::joinEnds(const std::vector<LinkEdge>& edges)
{
  const Index count = 2 * static_cast<Index>(edges.size());
  this->ends_.clear();
  for (Index end = 0; end < count; ++end)
  {
    this->ends_.push_back(std::uint64_t(vertexOf(edges, end)) << 32u | end);
  }
  std::sort(this->ends_.begin(), this->ends_.end());

  this->partners_.assign(count, Loose);
  LinkShape shape = LinkShape::Cycle;
  for (Index i = 0; i < count; ++i)
  {
    const auto vertexAt = [this](Index place) { return this->ends_[place] >> 32u; };
    const auto end = static_cast<Index>(this->ends_[i]);
    if (i + 1 == count || vertexAt(i) != vertexAt(i + 1))
    {
      shape = LinkShape::Path;
      this->loose_ = end;
      continue;
    }
    const auto partner = static_cast<Index>(this->ends_[i + 1]);
    this->partners_[end] = partner;
    this->partners_[partner] = end;
    ++i;
    if (i + 1 < count && vertexAt(i) == vertexAt(i + 1))
    {
      this->branching_ = static_cast<Index>(vertexAt(i));
      return LinkShape::Branching;
    }
  }
  return shape;
}

} // namespace SurfaceScalars
