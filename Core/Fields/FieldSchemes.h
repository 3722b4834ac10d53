#pragma once

#include "FieldApproximation.h"
#include "NearestSearch.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

// One for each thread; the samples must outlive them. The parameters are checked and complete: k or
// a radius is given, while a kernel width of 0 follows the neighborhood.

/// For the neighborhoods of ExplicitMLS and LocalRBF.
NearestSearch neighborhoodSearch(const PointCloud& cloud, const FieldParameters& parameters);

/// h of (6) in a neighborhood of this radius: sigma / sqrt(3) unless it is given.
double averageWidth(double kernelWidth, double radius);

/// (6): not interpolating, reproduces constants.
std::unique_ptr<FieldApproximation> makeExplicitMLS(
  const FieldSamples& samples, const FieldParameters& parameters);

/// (4)(5): not interpolating, reproduces polynomials of its degree on planes. F is constant along
/// the normal of the tangent plane. With a search radius, the nearest samples beyond it take part
/// where those within do not determine the polynomial.
std::unique_ptr<FieldApproximation> makeParameterizedMLS(
  const FieldSamples& samples, const FieldParameters& parameters);

/// (8)-(10): interpolating without regularization, reproduces linear functions. Width 0: a multiple
/// of the neighborhood's radius that suits the kernel.
std::unique_ptr<FieldApproximation> makeLocalRBF(
  const FieldSamples& samples, const FieldParameters& parameters);

/// LocalRBF where the nearest sample is marked, ExplicitMLS elsewhere. `marked` must outlive it.
std::unique_ptr<FieldApproximation> makeHybrid(
  const FieldSamples& samples, const FieldParameters& parameters, const std::vector<char>& marked);

/// Where the average (6) misses the samples of a neighborhood, which has to be known for
/// makeHybrid(): one mark per sample.
std::vector<char> markMissedSamples(
  const FieldSamples& samples, const FieldParameters& parameters, const Execution& execution);

} // namespace SurfaceScalars
