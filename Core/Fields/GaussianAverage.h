#pragma once

#include "FieldJet.h"

namespace SurfaceScalars
{

/// Samples around a place, one per row: sums over them run along memory.
using SampleRows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/**
 * The weights theta = exp(-(r / h)^2) of samples around a place, and averages with them: (6) of the
 * point-set paper, its gradient (7) and its Hessian.
 *
 * Scaled so that the nearest sample weighs 1: averages stay the same, but far from all samples the
 * weights do not vanish together.
 */
class GaussianAverage
{
public:
  /// @param samples at least one @param width h > 0
  void weigh(const SampleRows& samples, const Vector3d& place, double width);

  const SampleRows& offsets() const { return this->offsets_; } ///< p_i - p
  const Values& weights() const { return this->weights_; }
  double weightSum() const { return this->weightSum_; }
  double slope() const
  {
    return this->slope_;
  }                            ///< 2 / h^2: the gradient of theta is slope theta (p_i - p)
  Vector3d meanOffset() const; ///< the average of p_i - p

  /// The average of values, one per sample, as a function of the place.
  FieldJet jet(const Values& values, Derivatives derivatives) const;

private:
  SampleRows offsets_;
  Values weights_;
  double weightSum_ = 0.0;
  double slope_ = 0.0;
};

} // namespace SurfaceScalars
