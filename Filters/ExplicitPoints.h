#pragma once

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkDataSet;
class vtkPointSet;

namespace SurfaceScalars
{

/// A dataset as points with point data: a point set itself; of images and other grids whose points
/// follow from a rule, these as polydata without cells. Null if there is none.
vtkSmartPointer<vtkPointSet> withExplicitPoints(vtkDataSet* dataset);

/// The same of each block if it is a composite, whose structure stays; what has no points is left
/// as it is.
vtkSmartPointer<vtkDataObject> withExplicitPoints(vtkDataObject* input);

} // namespace SurfaceScalars
