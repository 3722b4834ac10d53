#include "ContourChecks.h"

#include "LocalFit.h"
#include "NumberText.h"
#include "Require.h"
#include "SampleChecks.h"
#include "SchemeModels.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

void checkParameters(
  const NeighborGraph& graph, const ValuesRef& values, const ContourParameters& parameters)
{
  const auto finite = [](double value) { return std::isfinite(value); };
  require(std::all_of(parameters.isoValues.begin(), parameters.isoValues.end(), finite),
    "finite iso-values", "NaN or infinity", "Remove it from the list.");
  checkSampleValues(values, graph);
  require(
    parameters.polynomialDegree >= 1 && parameters.polynomialDegree <= LocalFit::MaximumDegree,
    "a polynomial degree from 1 to 4", std::to_string(parameters.polynomialDegree),
    "Choose 2 if in doubt.");
  require(parameters.scheme != Scheme::GlobalRBF,
    "one of the schemes Linear, ExplicitMLS, ParameterizedMLS, LocalRBF and Hybrid", "GlobalRBF",
    "Choose LocalRBF, or extend f to other points first.");
  require(!usesKernel(parameters) || parameters.kernel != KernelType::Harmonic,
    "a kernel that is finite at its center", nameOf(parameters.kernel),
    "Choose Cubic if in doubt.");
  checkPointCount(graph, polynomialDegree(parameters), parameters.neighborCount);
  for (const double length : { parameters.searchRadius, parameters.kernelWidth,
         parameters.linkDistance, parameters.sampleSpacing })
  {
    require(std::isfinite(length) && length >= 0.0, "lengths of 0 (automatic) or more",
      textOf(length), "Correct SearchRadius, KernelWidth, LinkDistance or SampleSpacing.");
  }
  require(parameters.tolerance > 0.0 && std::isfinite(parameters.tolerance) &&
      parameters.maximumIterations >= 1,
    "a positive finite Tolerance and at least 1 iteration",
    textOf(parameters.tolerance) + " and " + std::to_string(parameters.maximumIterations),
    "Use 1e-7 and 20 if in doubt.");
}

/// Far finer than the samples nothing is known, and memory has an end.
void checkSpacing(const NeighborGraph& graph, const ContourParameters& parameters)
{
  const double finest = 1e-3 * graph.medianSamplingStep();
  require(parameters.sampleSpacing == 0.0 || parameters.sampleSpacing >= finest,
    "a SampleSpacing of 0 or at least " + textOf(finest) + ", a thousandth of the sampling step",
    textOf(parameters.sampleSpacing), "Raise it.");
}

} // namespace

void checkContourInput(
  const NeighborGraph& graph, const ValuesRef& values, const ContourParameters& parameters)
{
  checkParameters(graph, values, parameters);
  checkSpread(graph);
  checkSpacing(graph, parameters);
}

} // namespace SurfaceScalars
