#pragma once

#include "LaplacianFunctions.h"
#include "Tikhonov.h"

#include <vector>

namespace SurfaceScalars
{

/// (6): the function of least energy with the given values. The paper reduces it to a harmonic function, which
/// is not equivalent: that is SmoothingEnergy::Harmonic; the true minimizer of ||Lf|| is Biharmonic.
/// @throws InvalidInput for a component without constraints (named); ...
SURFACESCALARSCORE_EXPORT Values interpolateConstraints(const Laplacian& laplacian,
  SmoothingEnergy energy, const std::vector<ValueConstraint>& constraints,
  const Execution& execution = {}, const VertexName& nameOf = {});

/// (7): minimizes energy(x) + t sum over constraints of (area / n) (x_k - f_k)^2 (t as Tikhonov.h)
SURFACESCALARSCORE_EXPORT Values fitConstraints(const Laplacian& laplacian, SmoothingEnergy energy,
  const std::vector<ValueConstraint>& constraints, double epsilon, const Execution& execution = {},
  const VertexName& nameOf = {});

} // namespace SurfaceScalars
