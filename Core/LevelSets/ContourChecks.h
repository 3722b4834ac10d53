#pragma once

#include "LevelSets.h"

namespace SurfaceScalars
{

/// What traceLevelSets() does not work on. @throws InvalidInput
void checkContourInput(
  const NeighborGraph& graph, const ValuesRef& values, const ContourParameters& parameters);

} // namespace SurfaceScalars
