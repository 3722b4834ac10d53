#pragma once

#include "Basics.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/// Samples around a place with their weights; points with weight 0 do not count.
struct WeightedSamples
{
  Points points;
  Values values;
  Values weights;
};

/**
 * Surface and function around a place as polynomials over the tangent plane: the parameterised
 * moving least-squares fit (point-set paper, (4) and (5)), made for the height of the surface and
 * for f with the same matrix.
 *
 * The frame is centered at the place; its normal is the eigenvector of the smallest eigenvalue of
 * the weighted covariance. Heights and coordinates (u, v) are in length units along the unit axes
 * of the frame; the normal's sign is arbitrary.
 */
class SURFACESCALARSCORE_EXPORT LocalFit
{
public:
  static constexpr int MaximumDegree = 4;
  static constexpr int MaximumTerms = (MaximumDegree + 1) * (MaximumDegree + 2) / 2;

  /// Unknowns of a polynomial of this degree in two variables.
  static constexpr int termCount(int degree) { return (degree + 1) * (degree + 2) / 2; }

  /// Value and gradient of one of the polynomials at a place of the tangent plane.
  struct Slope
  {
    double value = 0.0;
    Vector2d gradient;
  };
  /// And its Hessian.
  struct Jet : Slope
  {
    Eigen::Matrix2d hessian;
  };

  /**
   * @param radius length that coordinates are scaled by inside: that of the neighborhood
   * @param degree 1 to 4
   * @returns whether the samples determine polynomials of this degree: false where they lie
   * (nearly) on a line or are too few
   */
  bool compute(const Vector3d& center, const WeightedSamples& samples, double radius, int degree);

  const Vector3d& center() const { return this->center_; }
  int degree() const { return this->degree_; }
  double scale() const { return this->scale_; } ///< the radius given to compute()
  const Eigen::Matrix3d& frame() const
  {
    return this->frame_;
  } ///< columns: u axis, v axis, normal axis

  Jet height(const Vector2d& uv) const { return this->jet(0, uv); }
  Jet value(const Vector2d& uv) const { return this->jet(1, uv); }
  Slope heightSlope(const Vector2d& uv) const { return this->slope(0, uv); }
  Slope valueSlope(const Vector2d& uv) const { return this->slope(1, uv); }
  Slope heightAtCenter() const { return this->slopeAtCenter(0); }
  Slope valueAtCenter() const { return this->slopeAtCenter(1); }

  Vector3d lift(const Vector2d& uv) const; ///< the point of the surface over (u, v)
  Vector2d flatten(
    const Vector3d& p) const; ///< (u, v) of the orthogonal projection onto the tangent plane
  Vector3d normal(const Vector2d& uv) const; ///< of the surface, unit
  Vector3d gradient(
    const Vector2d& uv) const; ///< of f on the surface: tangential, f's unit per length
  /// The same of any function, from its derivatives along u and v and the slope of the height
  /// there.
  Vector3d tangentialGradient(const Vector2d& derivatives, const Vector2d& slope) const;

  /// Root mean square of the weighted residuals of f; rounding hides what is below 1e-8 of f's
  /// changes among the samples.
  double valueMisfit() const { return this->valueMisfit_; }

  /// Root mean square of the weighted residuals, corrected for the number of unknowns.
  double heightDeviation(const WeightedSamples& samples) const
  {
    return this->deviation(0, samples);
  }
  double valueDeviation(const WeightedSamples& samples) const
  {
    return this->deviation(1, samples);
  }

private:
  Slope slope(int which, const Vector2d& uv) const;
  Slope slopeAtCenter(int which) const
  {
    const auto terms = this->coefficients_.col(which);
    return { terms[0], Vector2d(terms[1], terms[2]) / this->scale_ };
  }
  Jet jet(int which, const Vector2d& uv) const;
  double deviation(int which, const WeightedSamples& samples) const;
  void collect(const WeightedSamples& samples);
  void findFrame();
  template <int Degree>
  bool solve();

  Vector3d center_ = Vector3d::Zero();
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  double scale_ = 1.0;
  int degree_ = 0;
  Eigen::Matrix<double, MaximumTerms, 2> coefficients_; ///< of height and f in (u, v) / scale
  double valueMisfit_ = 0.0;

  // The samples with a weight, side by side for vector instructions and filled up with others that
  // weigh nothing; kept to save allocations.
  Eigen::Index collected_ = 0;
  Eigen::ArrayX3d offsets_; ///< from the center
  Eigen::ArrayXd weights_;
  Eigen::ArrayXd values_; ///< less valueOrigin_
  double valueOrigin_ = 0.0;
};

} // namespace SurfaceScalars
