#pragma once

#include "LevelBound.h"
#include "TriangleBlocks.h"
#include "Triangles.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The triangles that may have a part of a level set, ascending: those that no Taylor polynomial of
 * u excludes (see LevelBound). One polynomial serves a block of triangles, its parts and theirs as
 * long as it is sharp enough, so that u is evaluated near the level set only.
 *
 * @param vertices relative to the origin of the field's cloud
 */
std::vector<Index> trianglesNear(LevelFunction& function, const LevelBound& bound,
  const Points& vertices, const Triangles& triangles, const TriangleBlocks& blocks,
  const Execution& execution);

/// A ball around a triangle.
Ball ballAround(const Vector3d& a, const Vector3d& b, const Vector3d& c);

} // namespace SurfaceScalars
