#pragma once

#include "ValueRanks.h"
#include "VolumeExamples.h"

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

/// The pairs of all dimensions by reduction of the boundary matrix over Z2, each simplex with its
/// highest vertex, on a volume glued to its mirror image along the boundary. The image of a simplex
/// that is not on the boundary is another one even if all its vertices are.
class ReducedPairs
{
public:
  ReducedPairs(const Volume& volume, const Values& values)
    : ranks_(ranksOf(values))
    , vertexOf_(this->ranks_.size())
  {
    for (std::size_t i = 0; i < this->ranks_.size(); ++i)
    {
      this->vertexOf_[static_cast<std::size_t>(this->ranks_[i])] = static_cast<Index>(i);
    }
    this->findBoundary(volume.tetrahedra);
    for (Eigen::Index cell = 0; cell < volume.tetrahedra.cols(); ++cell)
    {
      Corners corners;
      for (const Index vertex : volume.tetrahedra.col(cell))
      {
        corners.push_back(this->ranks_[vertex]);
      }
      std::sort(corners.rbegin(), corners.rend());
      this->addWithFaces(corners);
    }
    for (const Simplex& simplex : this->simplices_)
    {
      this->reduce(simplex);
    }
  }

  std::vector<VertexPair> pairs;

private:
  using Corners = std::vector<int>; ///< ranks, descending

  struct Simplex
  {
    Corners corners;
    int side; ///< 0 on the boundary

    /// By the ranks on the glued volume, where an image comes right after its vertex. A face comes
    /// before, for it has some of the corners.
    std::pair<Corners, int> key(const ReducedPairs& of) const
    {
      Corners ranks;
      for (const int corner : this->corners)
      {
        ranks.push_back(2 * corner + of.vertex(*this, corner).second);
      }
      return { ranks, this->side };
    }
  };

  struct Before
  {
    const ReducedPairs* of;
    bool operator()(const Simplex& a, const Simplex& b) const
    {
      return a.key(*this->of) < b.key(*this->of);
    }
  };

  using Chain = std::set<Simplex, Before>;

  Vertex vertex(const Simplex& simplex, int rank) const
  {
    const bool isBoundary = this->boundary_.count({ rank }) > 0;
    return { this->vertexOf_[static_cast<std::size_t>(rank)], isBoundary ? 0 : simplex.side };
  }

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

  void findBoundary(const Tetrahedra& tetrahedra)
  {
    std::map<Corners, int> counts;
    for (Eigen::Index cell = 0; cell < tetrahedra.cols(); ++cell)
    {
      for (int corner = 0; corner < 4; ++corner)
      {
        Corners face;
        for (const Index vertex : faceOf(tetrahedra, cell, corner))
        {
          face.push_back(this->ranks_[vertex]);
        }
        std::sort(face.rbegin(), face.rend());
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
      this->simplices_.insert({ corners, 1 });
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

  void reduce(const Simplex& simplex)
  {
    Chain chain(Before{ this });
    for (const Corners& face : facesOf(simplex.corners))
    {
      add(chain, { face, this->boundary_.count(face) > 0 ? 0 : simplex.side });
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
    const Vertex birth = this->vertex(first, first.corners[0]);
    const Vertex death = this->vertex(simplex, simplex.corners[0]);
    if (birth != death)
    {
      this->pairs.push_back({ static_cast<int>(first.corners.size()) - 1, birth, death });
    }
  }

  std::vector<int> ranks_;
  std::vector<Index> vertexOf_;
  std::set<Corners> boundary_;
  Chain simplices_{ Before{ this } };
  std::map<Simplex, Chain, Before> reduced_{ Before{ this } }; ///< by their last simplex
};

} // namespace SurfaceScalars::Truth
