#include "Projection.h"

#include <cmath>

namespace SurfaceScalars
{

std::optional<LevelSetPoint> project(
  LevelSetModel& model, double level, const Vector3d& start, const ProjectionLimits& limits)
{
  LevelSetPoint point;
  point.position = start;
  for (int i = 0;; ++i)
  {
    if (!model.center(point.position))
    {
      return {};
    }
    point.residual = model.firstOrderStep(level).norm();
    point.converged = point.residual <= limits.tolerance;
    if (point.converged || i >= limits.maximumIterations)
    {
      point.normal = model.normal();
      return std::isfinite(point.residual) ? std::optional<LevelSetPoint>(point) : std::nullopt;
    }
    const std::optional<Vector3d> next = model.solve(level, point.position);
    if (!next || !((*next - start).norm() <= limits.farthest))
    {
      return {};
    }
    point.position = *next;
  }
}

} // namespace SurfaceScalars
