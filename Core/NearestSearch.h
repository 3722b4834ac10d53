#pragma once

#include "PointCloud.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The nearest points of many places that lie close to each other: one search of the tree gathers
 * the points around them, and each place then chooses among these few.
 */
class NearestSearch
{
public:
  struct Found
  {
    double squaredDistance;
    Index index;
  };

  /// @param count how many to find, at most as many as there are points
  NearestSearch(const PointCloud& cloud, std::size_t count);

  /// How far the nearest points of the next place are expected to be; 0 before the first.
  double reach() const { return this->reach_; }

  /// Gathers what places up to `extent` from `center` need.
  void gather(const Vector3d& center, double extent);
  /// The `count` nearest points, nearest first, and others after them; valid until the next call.
  /// If what is gathered is not enough for them the tree is searched.
  const std::vector<Found>& nearest(const Vector3d& place);

  /// The same for a place on the way along a curve: gathers by itself, for places to come.
  void follow(const Vector3d& place, Neighborhood& result);

private:
  double known(const Vector3d& place) const;
  bool choose(const Vector3d& place, double reach);
  void sortNear(std::size_t count, double limit);
  void searchTree(const Vector3d& place);

  const PointCloud& cloud_;
  std::size_t count_;
  double meanDistance_ = 0.0; ///< of the last of the nearest points
  double reach_ = 0.0;

  Vector3d center_ = Vector3d::Zero();
  double radius_ = 0.0; ///< around the center, within which all points are candidates
  Vector3d lastPlace_ = Vector3d::Zero(); ///< followed to
  std::vector<Index> candidates_;
  Eigen::ArrayX3d coordinates_;
  Eigen::ArrayXd squaredDistances_; ///< of the candidates from the place
  std::vector<std::size_t> near_;   ///< those within reach of it

  std::vector<Found> sorted_;       ///< these, first into classes of squared distance
  std::vector<std::size_t> starts_; ///< of the classes
  Neighborhood found_;
};

} // namespace SurfaceScalars
