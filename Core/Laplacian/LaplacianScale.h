#pragma once

#include "Execution.h"
#include "Laplacian.h"

namespace SurfaceScalars
{

/**
 * The factor by which the stiffness of a point set has to be multiplied: the one that makes the
 * energies of the relaxed coordinates sum to twice the mass.
 *
 * The coordinates x are relaxed to x + chi with chi = -(1 - q(A))^2 x, A = D^-1 stiffness, D the
 * diagonal. q is the Chebyshev polynomial that is 1 at 0 and small from 0.2 on, the wavelengths up
 * to some six sampling steps. As the derivative of 1 - (1 - q)^2 at 0 is 0, what is smooth remains:
 * a curved surface is not smoothed. Where nothing gives way, as on a regular grid, chi is 0. At
 * boundaries everything does, so points that move by more than 1.5 sampling steps do not count.
 *
 * @throws Aborted
 */
double stiffnessScale(
  const Laplacian& laplacian, const NeighborGraph& graph, const Execution& execution);

} // namespace SurfaceScalars
