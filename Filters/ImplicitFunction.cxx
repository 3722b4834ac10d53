#include "ImplicitFunction.h"

#include "vtkImplicitFunction.h"

namespace SurfaceScalars
{

VolumeFunction volumeFunctionOf(vtkImplicitFunction* function)
{
  if (!function)
  {
    return {};
  }
  return [function](const Vector3d& place, Vector3d* gradient)
  {
    Vector3d copy = place; // VTK wants a writable one
    if (gradient)
    {
      function->FunctionGradient(copy.data(), gradient->data());
    }
    return function->FunctionValue(copy.data());
  };
}

} // namespace SurfaceScalars
