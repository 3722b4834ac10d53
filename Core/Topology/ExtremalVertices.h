#pragma once

#include "CriticalPoint.h"
#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// Vertices at which a function has extrema.
struct ExtremalVertices
{
  std::vector<Index> minima;
  std::vector<Index> maxima;
};

/// The minima and maxima among critical points on a mesh.
ExtremalVertices extremaOf(const std::vector<CriticalPoint>& points);

/// Adds the lowest and the highest vertex of each component, ties by index. Both lists are
/// ascending then.
void addComponentExtrema(
  ExtremalVertices& extrema, const MeshTopology& topology, const Values& function);

} // namespace SurfaceScalars
