#pragma once

#include "SaddleCandidates.h"

namespace SurfaceScalars
{

/**
 * Makes candidates that are saddles vertices of a patch, pinned to the level: those with 2 + 2 m
 * changes of the sign of u - u(p) on a small ring around, m >= 1. Of those in one ring, as where a
 * saddle of a smooth u lies at a slight bend of the mesh, one is taken: at a vertex, or else on an
 * edge. Where the value is not quite the level's, the function gets a dent that makes it so, as
 * narrow as the branches allow.
 *
 * @param patch not refined yet @returns whether there is any
 */
bool pinSaddles(const SaddleCandidates& candidates, ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution);

} // namespace SurfaceScalars
