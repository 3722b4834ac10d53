#pragma once

#include "MeshTopology.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace SurfaceScalars
{

/// The triangles around the vertices of a mesh, which need not be a manifold.
class VertexStars
{
public:
  VertexStars(Eigen::Index vertexCount, const Triangles& triangles)
    : starts_(static_cast<std::size_t>(vertexCount) + 1)
    , triangles_(static_cast<std::size_t>(triangles.size()))
  {
    for (Eigen::Index i = 0; i < triangles.size(); ++i)
    {
      ++this->starts_[triangles.data()[i] + 1];
    }
    std::partial_sum(this->starts_.begin(), this->starts_.end(), this->starts_.begin());
    std::vector<std::size_t> next(this->starts_.begin(), this->starts_.end() - 1);
    for (Eigen::Index i = 0; i < triangles.size(); ++i)
    {
      this->triangles_[next[triangles.data()[i]]++] = static_cast<Index>(i / 3);
    }
  }

  /// Ascending.
  VertexRange of(Index vertex) const
  {
    const Index* all = this->triangles_.data();
    return { all + this->starts_[vertex], all + this->starts_[vertex + 1] };
  }

private:
  std::vector<std::size_t> starts_;
  std::vector<Index> triangles_;
};

} // namespace SurfaceScalars
