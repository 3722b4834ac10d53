#pragma once

#include "GaussianAverage.h"

#include <optional>

namespace SurfaceScalars
{

/// n(x) of sec. 2.1: the direction in which weighted samples spread least as seen from the place x,
/// of either sign.
struct SurfaceNormal
{
  Vector3d direction;
  Eigen::Matrix3d turn; ///< its derivative: column j by coordinate j of the place
};

/// @returns none where the samples lie on a line
std::optional<SurfaceNormal> surfaceNormal(const GaussianAverage& average);

/// (1) divided by the sum of the weights, see makeExtremalSurface(). Value and gradient.
FieldJet extremalDistance(const GaussianAverage& average, const SurfaceNormal& normal);

/// (2), see makeAverageSurface(). Value and gradient.
FieldJet averageDistance(const GaussianAverage& average, const SurfaceNormal& normal);

} // namespace SurfaceScalars
