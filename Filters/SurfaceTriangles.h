#pragma once

#include "Execution.h"
#include "Triangles.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace SurfaceScalars
{

/**
 * The triangles of polydata, corners are ids of points: its triangles, then its quads and other
 * polygons cut up as Triangulate does, in the order of the cells, then its strips. A polygon
 * without area, which has no ears to cut, becomes a fan. Vertices and lines are ignored.
 *
 * @param cells if there: of which cell each triangle is a part, ascending
 * @throws InvalidInput for a corner that does not exist; Aborted
 */
Triangles trianglesOf(
  vtkPolyData* surface, const Execution& execution, std::vector<vtkIdType>* cells = nullptr);

} // namespace SurfaceScalars
