#pragma once

#include "FunctionDesign.h"

namespace SurfaceScalars
{

/**
 * A function near the given one with the critical points that are asked for, of their types and
 * multiplicities, and beside them as few as Euler's formula allows in each component: none if there
 * is a minimum and a maximum among them and their indices sum to the Euler characteristic;
 * otherwise the most persistent of the given function. Persistence alone cannot say what is needed:
 * the partner of a saddle that is asked for is an extremum that nobody wants.
 *
 * A network of descending paths decides which sublevel sets may be (morseNetwork()), a sweep in the
 * order of the values which vertex is added next to one (sweepWithPoints()), fitMonotone() which
 * values are the nearest in this order, and withEvenChanges() smooths the difference. Values of the
 * points are kept unless their order forbids it: a saddle below all minima but one cannot be
 * without another maximum, and is lifted.
 *
 * On a mesh with boundary, and where other points and paths leave a path no room (a matter of the
 * resolution), extrema are cancelled in pairs with saddles instead: those that are neither asked
 * for, nor paired with a saddle that is, nor the lowest and highest of a component. Where that
 * would take away a critical point that is asked for and there, nothing is removed.
 *
 * Time O(n log n) for each saddle, more where a path must be sought for; 0.3 s for 44,000 vertices
 * and 8 points.
 *
 * @throws Aborted
 */
Values withoutUnneeded(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution);

} // namespace SurfaceScalars
