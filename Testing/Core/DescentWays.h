#pragma once

#include "Field.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/// The way of the iteration from a start.
struct Way
{
  Vector2d end;
  std::vector<double> gradients; ///< |grad F| at every place of the way

  static constexpr double Converged = 1e-10; ///< |grad F|, as in the design paper, sec. 5
  bool converged() const { return this->gradients.back() <= Converged; }
};

/// The ways to where the gradient of F in the plane z = 0 vanishes, by Levenberg's and Marquardt's
/// method, from random starts in the square |x|, |y| <= halfWidth.
std::vector<Way> followFromRandomStarts(const Field& field, double halfWidth, int startCount);

} // namespace SurfaceScalars::Truth
