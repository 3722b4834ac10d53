#pragma once

#include "Execution.h"
#include "LevelBound.h"
#include "Triangles.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace SurfaceScalars
{

/**
 * A tree over the triangles of a mesh along a Morton curve: layers of blocks with a ball around
 * each. Two blocks of a layer are one of the next. Time O(n log n); memory 12 bytes per triangle.
 */
class TriangleBlocks
{
public:
  TriangleBlocks(const Points& vertices, const Triangles& triangles, const Execution& execution);

  /// The finest is 0, the last has a few blocks.
  std::size_t layerCount() const { return this->layers_.size(); }
  const std::vector<Ball>& layer(std::size_t i) const { return this->layers_[i]; }
  /// The half-open range of blocks of the layer below, or of triangles, that a block consists of.
  std::pair<std::size_t, std::size_t> parts(std::size_t layer, std::size_t block) const;
  /// The triangle at a place in their order.
  Index triangle(std::size_t place) const { return this->order_[place]; }

private:
  std::vector<Index> order_;
  std::vector<std::vector<Ball>> layers_;
};

} // namespace SurfaceScalars
