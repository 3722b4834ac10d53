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

private:
  friend class NearestSearch;
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

/// A run of nearest searches at places that lie close to each other: each starts with a bound from
/// the one before.
class NearestSearch
{
public:
  NearestSearch(const PointTree& tree, std::size_t count);

  /// @returns `count` points, nearest first, valid until the next call
  const Index* around(const Vector3d& place);

private:
  const PointTree& tree_;
  std::vector<Index> indices_;
  std::vector<double> squaredDistances_;
  Vector3d last_ = Vector3d::Zero();
};

} // namespace SurfaceScalars
