#pragma once

#include "Execution.h"
#include "RadialKernel.h"

namespace SurfaceScalars
{

/// sum_j weights[j] phi(|p - sources_j|) at all targets p, in time of their product.
Values radialSums(const RadialKernel& kernel, const Points& sources, const Values& weights,
  const PointsRef& targets, const Execution& execution);

} // namespace SurfaceScalars
