#include "LowerStarPairing.h"

#include <algorithm>
#include <functional>
#include <iterator>

namespace SurfaceScalars
{
namespace
{

using Corners = std::array<Index, 3>;

Corners without(const Corners& corners, std::size_t left)
{
  Corners face{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    if (i != left)
    {
      face[count++] = corners[i];
    }
  }
  return face;
}

std::size_t countOf(const Corners& corners)
{
  return static_cast<std::size_t>(std::find(corners.begin(), corners.end(), 0) - corners.begin());
}

void push(std::vector<Index>& heap, Index simplex)
{
  heap.push_back(simplex);
  std::push_heap(heap.begin(), heap.end(), std::greater<>());
}

Index pop(std::vector<Index>& heap)
{
  std::pop_heap(heap.begin(), heap.end(), std::greater<>());
  const Index first = heap.back();
  heap.pop_back();
  return first;
}

} // namespace

LowerStarPairing::LowerStarPairing(const VolumeTopology& volume, const VertexOrder& order,
  bool isRelative, StarPairs& pairs, DisjointSets& tetrahedra)
  : volume_(volume)
  , order_(order)
  , isRelative_(isRelative)
  , pairs_(pairs)
  , tetrahedra_(tetrahedra)
{
}

void LowerStarPairing::add(Index place)
{
  this->place_ = place;
  this->turn_ = 0;
  this->gather();
  this->findFaces();
  this->addEdges();
  while (!this->ready_.empty() || !this->free_.empty())
  {
    if (!this->ready_.empty())
    {
      this->meetWithFace(pop(this->ready_));
    }
    else
    {
      this->meetAlone(pop(this->free_));
    }
  }
}

void LowerStarPairing::gather()
{
  const Index vertex = this->order_.vertexAt(this->place_);
  const bool hasGaps = this->isRelative_ && this->volume_.isBoundary(vertex);
  this->sides_.clear();
  this->simplices_.assign(1, Simplex{});
  for (const Index neighbor : this->volume_.link(vertex))
  {
    const Index place = this->order_.placeOf(neighbor);
    if (place < this->place_)
    {
      this->simplices_.push_back({ place + 1 });
    }
  }
  for (const Index tetrahedron : this->volume_.star(vertex))
  {
    this->gather(vertex, tetrahedron, hasGaps);
  }
  std::sort(this->sides_.begin(), this->sides_.end());
  for (std::size_t i = 0; i < this->sides_.size(); ++i)
  {
    const Simplex& triangle = this->sides_[i].triangle;
    if (this->isLower(triangle) && (i == 0 || triangle != this->sides_[i - 1].triangle))
    {
      this->simplices_.push_back(triangle);
    }
  }
  std::sort(this->simplices_.begin(), this->simplices_.end());
  if (hasGaps)
  {
    this->removeBoundary();
  }
}

/// A tetrahedron at the vertex, and its sides.
/// @param all also those that are not in the lower star
void LowerStarPairing::gather(Index vertex, Index tetrahedron, bool all)
{
  Simplex corners{};
  std::size_t count = 0;
  for (const Index corner : this->volume_.tetrahedra().col(tetrahedron))
  {
    if (corner != vertex)
    {
      corners[count++] = 1 + this->order_.placeOf(corner);
    }
  }
  std::sort(corners.begin(), corners.end(), std::greater<>());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Simplex triangle = without(corners, i);
    if (all || this->isLower(triangle))
    {
      this->sides_.push_back({ triangle, corners[i], tetrahedron });
    }
  }
  if (this->isLower(corners))
  {
    this->simplices_.push_back(corners);
  }
}

/// The triangles of one tetrahedron, and their faces.
void LowerStarPairing::removeBoundary()
{
  std::vector<Simplex> boundary{ Simplex{} };
  for (const Side& side : this->sides_)
  {
    const auto [first, last] = std::equal_range(this->sides_.begin(), this->sides_.end(), side);
    if (last - first == 1)
    {
      const auto [a, b, none] = side.triangle;
      boundary.insert(boundary.end(), { { a }, { b }, { a, b } });
    }
  }
  std::sort(boundary.begin(), boundary.end());
  std::vector<Simplex> rest;
  std::set_difference(this->simplices_.begin(), this->simplices_.end(), boundary.begin(),
    boundary.end(), std::back_inserter(rest));
  this->simplices_.swap(rest);
}

void LowerStarPairing::findFaces()
{
  const auto count = static_cast<Index>(this->simplices_.size());
  this->incidences_.assign(3 * std::size_t(count), {});
  this->firstIncidences_.assign(count, None);
  this->left_.assign(count, 0);
  this->isMet_.assign(count, 0);
  for (Index simplex = 0; simplex < count; ++simplex)
  {
    const Simplex& corners = this->simplices_[simplex];
    const auto place = this->simplices_.begin() + simplex;
    for (std::size_t i = 0; i < countOf(corners); ++i)
    {
      const Simplex face = without(corners, i);
      const auto found = std::lower_bound(this->simplices_.begin(), place, face);
      if (found != place && *found == face)
      {
        const auto index = static_cast<Index>(found - this->simplices_.begin());
        const Index incidence = 3 * simplex + static_cast<Index>(i);
        this->incidences_[incidence] = { index, this->firstIncidences_[index] };
        this->firstIncidences_[index] = incidence;
        ++this->left_[simplex];
      }
    }
    if (this->left_[simplex] < 2)
    {
      push(this->left_[simplex] == 0 ? this->free_ : this->ready_, simplex);
    }
  }
}

void LowerStarPairing::addEdges()
{
  this->edges_.assign(this->simplices_.size(), None);
  Index count = 0;
  for (std::size_t i = 0; i < this->simplices_.size(); ++i)
  {
    if (countOf(this->simplices_[i]) == 1)
    {
      this->edges_[i] = static_cast<Index>(this->pairs_.edges.size());
      this->pairs_.edges.push_back({ this->simplices_[i][0] - 1, None, { None, None } });
      ++count;
    }
  }
  this->pairs_.counts.push_back(count);
}

void LowerStarPairing::meet(Index simplex)
{
  this->isMet_[simplex] = 1;
  if (this->edges_[simplex] != None)
  {
    this->pairs_.edges[this->edges_[simplex]].turn = this->turn_++;
  }
  for (Index i = this->firstIncidences_[simplex]; i != None; i = this->incidences_[i].next)
  {
    const Index left = --this->left_[i / 3];
    if (left < 2)
    {
      push(left == 0 ? this->free_ : this->ready_, i / 3);
    }
  }
}

void LowerStarPairing::meetWithFace(Index simplex)
{
  if (this->isMet_[simplex] != 0 || this->left_[simplex] != 1)
  {
    return;
  }
  const auto* incidence = &this->incidences_[3 * std::size_t(simplex)];
  while (incidence->face == None || this->isMet_[incidence->face] != 0)
  {
    ++incidence;
  }
  const Index face = incidence->face;
  const Simplex& small = this->simplices_[face];
  const Simplex& large = this->simplices_[simplex];
  if (countOf(small) == 1)
  {
    const Index third = large[0] == small[0] ? large[1] : large[0];
    this->pairs_.edges[this->edges_[face]].ofTriangle = { small[0] - 1, third - 1 };
  }
  else if (countOf(small) == 2)
  {
    this->attach(small, large);
  }
  this->meet(face);
  this->meet(simplex);
}

void LowerStarPairing::meetAlone(Index simplex)
{
  if (this->isMet_[simplex] != 0)
  {
    return;
  }
  const Simplex& corners = this->simplices_[simplex];
  if (countOf(corners) == 2)
  {
    const auto [first, last] =
      std::equal_range(this->sides_.begin(), this->sides_.end(), Side{ corners, 0, 0 });
    const Index outside = static_cast<Index>(this->volume_.tetrahedra().cols());
    this->pairs_.triangles.push_back({ { this->place_, corners[0] - 1, corners[1] - 1 },
      { first->tetrahedron, last - first == 2 ? std::next(first)->tetrahedron : outside } });
  }
  this->meet(simplex);
}

void LowerStarPairing::attach(const Simplex& triangle, const Simplex& tetrahedron)
{
  const auto [first, last] =
    std::equal_range(this->sides_.begin(), this->sides_.end(), Side{ triangle, 0, 0 });
  const auto isSelf = [&](const Side& side)
  { return std::find(tetrahedron.begin(), tetrahedron.end(), side.opposite) != tetrahedron.end(); };
  const auto self = std::find_if(first, last, isSelf);
  const auto other = std::find_if_not(first, last, isSelf);
  this->tetrahedra_.attach(self->tetrahedron,
    other == last ? static_cast<Index>(this->volume_.tetrahedra().cols()) : other->tetrahedron);
}

} // namespace SurfaceScalars
