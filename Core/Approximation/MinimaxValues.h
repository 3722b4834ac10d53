#pragma once

#include "CenterSum.h"

namespace SurfaceScalars
{

/**
 * Makes the sum's largest miss at the vertices least, but for a few percent, by the values at the
 * centers that are not of stars: those are no longer interpolated.
 *
 * As in Remez' method, this is solved at some vertices, spread over all, and then at those that are
 * missed more than these as well. What is left is the best of all rounds; not even at first is it
 * worse than interpolation.
 *
 * @throws as CenterSum::interpolate()
 */
void minimizeLargestMiss(CenterSum& sum, const CenterSet& centers, const Points& vertices,
  const ValuesRef& values, const Execution& execution);

} // namespace SurfaceScalars
