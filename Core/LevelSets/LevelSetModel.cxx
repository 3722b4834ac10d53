#include "LevelSetModel.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace SurfaceScalars
{

namespace
{

// What varies less over a neighborhood, beside its values, is a plateau with rounding errors.
constexpr double FlatFraction = 1e-10;

} // namespace

LevelSetModel::~LevelSetModel() = default;

Vector3d LevelSetModel::tangent() const
{
  const Vector3d along = this->valueGradient.cross(this->distanceGradient);
  const double length = along.norm();
  return length > 0.0 ? Vector3d(along / length) : Vector3d::Zero();
}

Vector3d LevelSetModel::firstOrderStep(double level) const
{
  const double slope = this->valueGradient.norm();
  const std::optional<Vector3d> step = slope * this->reach > FlatFraction * std::abs(this->value)
    ? leastNormStep(
        this->valueGradient, this->distanceGradient, Vector2d(level - this->value, -this->distance))
    : std::nullopt;
  return step.value_or(Vector3d::Constant(std::numeric_limits<double>::infinity()));
}

std::optional<Vector3d> LevelSetModel::leastNormStep(
  const Vector3d& valueGradient, const Vector3d& distanceGradient, const Vector2d& missing)
{
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << valueGradient.transpose(), distanceGradient.transpose();
  const Eigen::Matrix2d gram = jacobian * jacobian.transpose();
  if (!(gram.determinant() > 1e-14 * gram(0, 0) * gram(1, 1)))
  {
    return {};
  }
  return jacobian.transpose() * (gram.inverse() * missing);
}

} // namespace SurfaceScalars
