#pragma once

#include "DisjointSets.h"
#include "Execution.h"

#include <algorithm>
#include <vector>

namespace SurfaceScalars
{

/// The connected components of vertices that simplices join.
struct VertexComponents
{
  std::vector<Index> ofVertices; ///< numbered from 0 in the order of their first vertices
  Index count = 0;
};

/// @param simplices corners below vertexCount, one simplex per column
/// @throws Aborted
template <class Simplices>
VertexComponents componentsOf(
  Index vertexCount, const Simplices& simplices, const Execution& execution)
{
  constexpr Eigen::Index step = 1 << 16; // simplices between two reports
  constexpr double simplexShare = 0.7;   // of the work
  DisjointSets sets(vertexCount);
  for (Eigen::Index simplex = 0; simplex < simplices.cols(); ++simplex)
  {
    if (simplex % step == 0)
    {
      execution.report(
        simplexShare * static_cast<double>(simplex) / static_cast<double>(simplices.cols()));
    }
    for (Eigen::Index corner = 1; corner < simplices.rows(); ++corner)
    {
      const auto [first, second] = std::minmax(
        { sets.find(simplices(corner - 1, simplex)), sets.find(simplices(corner, simplex)) });
      sets.attach(second, first);
    }
  }
  execution.report(simplexShare);
  VertexComponents components;
  components.ofVertices.resize(vertexCount);
  for (Index vertex = 0; vertex < vertexCount; ++vertex)
  {
    components.ofVertices[vertex] =
      sets.isRoot(vertex) ? components.count++ : components.ofVertices[sets.find(vertex)];
  }
  execution.report(1.0);
  return components;
}

} // namespace SurfaceScalars
