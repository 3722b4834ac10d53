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

/// cos 3u cos 2v of the torus' angles: 24 extrema, 24 saddles.
SpaceFunction cosinesOfAngles();

/// Re (x + i y)^(m + 1): a saddle of multiplicity m at the origin of the plane, nothing else.
SpaceFunction planarSaddle(int multiplicity);

/// The values at the columns of points.
Values valuesOf(const SpaceFunction& function, const PointsRef& points);
Values valuesOf(const std::function<double(const Vector3d&)>& function, const PointsRef& points);

} // namespace SurfaceScalars::Truth
