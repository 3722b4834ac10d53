#pragma once

#include "MeshTopology.h"

namespace SurfaceScalars
{

/// @throws InvalidInput unless there is one value per vertex, all finite
void checkMeshValues(const MeshTopology& mesh, const ValuesRef& values);

} // namespace SurfaceScalars
