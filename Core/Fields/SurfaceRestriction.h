#pragma once

#include "CriticalPoint.h"
#include "FieldJet.h"
#include "LocalFit.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/**
 * g(s, t) = u(r(s, t)): a function u of space restricted to the surface r(s, t), the graph of a
 * height z over a tangent plane with unit normal e. Its derivatives are (design paper, (5))
 *
 *   grad g = [r_s r_t]^T grad u,  H_g = [r_s r_t]^T H_u [r_s r_t] + <grad u, e> H_z:
 *
 * the second term, as r_st = z_st e, is where the curvature of the surface comes in. Where grad u
 * is parallel to the normal n of the surface, g is critical and the term is <grad u, n> times the
 * second fundamental form. (The paper's system <grad u, n> = 0 states the opposite: critical is
 * grad u - <grad u, n> n = 0.)
 *
 * @param u value, gradient and Hessian at surface.lift(st)
 */
SURFACESCALARSCORE_EXPORT LocalFit::Jet restrictedTo(
  const LocalFit& surface, const Vector2d& st, const FieldJet& u);

/// Minimum, Saddle or Maximum by the signs of the eigenvalues of a Hessian; Uncertain unless these
/// can be told from 0.
SURFACESCALARSCORE_EXPORT CriticalType typeOf(const Eigen::Matrix2d& hessian);

} // namespace SurfaceScalars
