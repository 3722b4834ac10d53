#pragma once

#include "Basics.h"
#include "VertexName.h"

namespace SurfaceScalars
{

/// @throws InvalidInput unless there is one value per vertex, all finite: names the first that is
/// not
void checkVertexValues(Index vertexCount, const ValuesRef& values, const VertexName& nameOf = {});

/// @param values one or more, finite @throws InvalidInput if their range is not
void checkValueRange(const ValuesRef& values);

} // namespace SurfaceScalars
