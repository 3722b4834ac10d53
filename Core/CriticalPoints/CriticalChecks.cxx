#include "CriticalChecks.h"

#include "LocalFit.h"
#include "NumberText.h"
#include "Require.h"
#include "SampleChecks.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

void checkScheme(const CriticalPointParameters& parameters)
{
  const Scheme scheme = parameters.scheme;
  require(scheme == Scheme::ExplicitMLS || scheme == Scheme::ParameterizedMLS ||
      scheme == Scheme::LocalRBF || scheme == Scheme::Hybrid,
    "one of the schemes ExplicitMLS, ParameterizedMLS, LocalRBF and Hybrid",
    scheme == Scheme::Linear        ? "Linear"
      : scheme == Scheme::GlobalRBF ? "GlobalRBF"
                                    : "number " + std::to_string(static_cast<int>(scheme)),
    "Choose ParameterizedMLS if in doubt.");
  const bool usesKernel = scheme == Scheme::LocalRBF || scheme == Scheme::Hybrid;
  require(!usesKernel || parameters.kernel != KernelType::Harmonic,
    "a kernel that is finite at its center", nameOf(parameters.kernel),
    "Choose Cubic if in doubt.");
}

void checkNumbers(const CriticalPointParameters& parameters)
{
  const int degree = parameters.polynomialDegree;
  require(degree >= 1 && degree <= LocalFit::MaximumDegree, "a polynomial degree from 1 to 4",
    std::to_string(degree), "Choose 2 if in doubt.");
  for (const double length : { parameters.searchRadius, parameters.kernelWidth })
  {
    require(std::isfinite(length) && length >= 0.0, "lengths of 0 (automatic) or more",
      textOf(length), "Correct SearchRadius or KernelWidth.");
  }
  for (const double fraction : { parameters.probabilityThreshold, parameters.persistenceThreshold })
  {
    require(fraction >= 0.0 && fraction <= 1.0, "thresholds from 0 to 1", textOf(fraction),
      "Correct ProbabilityThreshold or PersistenceThreshold.");
  }
}

} // namespace

void checkCriticalInput(
  const NeighborGraph& graph, const ValuesRef& values, const CriticalPointParameters& parameters)
{
  checkScheme(parameters);
  checkNumbers(parameters);
  const bool needsFunction = parameters.probabilityModel == ProbabilityModel::NormalAngle;
  require(!needsFunction || static_cast<bool>(parameters.volumeFunction),
    "a VolumeFunction for the probability model NormalAngle", "none",
    "Set the implicit function that the values sample, or choose Gradient.");
  checkSampleValues(values, graph);
  checkPointCount(graph, std::max(2, parameters.polynomialDegree), parameters.neighborCount);
  checkSpread(graph);
}

} // namespace SurfaceScalars
