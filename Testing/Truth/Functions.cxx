#include "Functions.h"

#include "Torus.h"

#include <cmath>
#include <complex>

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

SpaceFunction cosinesOfAngles()
{
  const auto value = [](const Vector3d& p)
  {
    const Vector2d angles = torusAngles(p);
    return std::cos(3.0 * angles.x()) * std::cos(2.0 * angles.y());
  };
  const auto gradient = [](const Vector3d& p) -> Vector3d
  {
    const Vector2d angles = torusAngles(p);
    const double u = angles.x();
    const double v = angles.y();
    const Vector3d alongAxis = Vector3d(-std::sin(u), std::cos(u), 0.0) / p.head<2>().norm();
    const Vector3d alongTube =
      Vector3d(-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v)) /
      (torusDistance(p) + MinorRadius);
    return -3.0 * std::sin(3.0 * u) * std::cos(2.0 * v) * alongAxis -
      2.0 * std::cos(3.0 * u) * std::sin(2.0 * v) * alongTube;
  };
  return { "cos 3u cos 2v", value, gradient };
}

SpaceFunction planarSaddle(int multiplicity)
{
  const auto power = [](const Vector3d& p, int exponent)
  { return std::pow(std::complex<double>(p.x(), p.y()), exponent); };
  const auto value = [=](const Vector3d& p) { return power(p, multiplicity + 1).real(); };
  const auto gradient = [=](const Vector3d& p) -> Vector3d
  {
    const std::complex<double> derivative =
      static_cast<double>(multiplicity + 1) * power(p, multiplicity);
    return { derivative.real(), -derivative.imag(), 0.0 };
  };
  return { "Re z^" + std::to_string(multiplicity + 1), value, gradient };
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
