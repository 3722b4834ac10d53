#pragma once

#include "FieldApproximation.h"

#include <string>

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

/**
 * One sentence if the width that was asked for makes spikes of radial functions: at half the
 * spacing of the centers a term is less than 0.06 of what it is at its center. Between the centers
 * the sum then misses a function that it follows otherwise by half of what the linear polynomial
 * alone does, or more. Empty for other widths, and for those that are chosen here.
 */
SURFACESCALARSCORE_EXPORT std::string remarkOnWidth(
  const FieldParameters& asked, const PointCloud& centers);

} // namespace SurfaceScalars
