#pragma once

#include "Execution.h"
#include "Triangles.h"

class vtkPolyData;

namespace SurfaceScalars
{

/**
 * The triangles of polydata, corners are ids of points: its triangles, then its quads and other
 * polygons cut up as Triangulate does, in the order of the cells, then its strips. A polygon
 * without area, which has no ears to cut, becomes a fan. Vertices and lines are ignored.
 *
 * @throws InvalidInput for a corner that does not exist; Aborted
 */
Triangles trianglesOf(vtkPolyData* surface, const Execution& execution);

} // namespace SurfaceScalars
