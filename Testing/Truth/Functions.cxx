#include "Functions.h"

#include <cmath>

namespace SurfaceScalars::Truth
{

SpaceFunction tiltedHeight()
{
  const Vector3d direction = Vector3d(0.5, 0.2, 0.84).normalized();
  return { "tilted height", [=](const Vector3d& p) { return direction.dot(p); },
    [=](const Vector3d&) { return direction; } };
}

SpaceFunction saddleWithLogarithm()
{
  const auto value = [](const Vector3d& p)
  { return p.x() * p.x() - p.y() * p.y() + std::log(1.0 + p.norm()); };
  const auto gradient = [](const Vector3d& p) -> Vector3d
  {
    const double radius = p.norm();
    return Vector3d(2.0 * p.x(), -2.0 * p.y(), 0.0) + p / (radius * (1.0 + radius));
  };
  return { "x^2 - y^2 + log(1 + |p|)", value, gradient };
}

Values valuesOf(const SpaceFunction& function, const PointsRef& points)
{
  return valuesOf(function.value, points);
}

Values valuesOf(const std::function<double(const Vector3d&)>& function, const PointsRef& points)
{
  Values values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    values[i] = function(points.col(i));
  }
  return values;
}

} // namespace SurfaceScalars::Truth
