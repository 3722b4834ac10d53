#pragma once

#include <Eigen/Core>

#include <cstdint>

/// Mathematics of scalar functions on sampled surfaces; knows no VTK.
namespace SurfaceScalars
{

using Index = std::uint32_t;

using Vector2d = Eigen::Vector2d;
using Vector3d = Eigen::Vector3d;

using Points = Eigen::Matrix3Xd; ///< one point per column, length units
using PointsRef = Eigen::Ref<const Points>;

using Values = Eigen::VectorXd; ///< one number per point
using ValuesRef = Eigen::Ref<const Values>;

constexpr double Pi = 3.14159265358979323846;

} // namespace SurfaceScalars
