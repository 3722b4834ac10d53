#pragma once

#include "LocalFit.h"

namespace SurfaceScalars
{

/**
 * How uncertain the polynomial of f in a local fit is. The coefficients are linear in the samples'
 * values; if these carry independent errors of equal variance s^2, the covariance of the
 * coefficients is
 *
 *   s^2 N^-1 Q N^-1,  N = sum w b b^T,  Q = sum w^2 b b^T,
 *
 * b the monomials at a sample and w its weight (not s^2 N^-1: the weights are no variances). s^2 is
 * taken from the weighted squares of the residuals, whose mean is s^2 (sum w - tr N^-1 Q), so that
 * what the polynomial cannot represent counts as error too.
 */
class SURFACESCALARSCORE_EXPORT FitCovariance
{
public:
  /// @returns false if the samples do not determine the polynomial, or leave no residuals
  bool compute(const LocalFit& fit, const WeightedSamples& samples);

  double deviation() const { return this->deviation_; } ///< s
  double ofValue(const Vector2d& uv) const;             ///< variance
  Eigen::Matrix2d ofGradient(const Vector2d& uv) const;
  Eigen::Matrix3d ofHessianAtCenter() const; ///< of its elements (0, 0), (0, 1), (1, 1)

private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, LocalFit::MaximumTerms,
    LocalFit::MaximumTerms>;

  int degree_ = 0;
  double scale_ = 1.0;
  double deviation_ = 0.0;
  Matrix covariance_; ///< of the coefficients in (u, v) / scale
};

} // namespace SurfaceScalars
