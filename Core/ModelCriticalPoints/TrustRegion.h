#pragma once

#include "CriticalPoint.h"
#include "LocalFit.h"

#include <functional>

namespace SurfaceScalars
{

/// A function of two variables at a place.
struct PlanarPoint
{
  Vector2d st;
  LocalFit::Jet g;
  double residual = 0.0; ///< a norm of its gradient
};

/// Fills in what belongs to a place. @returns false where the function is not defined
using PlanarFunction = std::function<bool(const Vector2d& st, PlanarPoint& point)>;

/**
 * A trust-region Newton method for critical points of a function of two variables.
 *
 * In the axes of the Hessian H_g, with gradient g_i and eigenvalues l_i, a step is
 * -sign_i g_i / (|l_i| + mu), mu >= 0 such that it is not longer than the trust region. Near a
 * critical point of the type searched for that is Newton's own. For a minimum the signs are +1: it
 * goes down everywhere; for a maximum -1; for a saddle down along the axis of the larger eigenvalue
 * and up along the other. For Uncertain, any type, they are those of the eigenvalues, and each step
 * makes |grad g| smaller. The region shrinks where the gradient is not what the Hessian predicts.
 */
class TrustRegion
{
public:
  /// @param length of the longest first step
  TrustRegion(CriticalType type, double length)
    : type_(type)
    , length_(length)
  {
  }

  /// @param longest a step may be @returns false, and leaves the point, if no step leads on
  bool step(PlanarPoint& point, double longest, const PlanarFunction& evaluate);

private:
  bool isBetter(const PlanarPoint& before, const PlanarPoint& after, const Vector2d& step);

  CriticalType type_;
  double length_; ///< of the longest step
};

} // namespace SurfaceScalars
