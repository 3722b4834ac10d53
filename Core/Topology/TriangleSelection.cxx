#include "TriangleSelection.h"

#include "DisjointSets.h"
#include "VertexStars.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// Takes triangles out until every vertex that lost one has a single fan.
class HoleCutter
{
public:
  HoleCutter(const Triangles& triangles, std::size_t vertexCount)
    : triangles_(triangles)
    , stars_(static_cast<Eigen::Index>(vertexCount), triangles)
    , kept_(static_cast<std::size_t>(triangles.cols()), 1)
  {
  }

  void removeStar(Index vertex)
  {
    for (const Index triangle : this->stars_.of(vertex))
    {
      this->remove(triangle);
    }
  }

  void touch(Index vertex) { this->touched_.push_back(vertex); }

  void repair()
  {
    while (!this->touched_.empty())
    {
      const Index vertex = this->touched_.back();
      this->touched_.pop_back();
      this->keepLargestFan(vertex);
    }
  }

  Triangles result() const
  {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index triangle = 0; triangle < this->triangles_.cols(); ++triangle)
    {
      if (this->isKept(triangle))
      {
        columns.push_back(triangle);
      }
    }
    return this->triangles_(Eigen::all, columns);
  }

private:
  bool isKept(Eigen::Index triangle) const
  {
    return this->kept_[static_cast<std::size_t>(triangle)] != 0;
  }

  void remove(Eigen::Index triangle)
  {
    if (this->isKept(triangle))
    {
      this->kept_[static_cast<std::size_t>(triangle)] = 0;
      const auto corners = this->triangles_.col(triangle);
      this->touched_.insert(this->touched_.end(), corners.begin(), corners.end());
    }
  }

  /// The fan of each triangle, known by one of them: two that share an edge at the vertex are in
  /// one.
  std::vector<Index> fansOf(const std::vector<Index>& star, Index vertex) const
  {
    std::vector<std::pair<Index, Index>> edges; // the other end, the triangle
    for (std::size_t i = 0; i < star.size(); ++i)
    {
      for (const Index corner : this->triangles_.col(star[i]))
      {
        if (corner != vertex)
        {
          edges.emplace_back(corner, static_cast<Index>(i));
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    DisjointSets fans(static_cast<Index>(star.size()));
    for (std::size_t i = 1; i < edges.size(); ++i)
    {
      if (edges[i].first == edges[i - 1].first)
      {
        const auto [older, younger] =
          std::minmax({ fans.find(edges[i].second), fans.find(edges[i - 1].second) });
        if (older != younger)
        {
          fans.attach(younger, older);
        }
      }
    }
    std::vector<Index> roots(star.size());
    std::iota(roots.begin(), roots.end(), Index(0));
    std::transform(roots.begin(), roots.end(), roots.begin(),
      [&](Index triangle) { return fans.find(triangle); });
    return roots;
  }

  void keepLargestFan(Index vertex)
  {
    const VertexRange all = this->stars_.of(vertex);
    std::vector<Index> star;
    std::copy_if(all.begin(), all.end(), std::back_inserter(star),
      [this](Index triangle) { return this->isKept(triangle); });
    const std::vector<Index> fans = this->fansOf(star, vertex);
    std::vector<std::size_t> sizes(star.size(), 0);
    for (const Index fan : fans)
    {
      ++sizes[fan];
    }
    const auto largest = std::max_element(sizes.begin(), sizes.end()) - sizes.begin();
    for (std::size_t i = 0; i < star.size(); ++i)
    {
      if (fans[i] != static_cast<Index>(largest))
      {
        this->remove(star[i]);
      }
    }
  }

  const Triangles& triangles_;
  VertexStars stars_;
  std::vector<char> kept_;
  std::vector<Index> touched_; ///< vertices that lost a triangle and may be left with several fans
};

} // namespace

Triangles trianglesWithout(
  const Triangles& triangles, const std::vector<char>& leftOut, const std::vector<char>& torn)
{
  HoleCutter cutter(triangles, leftOut.size());
  for (std::size_t vertex = 0; vertex < leftOut.size(); ++vertex)
  {
    if (leftOut[vertex])
    {
      cutter.removeStar(static_cast<Index>(vertex));
    }
  }
  for (std::size_t vertex = 0; vertex < torn.size(); ++vertex)
  {
    if (torn[vertex])
    {
      cutter.touch(static_cast<Index>(vertex));
    }
  }
  cutter.repair();
  return cutter.result();
}

} // namespace SurfaceScalars
