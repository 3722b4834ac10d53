#pragma once

#include "FilterRun.h"
#include "PointChoice.h"

class vtkPolyData;

namespace SurfaceScalars
{

struct SurfaceFunction
{
  Values values;           ///< at all points, NaN where the function is not defined
  double eigenvalue = 0.0; ///< of LaplacianEigenfunction, 1 / length^2
};

/**
 * The function on the surface that the properties of a vtkPointSetScalarFunction describe:
 * Geodesic, Harmonic, LaplacianEigenfunction or Diffusion (point-set paper, sec. 2.2). Points that
 * are part of the surface and get no value are counted in a note.
 *
 * @param surface the merged input, for its triangles
 * @throws InvalidInput for properties that cannot be followed on this surface; Aborted
 */
SurfaceFunction surfaceFunction(
  const PointChoice& choice, vtkPolyData* surface, FilterRun& run, const Execution& execution);

} // namespace SurfaceScalars
