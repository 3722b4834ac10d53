#include "FieldChoices.h"

#include "LocalFit.h"
#include "NeighborhoodSize.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr int InterpolationCount = 32; // samples that a sum of radial functions interpolates

/// An average is a polynomial of degree 0, but where samples lie evenly around a place it is as
/// good as one of degree 1.
int degreeOf(const FieldParameters& parameters)
{
  return parameters.scheme == Scheme::ParameterizedMLS ? parameters.polynomialDegree : 1;
}

int chooseCount(
  const FieldParameters& asked, const FieldSamples& samples, const Execution& execution)
{
  if (asked.scheme == Scheme::LocalRBF || asked.scheme == Scheme::Hybrid)
  {
    return InterpolationCount;
  }
  if (asked.searchRadius > 0.0)
  {
    return LocalFit::termCount(degreeOf(asked)) + 1;
  }
  const double lowest = samples.values.minCoeff();
  const double range = samples.values.maxCoeff() - lowest;
  const Values scaled = (samples.values.array() - lowest) / (range > 0.0 ? range : 1.0);
  return chooseNeighborCount(samples.cloud, scaled, degreeOf(asked), execution);
}

} // namespace

FieldParameters completed(
  const FieldParameters& asked, const FieldSamples& samples, const Execution& execution)
{
  FieldParameters result = asked;
  if (asked.neighborCount == 0 && asked.scheme != Scheme::GlobalRBF)
  {
    result.neighborCount = chooseCount(asked, samples, execution);
  }
  result.neighborCount =
    std::min(result.neighborCount, static_cast<int>(samples.cloud.pointCount()));
  return result;
}

} // namespace SurfaceScalars
