#pragma once

#include "Basics.h"

#include <array>
#include <vector>

namespace SurfaceScalars
{

/// Two components of what is not after a vertex become one at that vertex; each is known by its
/// first vertex, an extremum.
struct Merge
{
  Index younger; ///< ends here
  Index elder;
  Index vertex;
  std::array<Index, 2> basins; ///< that meet at the vertex
};

/// How the components of the vertices visited so far begin and merge as one vertex after another is
/// visited.
struct MergeTree
{
  std::vector<Index> basins; ///< of each vertex: the extremum that steps to the first neighbor
                             ///< lead to
  std::vector<Merge> merges; ///< in the order of the vertices
};

struct MergeTrees
{
  MergeTree sublevel;   ///< of {f <= t}, t rising: minima
  MergeTree superlevel; ///< of {f >= t}, t falling: maxima
};

} // namespace SurfaceScalars
