#pragma once

#include "vtkType.h"

#include <vector>

class vtkDataObject;
class vtkSelection;

namespace SurfaceScalars
{

/**
 * The points that a selection picks from an input, ascending: where they are among the points of
 * all blocks. Of selected cells all points are taken.
 *
 * @param input what pointSetsOf() can read
 * @throws InvalidInput for a selection that is a query
 */
std::vector<vtkIdType> selectedPoints(vtkSelection* selection, vtkDataObject* input);

} // namespace SurfaceScalars
