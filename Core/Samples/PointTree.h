#pragma once

#include "Basics.h"
#include "Execution.h"
#include "PointCloud.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// k-d trees over points, of which there may be none, that stay where they are; the only place that
/// knows nanoflann.
class PointTree
{
public:
  explicit PointTree(const Points& points, const Execution& execution = {});
  ~PointTree();

  /// The `count` nearest points, nearest first; count <= number of points.
  void nearest(const Vector3d& place, std::size_t count, Neighborhood& result) const;
  /// The points closer than `radius`, nearest first.
  void within(const Vector3d& place, double radius, Neighborhood& result) const;
  /// Appends the points closer than `radius`, in no order. @returns false if there are more than
  /// `most`
  bool gather(
    const Vector3d& place, double radius, std::size_t most, std::vector<Index>& result) const;

private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

} // namespace SurfaceScalars
