#pragma once

#include "Execution.h"
#include "Triangles.h"

#include "vtkDataSetAttributes.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace SurfaceScalars
{

/// What the triangles of polydata are, and of which cells.
struct SurfaceCells
{
  Triangles triangles;
  std::vector<vtkIdType> cells; ///< of which each triangle is a part, ascending
  std::vector<char> leftOut;    ///< not 0 for points of cells left out; empty if there are none
};

/**
 * The triangles of polydata, corners are ids of points: its triangles, then its quads and other
 * polygons cut up as Triangulate does, in the order of the cells, then its strips. A polygon
 * without area, which has no ears to cut, becomes a fan. Vertices and lines are ignored, hidden
 * cells and those with a hidden point left out (vtkGhostType).
 *
 * @param marks cells that have one of them are left out
 * @throws InvalidInput for a corner that does not exist; Aborted
 */
SurfaceCells trianglesOf(vtkPolyData* surface, const Execution& execution,
  unsigned char marks = vtkDataSetAttributes::HIDDENCELL);

} // namespace SurfaceScalars
