#pragma once

#include "Simplices.h"
#include "ValueRanks.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{

/// A vertex, or its image on the other side.
using Vertex = std::pair<Index, int>;

struct VertexPair
{
  int dimension;
  Vertex birth;
  Vertex death;
};

/// What a mesh or volume with boundary is reduced as.
enum class Boundary
{
  AsItIs,
  Mirrored ///< glued to its mirror image along the boundary
};

/// The pairs of all dimensions by reduction of the boundary matrix over Z2, each simplex with its
/// highest vertex. The image of a simplex that is not on the boundary is another one even if all
/// its vertices are.
class ReducedPairs
{
public:
  ReducedPairs(const SimplicesRef& simplices, const Values& values, Boundary boundary)
    : vertexOf_(static_cast<std::size_t>(values.size()))
  {
    const std::vector<int> ranks = ranksOf(values);
    for (std::size_t i = 0; i < ranks.size(); ++i)
    {
      this->vertexOf_[static_cast<std::size_t>(ranks[i])] = static_cast<Index>(i);
    }
    std::vector<Corners> cells;
    for (Eigen::Index cell = 0; cell < simplices.cols(); ++cell)
    {
      Corners corners;
      for (const Index vertex : simplices.col(cell))
      {
        corners.push_back(2 * ranks[vertex]);
      }
      std::sort(corners.rbegin(), corners.rend());
      cells.push_back(corners);
    }
    if (boundary == Boundary::Mirrored)
    {
      this->findBoundary(cells);
    }
    for (const Corners& cell : cells)
    {
      this->addWithFaces(cell);
    }
    for (const Simplex& simplex : this->simplices_)
    {
      this->reduce(simplex);
    }
  }

  std::vector<VertexPair> pairs;

private:
  /// Twice the ranks, 1 more for images, which come right after their vertices; descending.
  using Corners = std::vector<int>;
  /// And the side, 0 on the boundary. A face comes before, for it has some of the corners.
  using Simplex = std::pair<Corners, int>;
  using Chain = std::set<Simplex>;

  static std::vector<Corners> facesOf(const Corners& corners)
  {
    std::vector<Corners> faces;
    for (std::size_t i = 0; corners.size() > 1 && i < corners.size(); ++i)
    {
      faces.push_back(corners);
      faces.back().erase(faces.back().begin() + static_cast<std::ptrdiff_t>(i));
    }
    return faces;
  }

  void addBoundary(const Corners& corners)
  {
    this->boundary_.insert(corners);
    for (const Corners& face : facesOf(corners))
    {
      this->addBoundary(face);
    }
  }

  void findBoundary(const std::vector<Corners>& cells)
  {
    std::map<Corners, int> counts;
    for (const Corners& cell : cells)
    {
      for (const Corners& face : facesOf(cell))
      {
        ++counts[face];
      }
    }
    for (const auto& [face, count] : counts)
    {
      if (count == 1)
      {
        this->addBoundary(face);
      }
    }
  }

  void addWithFaces(const Corners& corners)
  {
    this->simplices_.insert({ corners, 0 });
    if (!this->boundary_.empty() && this->boundary_.count(corners) == 0)
    {
      Corners images = corners;
      for (int& corner : images)
      {
        corner += this->boundary_.count({ corner }) > 0 ? 0 : 1;
      }
      this->simplices_.insert({ images, 1 });
    }
    for (const Corners& face : facesOf(corners))
    {
      this->addWithFaces(face);
    }
  }

  static void add(Chain& chain, const Simplex& simplex)
  {
    if (!chain.insert(simplex).second)
    {
      chain.erase(simplex);
    }
  }

  Vertex lastVertex(const Simplex& simplex) const
  {
    const int last = simplex.first.front();
    return { this->vertexOf_[static_cast<std::size_t>(last / 2)], last % 2 };
  }

  void reduce(const Simplex& simplex)
  {
    Chain chain;
    for (const Corners& face : facesOf(simplex.first))
    {
      add(chain, { face, this->boundary_.count(face) > 0 ? 0 : simplex.second });
    }
    for (auto found = this->reduced_.end();
         !chain.empty() && (found = this->reduced_.find(*chain.rbegin())) != this->reduced_.end();)
    {
      for (const Simplex& other : found->second)
      {
        add(chain, other);
      }
    }
    if (chain.empty())
    {
      return;
    }
    const Simplex first = *chain.rbegin();
    this->reduced_.emplace(first, std::move(chain));
    const Vertex birth = this->lastVertex(first);
    const Vertex death = this->lastVertex(simplex);
    if (birth != death)
    {
      this->pairs.push_back({ static_cast<int>(first.first.size()) - 1, birth, death });
    }
  }

  std::vector<Index> vertexOf_;
  std::set<Corners> boundary_;
  Chain simplices_;
  std::map<Simplex, Chain> reduced_; ///< by their last simplex
};

} // namespace SurfaceScalars::Truth
