#pragma once

#include "LevelBound.h"
#include "PatchStars.h"

#include <vector>

namespace SurfaceScalars
{

struct SaddleCandidates
{
  std::vector<PatchPlace> places; ///< in triangles or on edges
  std::vector<Index> meshVertices;

  bool empty() const { return this->places.empty() && this->meshVertices.empty(); }
};

/**
 * Where u restricted to the mesh may have a saddle whose value is the level's: critical points in
 * triangles (Newton's method in their planes), extrema along edges and vertices, whose value is
 * within the bound's margin of the level.
 *
 * @param patch refined for the level
 */
SaddleCandidates saddleCandidates(const ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution);

/**
 * Makes candidates that are saddles vertices of a patch, pinned to the level: those with 2 + 2 m
 * changes of the sign of u - u(p) on a small ring around, m >= 1. Where the value is not quite the
 * level's, the function gets a dent that makes it so, as narrow as the branches allow.
 *
 * @param patch not refined yet @returns whether there is any
 */
bool pinSaddles(const SaddleCandidates& candidates, ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution);

} // namespace SurfaceScalars
