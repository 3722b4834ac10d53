#include "ContourChecks.h"

#include "LocalFit.h"
#include "NumberText.h"
#include "Require.h"
#include "SchemeModels.h"

#include <Eigen/Eigenvalues>

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
  require(
    values.allFinite(), "finite values", "NaN or infinity", "Leave points without a value out.");
  require(values.size() == graph.pointCount(), "one value per point",
    std::to_string(values.size()) + " values for " + std::to_string(graph.pointCount()) + " points",
    "Leave points without a value out.");
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
  const int terms = LocalFit::termCount(polynomialDegree(parameters));
  const int fewest = terms + 1; // the point in the middle, and the sample at the rim weighs nothing
  require(static_cast<int>(graph.pointCount()) >= fewest,
    "at least " + std::to_string(fewest) + " different points with a value to fit a surface",
    std::to_string(graph.pointCount()), "Choose a larger input or a lower PolynomialDegree.");
  require(parameters.neighborCount == 0 || parameters.neighborCount >= fewest,
    "a NeighborCount of 0 (automatic) or at least " + std::to_string(fewest),
    std::to_string(parameters.neighborCount), "Raise it or lower PolynomialDegree.");
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

/// The samples must spread over a surface: on a line they determine neither normals nor curves.
/// Told by the directions to neighbors, not by the shape of the whole, which one stray point can
/// stretch.
void checkSpread(const NeighborGraph& graph)
{
  const Index stride = std::max<Index>(1, graph.pointCount() / 1000);
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  Vector3d spread = Vector3d::Zero();
  for (Index i = 0; i < graph.pointCount(); i += stride)
  {
    for (const Index neighbor : graph.neighbors(i))
    {
      const Vector3d direction =
        (graph.points().col(neighbor) - graph.points().col(i)).stableNormalized();
      directions += direction * direction.transpose();
    }
    spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(directions, Eigen::EigenvaluesOnly)
               .eigenvalues();
    if (spread[1] > 1e-2 * spread[2])
    {
      return; // mostly at the first point: no number of further directions could undo that
    }
  }
  require(spread[1] > 1e-13 * spread[2], "points spread over a surface",
    std::to_string(graph.pointCount()) + " points on one line", "Choose another input.");
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
