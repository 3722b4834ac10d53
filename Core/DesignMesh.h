#pragma once

#include "MeshTopology.h"
#include "LeastEnergy.h"
#include "Tikhonov.h"

#include <map>
#include <memory>

namespace SurfaceScalars
{

/**
 * A mesh and what is worth keeping between designs on it: topology, Laplacian, its factors and the
 * Green's functions of vertices asked for before. Not to be used by several threads at once.
 */
class SURFACESCALARSCORE_EXPORT DesignMesh
{
public:
  /// @param vertices 3 x n, finite, length units
  /// @param nameOf vertices, for messages
  /// @throws InvalidInput as MeshTopology does, or for a coordinate that is not finite; Aborted
  DesignMesh(Points vertices, const Triangles& triangles, const Execution& execution = {},
    VertexName nameOf = {});

  const Points& vertices() const;
  const MeshTopology& topology() const;
  const VertexName& nameOf() const;
};

} // namespace SurfaceScalars
