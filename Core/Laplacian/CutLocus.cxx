#include "CutLocus.h"

#include <algorithm>
#include <unordered_map>

namespace SurfaceScalars
{
namespace
{

/// Neighbors of triangles, across the edge from each corner to the next.
std::vector<std::array<Index, 3>> trianglesAcross(const Triangles& triangles)
{
  std::vector<std::array<Index, 3>> result(triangles.cols());
  std::vector<std::pair<std::uint64_t, Index>> sides; // and 4 * triangle + corner
  sides.reserve(3 * triangles.cols());
  for (Index triangle = 0; triangle < triangles.cols(); ++triangle)
  {
    for (Index corner = 0; corner < 3; ++corner)
    {
      const MeshEdge edge{ triangles(corner, triangle), triangles((corner + 1) % 3, triangle) };
      sides.emplace_back(edge.key(), 4 * triangle + corner);
    }
  }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); i += 2)
  {
    const Index one = sides[i].second;
    const Index other = sides[i + 1].second;
    result[one / 4][one % 4] = other / 4;
    result[other / 4][other % 4] = one / 4;
  }
  return result;
}

int degreeOf(const std::array<char, 3>& isOpen)
{
  return isOpen[0] + isOpen[1] + isOpen[2];
}

} // namespace

std::uint64_t MeshEdge::key() const
{
  return (std::uint64_t(std::min(this->from, this->to)) << 32) | std::max(this->from, this->to);
}

CutLocus::CutLocus(const MeshTopology& mesh)
  : mesh_(mesh)
  , neighbors_(trianglesAcross(mesh.triangles()))
{
}

void CutLocus::find(const std::vector<char>& isInNetwork, const std::vector<Index>& previous,
  const std::vector<Index>& points)
{
  const Triangles& triangles = this->mesh_.triangles();
  const auto isOutside = [&](Index vertex)
  { return isInNetwork[vertex] != 0 || previous[vertex] == vertex; };
  this->isOpen_.resize(this->neighbors_.size());
  for (Eigen::Index triangle = 0; triangle < triangles.cols(); ++triangle)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Index from = triangles(corner, triangle);
      const Index to = triangles((corner + 1) % 3, triangle);
      const bool isWall = isOutside(from) && isOutside(to);
      const bool isInTree = previous[from] == to || previous[to] == from;
      this->isOpen_[triangle][corner] = !isWall && !isInTree ? 1 : 0;
    }
  }
  this->puncture(points);
  this->removeDeadEnds();
  this->collectChains();
}

void CutLocus::puncture(const std::vector<Index>& points)
{
  std::unordered_set<Index> left(points.begin(), points.end());
  const Triangles& triangles = this->mesh_.triangles();
  this->isPoint_.assign(this->neighbors_.size(), 0);
  for (Eigen::Index triangle = 0; triangle < triangles.cols() && !left.empty(); ++triangle)
  {
    for (const Index corner : triangles.col(triangle))
    {
      this->isPoint_[triangle] |= left.erase(corner) > 0 ? 1 : 0;
    }
  }
}

void CutLocus::removeDeadEnds()
{
  for (Index start = 0; start < this->neighbors_.size(); ++start)
  {
    Index triangle = start;
    while (this->isPoint_[triangle] == 0 && degreeOf(this->isOpen_[triangle]) == 1)
    {
      const std::array<char, 3>& isOpen = this->isOpen_[triangle];
      const auto side = std::find(isOpen.begin(), isOpen.end(), 1) - isOpen.begin();
      const Index next = this->neighbors_[triangle][side];
      const std::array<Index, 3>& across = this->neighbors_[next];
      const auto back = std::find(across.begin(), across.end(), triangle) - across.begin();
      this->isOpen_[triangle][side] = 0;
      this->isOpen_[next][back] = 0;
      triangle = next;
    }
  }
}

void CutLocus::collectChains()
{
  const auto isLink = [&](Index triangle)
  { return this->isPoint_[triangle] == 0 && degreeOf(this->isOpen_[triangle]) == 2; };
  const auto forEachCrossing = [&](const auto& body)
  {
    for (Index triangle = 0; triangle < this->neighbors_.size(); ++triangle)
    {
      for (int side = 0; side < 3; ++side)
      {
        const Index other = this->neighbors_[triangle][side];
        if (this->isOpen_[triangle][side] != 0 && triangle < other)
        {
          body(triangle, other, side);
        }
      }
    }
  };
  DisjointSets sets(static_cast<Index>(this->neighbors_.size()));
  forEachCrossing(
    [&](Index triangle, Index other, int)
    {
      const Index one = sets.find(triangle);
      const Index root = sets.find(other);
      if (one != root && isLink(triangle) && isLink(other))
      {
        sets.attach(one, root);
      }
    });

  this->chains_.clear();
  this->crossed_.clear();
  std::unordered_map<Index, std::size_t> chainOf;
  forEachCrossing(
    [&](Index triangle, Index other, int side)
    {
      const Triangles& triangles = this->mesh_.triangles();
      const MeshEdge edge{ triangles(side, triangle), triangles((side + 1) % 3, triangle) };
      this->crossed_.insert(edge.key());
      std::size_t chain = this->chains_.size();
      if (isLink(triangle) || isLink(other))
      {
        const Index root = sets.find(isLink(triangle) ? triangle : other);
        chain = chainOf.emplace(root, chain).first->second;
      }
      if (chain == this->chains_.size())
      {
        this->chains_.emplace_back();
      }
      this->chains_[chain].push_back(edge);
    });
}

} // namespace SurfaceScalars
