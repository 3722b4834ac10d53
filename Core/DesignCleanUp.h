#pragma once

#include "FunctionDesign.h"

namespace SurfaceScalars
{

/**
 * Removes minima and maxima that nothing requires, with the saddles that cancel them. Kept are
 * those that are asked for, those that are paired with a saddle that is asked for (Euler's formula
 * needs as many beside it), and the lowest and highest of each component.
 *
 * Where a removal would take away a critical point that is asked for and there, nothing is removed.
 */
Values withoutUnneeded(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution);

} // namespace SurfaceScalars
