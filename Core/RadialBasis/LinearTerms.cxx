#include "LinearTerms.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// Where the centers spread less than this, relative to their largest spread, a slope would be made
// of noise. Samples of a surface of curvature c within a radius s spread by about s c / 4: ten
// times this and more wherever the curvature shows at all, s c > 0.04. On flatter patches the slope
// along the normal moves values by O(s^2 c) only, which the kernels make up for.
constexpr double SmallestSpread = 1e-3;

} // namespace

LinearTerms::LinearTerms(const Points& centers)
  : origin_(centers.rowwise().mean())
{
  const Points offsets = centers.colwise() - this->origin_;
  const double radius = std::sqrt(offsets.colwise().squaredNorm().maxCoeff());
  if (!(radius > 0.0))
  {
    return;
  }
  this->scale_ = radius;
  const Points scaled = offsets / radius;
  // Axes along the spread make the terms orthogonal.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scaled * scaled.transpose());
  this->frame_ = axes.eigenvectors().rowwise().reverse();
  const Vector3d spread = axes.eigenvalues().reverse().cwiseMax(0.0).cwiseSqrt();
  this->count_ = std::min<Eigen::Index>(
    1 + (spread.array() > SmallestSpread * spread[0]).count(), centers.cols());
}

Eigen::MatrixXd LinearTerms::at(const Points& centers) const
{
  Eigen::MatrixXd terms(centers.cols(), this->count_);
  terms.col(0).setOnes();
  terms.rightCols(this->count_ - 1) = (centers.colwise() - this->origin_).transpose() *
    this->frame_.leftCols(this->count_ - 1) / this->scale_;
  return terms;
}

Eigen::Vector4d LinearTerms::polynomial(const Values& coefficients) const
{
  Eigen::Vector4d result;
  result[0] = coefficients[0];
  result.tail<3>() =
    this->frame_.leftCols(this->count_ - 1) * coefficients.tail(this->count_ - 1) / this->scale_;
  return result;
}

} // namespace SurfaceScalars
