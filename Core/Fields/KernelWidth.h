#pragma once

#include "FieldApproximation.h"

namespace SurfaceScalars
{

/**
 * The width h with which interpolation at all samples but one would miss that one least, root mean
 * square over all (Rippa 1999), among those with which the system is well conditioned.
 *
 * Of many samples, some hundred that are spread over all are asked, and the width is scaled to the
 * sampling step of all. Kernels of compact support reach some eighty samples at most where there
 * are too many for a dense system. Kernels that do not depend on a width get the cloud's radius.
 *
 * Where none of them misses by more than rounding errors, as with a linear function, it is the
 * widest such.
 *
 * @throws InvalidInput if the system is badly conditioned with every width; Aborted
 */
double chooseKernelWidth(const FieldSamples& samples, KernelType kernel, double regularization,
  const Execution& execution);

} // namespace SurfaceScalars
