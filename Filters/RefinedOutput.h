#pragma once

#include "StarRefinement.h"
#include "SurfaceVertices.h"

class vtkPolyData;

namespace SurfaceScalars
{

class FilterRun;

/// The refined mesh, whose added vertices are points after those of the input.
MeshedSurface refinedSurface(const MeshedSurface& surface, const RefinedMesh& refined);

/// Values of a mesh on the refined one, linear along its edges.
Values refinedValues(const Values& values, const RefinedMesh& refined);

/**
 * The input with cells refined: one that a split triangle is part of is replaced by triangles, with
 * its cell data; all other cells remain, polygons before strips. Points keep their ids, those that
 * are added come after them, with point data as far along the edge. Adds the cell array Split: 1
 * for parts of split triangles, else 0; the input's array of this name becomes `SplitInput`, with a
 * warning.
 *
 * @param surface what was read of the input
 */
void passRefined(const FilterRun& run, vtkPolyData* input, const MeshedSurface& surface,
  const RefinedMesh& refined, vtkPolyData* output);

} // namespace SurfaceScalars
