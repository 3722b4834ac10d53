#pragma once

#include "CurveTracer.h"
#include "LevelSaddles.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// A curve from a saddle along one of its branches, to a saddle along one of its branches or to an
/// end.
struct SaddleArc
{
  TracedCurve curve; ///< its ends at saddles are their centers
  BranchId from = {};
  std::optional<BranchId> to;
};

/**
 * The curves of a level through its saddles. An arc that returns to its saddle is a loop. Arcs
 * between different saddles follow each other round the same larger values, past loops of the
 * saddle: every loop stays on one side of them. Arcs that cannot be joined so, since some end at
 * the boundary, are curves of their own.
 */
std::vector<TracedCurve> joinArcs(
  const std::vector<SaddleFan>& fans, const std::vector<SaddleArc>& arcs);

} // namespace SurfaceScalars
