#pragma once

#include "MeshCriticalPoints.h"
#include "Simplices.h"

#include <functional>
#include <vector>

namespace SurfaceScalars
{

/// Where a function is given that is to be approximated: a surface or a volume. What it is made of
/// must outlive it.
struct ApproximationDomain
{
  const Points& vertices; ///< 3 x n
  SimplicesRef simplices; ///< triangles or tetrahedra
  /// Of values at the vertices, ties by index, with their persistence and pairs.
  std::function<MeshCriticalPoints(const ValuesRef& values, const Execution& execution)>
    criticalPoints;
  std::function<std::vector<Index>(Index vertex)> link; ///< the neighbors that make f critical
};

/// @param vertices one place per vertex of the mesh
SURFACESCALARSCORE_EXPORT ApproximationDomain surfaceDomain(
  const Points& vertices, const MeshTopology& mesh);

} // namespace SurfaceScalars
