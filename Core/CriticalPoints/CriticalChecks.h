#pragma once

#include "FuzzyCriticalPoints.h"

namespace SurfaceScalars
{

/// @throws InvalidInput for what findCriticalPoints() cannot work on
void checkCriticalInput(
  const NeighborGraph& graph, const ValuesRef& values, const CriticalPointParameters& parameters);

} // namespace SurfaceScalars
