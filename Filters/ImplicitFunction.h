#pragma once

#include "VolumeFunction.h"

class vtkImplicitFunction;

namespace SurfaceScalars
{

/// An implicit function as the core knows it, for one thread at a time; none if there is none.
VolumeFunction volumeFunctionOf(vtkImplicitFunction* function);

} // namespace SurfaceScalars
