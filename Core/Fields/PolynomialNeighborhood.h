#pragma once

#include "LocalFit.h"
#include "NearestSearch.h"

#include <vector>

namespace SurfaceScalars
{

/// Which samples a model uses.
struct FitSize
{
  int count;     ///< k
  double radius; ///< > 0 replaces count, but takes that many at least
};

/**
 * The parameterized moving least-squares fit (4)(5) to the samples around a place, weighted by
 * (1 - r^2 / radius^2)^2 up to the distance of the k-th sample. In a void the neighborhood is
 * wider, so that samples from across it take part; where the samples do not determine the
 * polynomials, as on a few parallel lines, it takes more of them and then a lower degree.
 *
 * Samples are gathered for places close to each other at once. Not for several threads at once.
 */
class PolynomialNeighborhood
{
public:
  /// @param values f at the points of the cloud, or empty: then f is 0. Both must outlive this.
  PolynomialNeighborhood(
    const PointCloud& cloud, const Values& values, const FitSize& size, int degree);

  /// As FieldApproximation::expect().
  Eigen::Index expect(const PointsRef& places) { return this->search_.expect(places); }

  /// @returns false where the samples do not even determine a plane
  bool center(const Vector3d& place);

  // After center() returned true:
  const LocalFit& fit() const { return this->fit_; }
  double radius() const { return this->radius_; } ///< where the weights become 0
  /// Of f from its polynomial, root mean square.
  double valueDeviation() const { return this->fit_.valueDeviation(this->weighted_); }
  /// Those within the radius, and a few more.
  const std::vector<Index>& samples() const { return this->near_.indices; }
  const WeightedSamples& weightedSamples() const { return this->weighted_; }

private:
  bool fitAround(const Vector3d& place, int count, int degree);
  void gather(const Vector3d& place, int count);
  void gatherNearest(const Vector3d& place, int count);
  void copySamples();
  double radiusAround(const Vector3d& place, int count);

  const PointCloud& cloud_;
  const Values& values_;
  FitSize size_;
  int degree_;
  LocalFit fit_;
  double radius_ = 0.0;
  bool centered_ = false;

  NearestSearch search_;
  Neighborhood near_; ///< the samples gathered
  WeightedSamples weighted_;
  std::vector<double> scratch_;
  Vector3d gatherPlace_ = Vector3d::Zero();
  int gatheredCount_ = 0;     ///< k at the last gathering
  double gatherMargin_ = 0.0; ///< how far from there the samples gathered are still all that count
  double gatherRadius_ = 0.0; ///< all samples closer to there are gathered
};

} // namespace SurfaceScalars
