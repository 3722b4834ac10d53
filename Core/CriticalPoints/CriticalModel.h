#pragma once

#include "CriticalScale.h"
#include "FieldApproximation.h"
#include "FitCovariance.h"

#include <memory>
#include <optional>

namespace SurfaceScalars
{

/**
 * f~ on the fitted surface around a place, over its tangent plane: the polynomial of f, or an F in
 * space restricted to the surface, restrictedTo() it. (Of averages, whose second derivatives are of
 * no use, the Hessian is that of the polynomial of f.)
 *
 * Places are relative to the cloud of the scale, which must outlive this. Not for several threads
 * at once.
 */
class CriticalModel
{
public:
  explicit CriticalModel(const CriticalScale& scale);

  /// As FieldApproximation::expect() and center().
  Eigen::Index expect(const PointsRef& places) { return this->polynomials_.expect(places); }
  bool center(const Vector3d& place);

  // After center() returned true:
  const LocalFit& fit() const { return this->polynomials_.fit(); } ///< of the surface
  double radius() const { return this->polynomials_.radius(); }
  const std::vector<Index>& samples() const { return this->polynomials_.samples(); }
  LocalFit::Jet jet(const Vector2d& uv) const;
  /// Takes the F in space, if that is what f~ is, of another place than the center.
  bool moveField(const Vector2d& uv);
  /// |cos| of the angle between the gradient of F in space and the normal; 1 where F is critical.
  double normalCosine(const Vector2d& uv) const;
  /// How uncertain f~ is; none where the samples do not tell.
  const FitCovariance* covariance();
  /// The mean square error of the gradient at a place: its covariance, and the square of its bias
  /// so far as a polynomial of one degree more shows one beyond its own noise.
  Eigen::Matrix2d gradientError(const Vector2d& uv);

  /// Whether samples lie all around the center, so that the fit does not extrapolate: none of them
  /// far, and the edge of the surface farther than `margin`.
  bool isSupported(double margin) const;
  /// Whether f is constant on a large part of the neighborhood.
  bool isOnPlateau() const;
  double samplingStep() const; ///< at the center, of the cloud

  /// Where the gradient of f~ vanishes, closer to the center than a fraction of the radius.
  std::optional<Vector2d> criticalPoint(double within) const;

private:
  const CriticalScale& scale_;
  PolynomialNeighborhood polynomials_;
  std::unique_ptr<FieldApproximation> field_; ///< F in space, or none
  FitCovariance covariance_;
  LocalFit finerFit_; ///< of one degree more
  FitCovariance finerCovariance_;
  enum class Known
  {
    No,
    Yes,
    Never
  };
  Known covarianceKnown_ = Known::No;
  Known finerKnown_ = Known::No;
};

} // namespace SurfaceScalars
