#pragma once

#include "Basics.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/// phi(r) with width h, t = r / h; the numbers are those of the public interface.
enum class KernelType
{
  Gaussian = 0,            ///< exp(-t^2)
  Exponential = 1,         ///< exp(-t)
  Linear = 2,              ///< r
  Cubic = 3,               ///< t^3
  ThinPlate = 4,           ///< t^2 log t
  Multiquadric = 5,        ///< sqrt(1 + t^2)
  InverseMultiquadric = 6, ///< 1 / sqrt(1 + t^2)
  Wendland = 7,            ///< (1 - t)^4 (4 t + 1), 0 from t = 1 on
  Wu = 8,                  ///< (1 - t)^4 (4 + 16 t + 12 t^2 + 3 t^3), 0 from t = 1 on
  Harmonic = 9             ///< 1 / r: infinite at its center
};

/// As in the public interface: "ThinPlate".
SURFACESCALARSCORE_EXPORT const char* nameOf(KernelType type);

/// A kernel at one radius: what value, gradient and Hessian of phi(|x|) are made of, (11)-(13).
struct KernelJet
{
  double value;           ///< phi
  double slopeOverRadius; ///< phi' / r
  double curvature;       ///< phi''
};

/**
 * A radial basis function (point-set paper, sec. 3.2).
 *
 * At r = 0 the derivatives are their limits: phi'' for both. Exponential, Linear and ThinPlate have
 * none (a tip, or a logarithm in phi''); both are 0 there, so that a center adds nothing to the
 * gradient and Hessian at itself. Harmonic is infinite there and can only be used with centers that
 * are offset from the samples.
 *
 * sign() phi is conditionally positive definite of order(): the kernel matrix of distinct points is
 * positive definite on the vectors orthogonal to all polynomials of degree less than order().
 * Order 0 is positive definite; for Wendland and Wu in up to three dimensions, for the others in
 * any. Harmonic makes no such promise.
 */
class SURFACESCALARSCORE_EXPORT RadialKernel
{
public:
  /// @param width h, length; positive @throws InvalidInput
  RadialKernel(KernelType type, double width);

  KernelType type() const { return this->type_; }
  double width() const { return this->width_; }

  double value(double radius) const;
  /// Turns squared radii into values, many at a time.
  void apply(Eigen::Ref<Eigen::ArrayXd> squaredRadii) const;
  KernelJet jet(double radius) const;

  double sign() const; ///< 1 or -1
  int order() const;   ///< 0, 1 or 2
  /// The radius from which on phi is 0: h or infinity.
  double support() const;
  /// Whether interpolants depend on h at all: those of powers and thin plates do not.
  bool dependsOnWidth() const;

private:
  KernelType type_;
  double width_;
};

} // namespace SurfaceScalars
