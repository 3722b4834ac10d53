#pragma once

#include "Basics.h"

#include <cstddef>
#include <iterator>

namespace SurfaceScalars
{

/**
 * The edges of a mesh, or volume, glued to its mirror image along the boundary. The image of the
 * interior vertex i is n + i, where n is the number of vertices; that of a boundary vertex is the
 * vertex itself, and its n + i joins nothing.
 *
 * Edges between a vertex of the boundary and an image are named by the image only.
 *
 * @tparam Topology MeshTopology or VolumeTopology
 */
template <class Topology>
class MirroredMesh
{
public:
  explicit MirroredMesh(const Topology& mesh)
    : mesh_(&mesh)
  {
  }

  Index count() const { return 2 * this->mesh_->vertexCount(); }
  bool isImage(Index vertex) const { return vertex >= this->mesh_->vertexCount(); }
  Index original(Index vertex) const
  {
    return this->isImage(vertex) ? vertex - this->mesh_->vertexCount() : vertex;
  }

  /// Goes through a link, and shows vertices or their images.
  class Iterator
  {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = Index;
    using difference_type = std::ptrdiff_t;
    using pointer = const Index*;
    using reference = Index;

    Iterator(const Topology* images, const Index* place)
      : images_(images)
      , place_(place)
    {
    }
    Index operator*() const
    {
      const bool isSelf = this->images_ == nullptr || this->images_->isBoundary(*this->place_);
      return isSelf ? *this->place_ : *this->place_ + this->images_->vertexCount();
    }
    Iterator& operator++()
    {
      ++this->place_;
      return *this;
    }
    bool operator==(const Iterator& other) const { return this->place_ == other.place_; }
    bool operator!=(const Iterator& other) const { return this->place_ != other.place_; }

  private:
    const Topology* images_; ///< null to show the vertices themselves
    const Index* place_;
  };

  struct Range
  {
    Iterator first;
    Iterator last;

    Iterator begin() const { return this->first; }
    Iterator end() const { return this->last; }
  };

  Range neighbors(Index vertex) const
  {
    const auto link = this->mesh_->link(this->original(vertex));
    if (!this->isImage(vertex))
    {
      return { { nullptr, link.first }, { nullptr, link.last } };
    }
    const bool joinsNothing = this->mesh_->isBoundary(this->original(vertex));
    return { { this->mesh_, link.first }, { this->mesh_, joinsNothing ? link.first : link.last } };
  }

private:
  const Topology* mesh_;
};

} // namespace SurfaceScalars
