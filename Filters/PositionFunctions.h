#pragma once

#include "Basics.h"
#include "Execution.h"

#include <string>

class vtkPointSetScalarFunction;

namespace SurfaceScalars
{

/// @throws InvalidInput that names the property if a number of the place is not finite
Vector3d finitePlace(const std::string& property, const double* numbers);

/**
 * The function of position that the properties of a vtkPointSetScalarFunction describe: Height,
 * DistanceToPoint or DistanceToPlane (point-set paper, sec. 2.2).
 *
 * @returns the value at each point, NaN where the position is not finite
 * @throws InvalidInput for a place or direction that is none; Aborted
 */
Values positionFunction(
  vtkPointSetScalarFunction& filter, const Points& points, const Execution& execution);

} // namespace SurfaceScalars
