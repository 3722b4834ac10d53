#pragma once

#include "MeshInput.h"
#include "MorseComplex.h"

class vtkPolyData;

namespace SurfaceScalars
{

class FilterRun;

/**
 * The separatrices as polylines with the arrays of the port `Separatrices`. A vertex of the mesh is
 * one point, however many paths go through it.
 */
void writeSeparatrices(
  const MorseComplex& complex, const MeshInput& mesh, const FilterRun& run, vtkPolyData* output);

} // namespace SurfaceScalars
