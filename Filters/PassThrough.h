#pragma once

#include <vector>

class vtkPointSet;
class vtkPolyData;

namespace SurfaceScalars
{

/**
 * The input of a point-set filter as its output: polydata as it is, any other point set as its
 * points and point arrays with a vertex each, several blocks merged, with the arrays that all of
 * them have. Points keep their order.
 *
 * @param blocks as of pointSetsOf()
 */
void passThrough(const std::vector<vtkPointSet*>& blocks, vtkPolyData* output);

} // namespace SurfaceScalars
