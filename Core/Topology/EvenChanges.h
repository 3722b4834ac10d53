#pragma once

#include "ExtremaSweep.h"

namespace SurfaceScalars
{

/**
 * Values in the same order along every edge as the fitted ones, with a change from f that is spread
 * more evenly: where fitMonotone() breaks off, at the edges of what was removed, level sets have
 * creases.
 *
 * In sweeps each value becomes f's with the mean change of its neighbors, as far as those below and
 * above leave it room: their order remains, and so do the types of all vertices.
 *
 * @param isKept not 0 for the vertices that keep their values
 * @throws Aborted
 */
Values withEvenChanges(const MeshTopology& mesh, const ValuesRef& f, Values fitted,
  const ExtremumSigns& isKept, const Execution& execution);

} // namespace SurfaceScalars
