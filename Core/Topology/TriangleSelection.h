#pragma once

#include "SurfaceScalarsCoreExport.h"
#include "Triangles.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The triangles none of whose corners is left out, such as those around samples without a value. A
 * mesh that was a manifold remains one: where holes meet at a vertex, so that its triangles form
 * several fans, it keeps the fan of the most triangles.
 *
 * Time O(n) for meshes with bounded numbers of triangles around a vertex.
 *
 * @param leftOut nonzero for the vertices to be left out; corners of triangles are below its size
 * @param torn nonzero for vertices around which triangles are gone already; empty for none
 */
SURFACESCALARSCORE_EXPORT Triangles trianglesWithout(
  const Triangles& triangles, const std::vector<char>& leftOut, const std::vector<char>& torn = {});

} // namespace SurfaceScalars
