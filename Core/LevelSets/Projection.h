#pragma once

#include "LevelSetModel.h"

#include <optional>

namespace SurfaceScalars
{

/// When a projection has arrived, and when it has failed. Lengths.
struct ProjectionLimits
{
  double tolerance;
  double farthest; ///< from the starting place
  int maximumIterations;
};

/// Solves F = level, g = 0 from `start`, (14), centering the model at each iterate; afterwards it
/// is centered at the result.
/// @returns none if the way leads off the model; a point that is not `converged` is the last
/// iterate.
std::optional<LevelSetPoint> project(
  LevelSetModel& model, double level, const Vector3d& start, const ProjectionLimits& limits);

} // namespace SurfaceScalars
