#pragma once

#include "Basics.h"

#include <functional>
#include <string>

namespace SurfaceScalars::Truth
{

/// A smooth function in space and its gradient.
struct SpaceFunction
{
  std::string name;
  std::function<double(const Vector3d&)> value;
  std::function<Vector3d(const Vector3d&)> gradient;
};

/// <d, p> with d parallel to (0.5, 0.2, 0.84): a height that no symmetry of the torus keeps.
SpaceFunction tiltedHeight();

/// x^2 - y^2 + log(1 + |p|): not linear, with symmetric and with nearby critical values.
SpaceFunction saddleWithLogarithm();

/// The values at the columns of points.
Values valuesOf(const SpaceFunction& function, const PointsRef& points);
Values valuesOf(const std::function<double(const Vector3d&)>& function, const PointsRef& points);

} // namespace SurfaceScalars::Truth
