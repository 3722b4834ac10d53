#pragma once

#include "PointCloud.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The points around many places that lie close to each other: one search of the tree gathers the
 * points that several places need, and each place then chooses among these few.
 *
 * What is found, and in which order, depends on the place only, so that sums over it have the same
 * rounding errors wherever they are made. Not for several threads at once.
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
  /// @param radius length; > 0 replaces count: all points that are closer are found
  NearestSearch(const PointCloud& cloud, std::size_t count, double radius = 0.0);

  /// The places that come next, at least one, in an order in which neighbors follow each other.
  /// Gathers what the first of them need. @returns how many these are
  Eigen::Index expect(const PointsRef& places);

  /// The nearest points, nearest first and of equally far ones the first in the cloud; or those
  /// within the radius, in the order of the cloud. Valid until the next call. A place that was not
  /// expected is taken for one on the way along a curve.
  const std::vector<Found>& find(const Vector3d& place);
  /// Of what was found last: the given one, or the distance to the last point.
  double radius() const;

private:
  void gather(const Vector3d& center, double extent);
  void gatherAhead(const Vector3d& place);
  void measure(const Vector3d& place);
  void findWithin();
  bool choose(double reach);
  void sortNear(std::size_t near, double limit);
  void searchTree(const Vector3d& place);
  void learnReach();

  const PointCloud& cloud_;
  std::size_t count_;
  double givenRadius_;
  double meanDistance_ = 0.0; ///< of the last of the nearest points
  double reach_;              ///< how far the points of the next place are expected to be

  Vector3d center_ = Vector3d::Zero();
  double extent_ = -1.0; ///< of the places around the center that are expected
  double radius_ = 0.0;  ///< around the center, within which all points are candidates
  Vector3d lastPlace_ = Vector3d::Zero();
  std::vector<Index> candidates_;
  Eigen::ArrayX3d coordinates_;
  Eigen::ArrayXd squaredDistances_; ///< of the candidates from the place
  std::vector<std::size_t> near_;   ///< those within reach of it

  std::vector<Found> found_;        ///< these, first into classes of squared distance
  std::vector<std::size_t> starts_; ///< of the classes
  Neighborhood inTree_;
};

} // namespace SurfaceScalars
