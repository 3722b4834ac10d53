#pragma once

#include "LevelBound.h"
#include "PatchStars.h"

#include <vector>

namespace SurfaceScalars
{

struct SaddleCandidates
{
  std::vector<PatchPlace> onEdges;
  std::vector<PatchPlace> inTriangles;
  std::vector<Index> meshVertices;

  bool empty() const
  {
    return this->onEdges.empty() && this->inTriangles.empty() && this->meshVertices.empty();
  }
};

/**
 * Where u restricted to the mesh may have a saddle whose value is the level's: critical points in
 * triangles (Newton's method in their planes), extrema along edges from which u rises, or falls, to
 * both sides the other way, and vertices, whose value is within the bound's margin of the level.
 *
 * @param patch refined for the level
 */
SaddleCandidates saddleCandidates(const ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution);

} // namespace SurfaceScalars
