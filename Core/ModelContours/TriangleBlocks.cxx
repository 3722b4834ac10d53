#include "TriangleBlocks.h"

#include "MortonOrder.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t BlockSize = 8;    // triangles in the finest blocks
constexpr std::size_t Grain = 1024;     // blocks per share of a parallel loop
constexpr std::size_t FewestBlocks = 8; // of the coarsest layer

using Boxes = std::vector<Eigen::AlignedBox3d>;

Points centersOf(const Points& vertices, const Triangles& triangles, const Execution& execution)
{
  Points centers(3, triangles.cols());
  parallelFor(static_cast<std::size_t>(triangles.cols()), BlockSize * Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
      {
        const auto corners = triangles.col(i);
        centers.col(i) =
          (vertices.col(corners(0)) + vertices.col(corners(1)) + vertices.col(corners(2))) / 3.0;
      }
    });
  return centers;
}

std::vector<Ball> ballsAround(const Boxes& boxes)
{
  std::vector<Ball> balls(boxes.size());
  std::transform(boxes.begin(), boxes.end(), balls.begin(),
    [](const Eigen::AlignedBox3d& box) {
      return Ball{ box.center(), 0.5 * box.diagonal().norm() };
    });
  return balls;
}

Boxes pairs(const Boxes& boxes)
{
  Boxes result((boxes.size() + 1) / 2);
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    result[i / 2].extend(boxes[i]);
  }
  return result;
}

} // namespace

TriangleBlocks::TriangleBlocks(
  const Points& vertices, const Triangles& triangles, const Execution& execution)
  : order_(mortonOrder(
      centersOf(vertices, triangles, execution.part(0.0, 0.2)), execution.part(0.2, 0.8)))
{
  Boxes boxes((this->order_.size() + BlockSize - 1) / BlockSize);
  parallelFor(boxes.size(), Grain, execution.part(0.8, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      const std::size_t last = std::min(end * BlockSize, this->order_.size());
      for (std::size_t i = begin * BlockSize; i < last; ++i)
      {
        for (const Index corner : triangles.col(this->order_[i]))
        {
          boxes[i / BlockSize].extend(vertices.col(corner));
        }
      }
    });
  this->layers_.push_back(ballsAround(boxes));
  while (boxes.size() > FewestBlocks)
  {
    boxes = pairs(boxes);
    this->layers_.push_back(ballsAround(boxes));
  }
}

std::pair<std::size_t, std::size_t> TriangleBlocks::parts(
  std::size_t layer, std::size_t block) const
{
  const std::size_t size = layer > 0 ? 2 : BlockSize;
  const std::size_t count = layer > 0 ? this->layers_[layer - 1].size() : this->order_.size();
  return { size * block, std::min(size * (block + 1), count) };
}

} // namespace SurfaceScalars
