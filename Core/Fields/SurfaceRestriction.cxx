#include "SurfaceRestriction.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double SmallestRatio = 1e-8; // of the eigenvalues: less is degenerate

} // namespace

LocalFit::Jet restrictedTo(const LocalFit& surface, const Vector2d& st, const FieldJet& u)
{
  const LocalFit::Jet height = surface.height(st);
  const Eigen::Matrix<double, 3, 2> tangents =
    surface.frame().leftCols<2>() + surface.frame().col(2) * height.gradient.transpose();
  LocalFit::Jet g;
  g.value = u.value;
  g.gradient = tangents.transpose() * u.gradient;
  g.hessian = tangents.transpose() * u.hessian * tangents +
    u.gradient.dot(surface.frame().col(2)) * height.hessian;
  return g;
}

CriticalType typeOf(const Eigen::Matrix2d& hessian)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(hessian, Eigen::EigenvaluesOnly);
  const double low = axes.eigenvalues()[0];
  const double high = axes.eigenvalues()[1];
  const double least = SmallestRatio * std::max(std::abs(low), std::abs(high));
  if (!(std::min(std::abs(low), std::abs(high)) > least))
  {
    return CriticalType::Uncertain;
  }
  return low > 0.0 ? CriticalType::Minimum
    : high < 0.0   ? CriticalType::Maximum
                   : CriticalType::Saddle;
}

} // namespace SurfaceScalars
