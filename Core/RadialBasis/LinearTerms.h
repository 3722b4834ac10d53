#pragma once

#include "Basics.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/**
 * The linear polynomials that centers determine: 1 and one slope for each direction in which they
 * spread, centered and scaled. Coplanar and collinear centers determine fewer than four.
 */
class SURFACESCALARSCORE_EXPORT LinearTerms
{
public:
  LinearTerms() = default;
  explicit LinearTerms(const Points& centers);

  Eigen::Index count() const { return this->count_; } ///< 1 to 4, at most one for each center
  const Vector3d& origin() const { return this->origin_; }

  /// One row per center, one column per term.
  Eigen::MatrixXd at(const Points& centers) const;
  /// The polynomial with these coefficients as tail[0] + tail.tail(3) . (p - origin()).
  Eigen::Vector4d polynomial(const Values& coefficients) const;

private:
  Vector3d origin_ = Vector3d::Zero();
  double scale_ = 1.0;
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity(); ///< directions of spread, largest first
  Eigen::Index count_ = 1;
};

} // namespace SurfaceScalars
