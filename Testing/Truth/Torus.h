#pragma once

#include "Basics.h"

/// What is known exactly: surfaces, functions and their level sets, for the tests to compare with.
namespace SurfaceScalars::Truth
{

/// The whole torus, or the torus without the piece |u| < CutHalfAngle.
enum class Torus
{
  Closed,
  Cut
};

constexpr double MajorRadius = 1.0;
constexpr double MinorRadius = 0.4;
constexpr double CutHalfAngle = 0.35;

/// The angle u around the axis runs over [begin, end); the angle v around the tube always over [0,
/// 2 pi).
struct AngleRange
{
  double begin;
  double end;
};
AngleRange axialAngles(Torus torus);

/// @param angles u around the axis z, v around the tube
Vector3d torusPoint(const Vector2d& angles);
Vector3d torusNormal(const Vector2d& angles); ///< outward, unit

/// Derivatives of torusPoint by u and by v, as columns.
Eigen::Matrix<double, 3, 2> torusTangents(const Vector2d& angles);

Vector2d torusAngles(
  const Vector3d& place); ///< of the closest point, u in [0, 2 pi), v in (-pi, pi]
double torusDistance(
  const Vector3d& place); ///< signed, negative inside; the torus continues across the cut

/// Arc length from a point of the torus to the nearer boundary circle, negative inside the piece
/// cut out.
double distanceFromCut(const Vector3d& place);

double torusDiagonal(); ///< of the bounding box of the closed torus

} // namespace SurfaceScalars::Truth
