#pragma once

#include "FieldApproximation.h"

namespace SurfaceScalars
{

/// The parameters with what was left to be chosen, from the samples alone; only widths that follow
/// each neighborhood stay 0.
FieldParameters completed(
  const FieldParameters& asked, const FieldSamples& samples, const Execution& execution);

} // namespace SurfaceScalars
