#pragma once

#include "PointCloud.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * A run of searches at places that lie close to each other: samples are fetched for the
 * surroundings of a place, and the next ones choose among them as long as they can.
 *
 * What is found depends on the place only, and comes in the order of the cloud, so that sums over
 * it have the same rounding errors wherever they are made. Not for several threads at once.
 */
class SampleSearch
{
public:
  explicit SampleSearch(const PointCloud& cloud);

  /// Finds the `count` nearest samples, at most all; of equally far ones the first in the cloud.
  void nearest(const Vector3d& place, int count);
  /// Finds all samples closer than `radius`; there may be none.
  void within(const Vector3d& place, double radius);

  // What was found last:
  const std::vector<Index>& indices() const { return this->indices_; }
  const std::vector<double>& squaredDistances() const { return this->squaredDistances_; }
  /// Distance of the last sample that nearest() found.
  double reach() const { return this->reach_; }

private:
  bool knows(const Vector3d& place, double radius) const;
  void measure(const Vector3d& place);
  double squaredReach(std::size_t count);
  void fetchNearest(const Vector3d& place, std::size_t count);
  void keepFetched(const Vector3d& place, double radius);
  void choose(double squaredRadius, std::size_t atRadius);

  const PointCloud& cloud_;
  std::vector<Index> indices_;
  std::vector<double> squaredDistances_;
  double reach_ = 0.0;

  std::vector<Index> fetched_; ///< all samples closer to fetchPlace_ than fetchRadius_
  Eigen::Matrix<double, Eigen::Dynamic, 3> fetchedPoints_;
  Vector3d fetchPlace_ = Vector3d::Zero();
  double fetchRadius_ = 0.0;
  Values squared_; ///< distances of these from the present place
  std::vector<double> scratch_;
  Neighborhood neighborhood_;
};

} // namespace SurfaceScalars
