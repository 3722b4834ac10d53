#pragma once

#include "Basics.h"

#include <cstddef>
#include <functional>

namespace SurfaceScalars
{

/// What the caller calls a vertex, for messages; empty for the vertex itself.
using VertexName = std::function<std::size_t(Index vertex)>;

inline std::size_t nameOfVertex(Index vertex, const VertexName& nameOf)
{
  return nameOf ? nameOf(vertex) : vertex;
}

} // namespace SurfaceScalars
