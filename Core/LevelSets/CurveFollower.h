#pragma once

#include "LevelSaddles.h"
#include "SaddleLoops.h"
#include "SeedCover.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// Follows the curves through starts on a level set until they end.
class CurveFollower
{
public:
  CurveFollower(LevelSetWalker& walker, const TracingLimits& limits, std::size_t seeds,
    SeedCover& cover, LevelSaddles& saddles, const Poll& poll)
    : walker_(walker)
    , limits_(limits)
    , mostStations_(200 + 20 * seeds)
    , cover_(cover)
    , saddles_(saddles)
    , poll_(poll)
  {
  }

  TracedCurve trace(const Station& start);  ///< both ways
  SaddleArc traceArc(const BranchId& from); ///< from a known saddle

private:
  /// Why it ends, or none if it closed.
  using Ending = std::optional<CurveEnd>;

  Ending extend(std::vector<Station>& path, bool mayClose);
  CurveEnd endAtEdge(std::vector<Station>& path);
  double stepBefore(const std::vector<Station>& path, std::size_t edge) const;
  bool endsAtSaddle(std::vector<Station>& path);
  bool entersSaddle(std::vector<Station>& path, const Station& next);

  LevelSetWalker& walker_;
  TracingLimits limits_;
  std::size_t mostStations_;
  SeedCover& cover_; ///< the curves that are there already
  LevelSaddles& saddles_;
  std::optional<BranchId> entered_; ///< by the last curve that ended
  const Poll& poll_;
};

} // namespace SurfaceScalars
