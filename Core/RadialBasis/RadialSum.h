#pragma once

#include "FieldJet.h"
#include "RadialKernel.h"

namespace SurfaceScalars
{

/// Adds alpha phi(|offset|) and, as far as they are asked for, its derivatives: a term of
/// (11)-(13), with the errata of (12) and (13) mended.
inline void addRadialTerm(FieldJet& sum, double alpha, const RadialKernel& kernel,
  const Vector3d& offset, Derivatives derivatives)
{
  const double radius = offset.norm();
  if (derivatives == Derivatives::None)
  {
    sum.value += alpha * kernel.value(radius);
    return;
  }
  const KernelJet phi = kernel.jet(radius);
  sum.value += alpha * phi.value;
  sum.gradient += (alpha * phi.slopeOverRadius) * offset;
  if (derivatives == Derivatives::Hessian)
  {
    sum.hessian.diagonal().array() += alpha * phi.slopeOverRadius;
    if (radius > 0.0)
    {
      const Vector3d direction = offset / radius;
      sum.hessian +=
        (alpha * (phi.curvature - phi.slopeOverRadius)) * direction * direction.transpose();
    }
  }
}

/// tail[0] + tail.tail(3) . offset.
inline FieldJet linearJet(const Eigen::Vector4d& tail, const Vector3d& offset)
{
  return { tail[0] + tail.tail<3>().dot(offset), tail.tail<3>(), Eigen::Matrix3d::Zero() };
}

} // namespace SurfaceScalars
