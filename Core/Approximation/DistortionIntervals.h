#pragma once

#include "CrossedCells.h"
#include "LevelSetDistortion.h"

#include <functional>
#include <vector>

namespace SurfaceScalars
{

/// Sets distances[i] to that between the levels intervals[i] and intervals[i] + 1.
using MeasureIntervals = std::function<void(const CrossedCells& crossed,
  const std::vector<Index>& intervals, double* distances, const Execution& execution)>;

/// Measures the intervals between consecutive iso-values in which there is no critical value, in
/// blocks of so many as memory allows for.
/// @param cells that tell which levels are empty, by crossing none @param ranks of their corners
/// @throws InvalidInput unless iso-values and critical values are ascending; Aborted
LevelSetDistortion measureIntervals(const SimplicesRef& cells, const std::vector<Index>& ranks,
  const ValuesRef& isoValues, const ValuesRef& criticalValues, const Execution& execution,
  const MeasureIntervals& measure);

} // namespace SurfaceScalars
