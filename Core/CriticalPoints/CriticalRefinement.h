#pragma once

#include "CriticalSweep.h"

#include <array>
#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// The sums of the indices of critical points within rings around a place, the smallest first.
using EnclosedIndices = std::array<std::optional<int>, 4>;

/// A place where the gradient of f~ vanishes, as seen by the fit centered there.
struct RefinedPoint
{
  Vector3d place;  ///< relative to the cloud of the scale
  Vector3d normal; ///< of the surface
  double value = 0.0;
  double reach = 0.0;       ///< radius of the fit
  double residual = 0.0;    ///< norm of the tangential gradient
  Vector2d curvature;       ///< eigenvalues of the Hessian, ascending
  Vector2d significance;    ///< ratios of their sizes to their standard errors, ascending
  double bend = 0.0;        ///< how much the Hessian changes within a third of the radius
  double uncertainty = 0.0; ///< of the place: standard error, length
  bool isSettled = true;    ///< the fit centered there is critical there
  int votes = 1;            ///< candidates that lead there
  EnclosedIndices enclosed; ///< by rings around it, where they were counted
};

/// @returns none where there are no samples to fit to
std::optional<RefinedPoint> describePlace(CriticalModel& model, const Vector3d& place);

/// Where Newton's method leads from a place, if that is next to it and not on a plateau.
std::optional<RefinedPoint> refinePlace(CriticalModel& model, const Vector3d& place, double reach);

/// Newton's method from the candidates, with fits centered anew where it leads, until the center
/// is critical itself. One for all candidates that lead to the same place, in their order. Places
/// at or beyond the edge of the sampled surface, or deep in a void, are left out.
std::vector<RefinedPoint> refineCandidates(const std::vector<CriticalCandidate>& candidates,
  const CriticalScale& scale, const Execution& execution);

} // namespace SurfaceScalars
