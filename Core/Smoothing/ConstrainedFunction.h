#pragma once

#include "LaplacianFunctions.h"
#include "Tikhonov.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * (6) of the smoothing paper: the function of least energy with given values at some vertices. The
 * paper reduces ||L f|| to L g = b at the other vertices, which is not equivalent: that is the
 * least Harmonic energy, harmonicFunction(). The least Biharmonic energy is smooth at the given
 * vertices as well, and not bounded by the given values.
 *
 * Biharmonic: the matrix of the unknowns is assembled and factored; a million vertices take
 * gigabytes.
 *
 * @param constraints at least one in each connected component; several at a vertex must agree
 * @throws InvalidInput as harmonicFunction(); Error if the solver fails; Aborted
 */
SURFACESCALARSCORE_EXPORT Values interpolateConstraints(const Laplacian& laplacian,
  SmoothingEnergy energy, const std::vector<ValueConstraint>& constraints,
  const Execution& execution = {}, const VertexName& nameOf = {});

/**
 * (7): minimizes energy(x) + t area / n times the sum over the constraints of (x - value)^2, with t
 * as in TikhonovSmoother: its Identity, restricted to some vertices.
 *
 * @param epsilon > 0, no unit @throws as interpolateConstraints(); InvalidInput for another epsilon
 */
SURFACESCALARSCORE_EXPORT Values fitConstraints(std::shared_ptr<const Laplacian> laplacian,
  SmoothingEnergy energy, const std::vector<ValueConstraint>& constraints, double epsilon,
  const Execution& execution = {}, const VertexName& nameOf = {});

} // namespace SurfaceScalars
