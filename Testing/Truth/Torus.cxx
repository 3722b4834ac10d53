#include "Torus.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{

AngleRange axialAngles(Torus torus)
{
  return torus == Torus::Cut ? AngleRange{ CutHalfAngle, 2.0 * Pi - CutHalfAngle }
                             : AngleRange{ 0.0, 2.0 * Pi };
}

Vector3d torusPoint(const Vector2d& angles)
{
  const double axisDistance = MajorRadius + MinorRadius * std::cos(angles.y());
  return { axisDistance * std::cos(angles.x()), axisDistance * std::sin(angles.x()),
    MinorRadius * std::sin(angles.y()) };
}

Vector3d torusNormal(const Vector2d& angles)
{
  return { std::cos(angles.y()) * std::cos(angles.x()), std::cos(angles.y()) * std::sin(angles.x()),
    std::sin(angles.y()) };
}

Eigen::Matrix<double, 3, 2> torusTangents(const Vector2d& angles)
{
  const double cu = std::cos(angles.x());
  const double su = std::sin(angles.x());
  const double cv = std::cos(angles.y());
  const double sv = std::sin(angles.y());
  const double axisDistance = MajorRadius + MinorRadius * cv;
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = Vector3d(-axisDistance * su, axisDistance * cu, 0.0);
  tangents.col(1) = MinorRadius * Vector3d(-sv * cu, -sv * su, cv);
  return tangents;
}

Vector2d torusAngles(const Vector3d& place)
{
  const double u = std::atan2(place.y(), place.x());
  const double v = std::atan2(place.z(), std::hypot(place.x(), place.y()) - MajorRadius);
  return { u < 0.0 ? u + 2.0 * Pi : u, v };
}

double torusDistance(const Vector3d& place)
{
  return std::hypot(std::hypot(place.x(), place.y()) - MajorRadius, place.z()) - MinorRadius;
}

double distanceFromCut(const Vector3d& place)
{
  const double u = torusAngles(place).x();
  const double angle = std::min(u, 2.0 * Pi - u) - CutHalfAngle;
  return angle * std::hypot(place.x(), place.y());
}

double torusDiagonal()
{
  const double width = 2.0 * (MajorRadius + MinorRadius);
  return Vector3d(width, width, 2.0 * MinorRadius).norm();
}

} // namespace SurfaceScalars::Truth
