#pragma once

#include "CurveTracer.h"
#include "EdgeCrossings.h"

#include <memory>
#include <optional>

namespace SurfaceScalars
{

/// Turns crossings into samples of a level set as scheme and surface model want it (sec. 4.1).
class EdgeSampler
{
public:
  EdgeSampler(const SampledFunction& function, const FitSize& size,
    const ContourParameters& parameters, const TracingLimits& limits);

  /// @returns none where there is no local model; a sample that could not be moved stays on the
  /// edge, not converged
  std::optional<LevelSetPoint> sample(const EdgeCrossing& crossing, double level);

private:
  Vector3d startOf(const Vector3d& linear, double level, double farthest) const;
  std::optional<Vector3d> solveAlongEdge(
    const Vector3d& from, const Vector3d& along, double parameter, double level);
  std::optional<Vector3d> projectOnSurface(Vector3d place);

  const SampledFunction& function_;
  Scheme scheme_;
  SurfaceModel surface_;
  TracingLimits limits_;
  std::unique_ptr<LevelSetModel> model_;
  std::optional<Vector3d> last_; ///< the sample that the model is centered at
};

} // namespace SurfaceScalars
