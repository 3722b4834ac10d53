#pragma once

#include "Basics.h"
#include "VertexName.h"

#include <string>

namespace SurfaceScalars
{

/// @throws InvalidInput unless there is one value per vertex, all finite: names the first that is
/// not
void checkVertexValues(Index vertexCount, const ValuesRef& values, const VertexName& nameOf = {});

/// @param of what the vertices are: "mesh" @throws InvalidInput unless there is one place per
/// vertex
void checkVertexPlaces(Index vertexCount, const PointsRef& places, const std::string& of);

/// @param values one or more, finite @throws InvalidInput if their range is not
void checkValueRange(const ValuesRef& values);

} // namespace SurfaceScalars
