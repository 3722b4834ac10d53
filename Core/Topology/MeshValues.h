#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// @throws InvalidInput unless there is one value per vertex, all finite
void checkVertexValues(Index vertexCount, const ValuesRef& values);

} // namespace SurfaceScalars
