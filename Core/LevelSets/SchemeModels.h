#pragma once

#include "LevelSetModel.h"

namespace SurfaceScalars
{

/// Of the local fits: a scheme without polynomials of its own still sizes neighborhoods and follows
/// curves with degree 2.
int polynomialDegree(const ContourParameters& parameters);

/// Whether the kernel is made use of.
bool usesKernel(const ContourParameters& parameters);

/// Finds what models of the chosen scheme and surface have to know of all samples beforehand.
/// @throws Aborted
void prepareModels(SampledFunction& function, const FitSize& size,
  const ContourParameters& parameters, const Execution& execution);

/// The model that a scheme traces with, after prepareModels(). Linear has none of its own: its
/// curves follow the polynomial model's.
std::unique_ptr<LevelSetModel> makeModel(
  const SampledFunction& function, const FitSize& size, const ContourParameters& parameters);

} // namespace SurfaceScalars
