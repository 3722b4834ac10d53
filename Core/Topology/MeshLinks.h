#pragma once

#include "MeshTopology.h"

namespace SurfaceScalars
{

/// The neighbors of the vertices of a mesh. Those that follow each other in a link are neighbors,
/// too: only where what is before a vertex falls apart in its link do components merge.
struct MeshLinks
{
  const MeshTopology& mesh;

  VertexRange operator()(Index vertex) const { return this->mesh.link(vertex); }

  /// Calls visit(neighbor) for one neighbor of each such part if there are several.
  /// @param isBefore(neighbor): whether it is before the vertex
  template <class IsBefore, class Visit>
  void forEachOfSeveralParts(Index vertex, const IsBefore& isBefore, const Visit& visit) const
  {
    const VertexRange path = this->mesh.linkPath(vertex);
    const bool isPart = this->mesh.isBoundary(vertex) && isBefore(*path.first);
    int parts = isPart ? 1 : 0; // counted first: where they begin cannot be foreseen
    int last = isBefore(*path.first) ? 1 : 0;
    for (const Index* next = path.first + 1; next != path.last; ++next)
    {
      const int now = isBefore(*next) ? 1 : 0;
      parts += now & ~last;
      last = now;
    }
    if (parts < 2)
    {
      return;
    }
    if (isPart)
    {
      visit(*path.first);
    }
    for (const Index* next = path.first + 1; next != path.last; ++next)
    {
      if (isBefore(*next) && !isBefore(next[-1]))
      {
        visit(*next);
      }
    }
  }
};

} // namespace SurfaceScalars
