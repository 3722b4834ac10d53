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
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << this->valueGradient.transpose(), this->distanceGradient.transpose();
  const Eigen::Matrix2d gram = jacobian * jacobian.transpose();
  const bool flat = !(std::sqrt(gram(0, 0)) * this->reach > FlatFraction * std::abs(this->value));
  if (flat || !(gram.determinant() > 1e-14 * gram(0, 0) * gram(1, 1)))
  {
    return Vector3d::Constant(std::numeric_limits<double>::infinity());
  }
  return jacobian.transpose() * (gram.inverse() * Vector2d(level - this->value, -this->distance));
}

} // namespace SurfaceScalars
