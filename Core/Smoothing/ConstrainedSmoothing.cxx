#include "ConstrainedSmoothing.h"

#include "ConstrainedFunction.h"
#include "ExtremumPlacing.h"
#include "MeshValues.h"
#include "NumberText.h"
#include "Quantile.h"
#include "Require.h"
#include "SmoothingFeatures.h"
#include "TopologicalSimplification.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr double PlacingLength = 1.5; // in smoothing lengths
constexpr double PlacingNoise = 4.0;  // standard deviations: about three of a difference
constexpr double Improbable = 0.01;   // that any of n normal errors is beyond what noise explains
constexpr double DeviationPerMedian = 1.4826; // of the magnitudes of normal errors

void checkFraction(double fraction, const std::string& name)
{
  require(fraction >= 0.0 && fraction <= 1.0,
    name + " between 0 and 1, a fraction of the range of the values", textOf(fraction),
    "Lower or raise it.");
}

void checkMask(const std::vector<char>& mask, Index vertexCount)
{
  require(mask.size() == vertexCount, "one number per vertex to say which to keep",
    std::to_string(mask.size()) + " for " + std::to_string(vertexCount) + " vertices",
    "Choose another ConstraintArray.");
  require(std::any_of(mask.begin(), mask.end(), [](char mark) { return mark != 0; }),
    "at least 1 vertex that is not 0 in ConstraintArray", "none",
    "Mark vertices, or choose other Constraints.");
}

void checkInput(
  const SmoothingMesh& mesh, const ValuesRef& values, const SmoothingParameters& parameters)
{
  const Index count = mesh.topology().vertexCount();
  checkVertexValues(count, values, mesh.nameOf());
  checkValueRange(values);
  checkFraction(parameters.persistenceThreshold, "PersistenceThreshold");
  checkFraction(parameters.delta, "Delta");
  require(parameters.epsilonChoice != EpsilonChoice::Manual ||
      (parameters.epsilon > 0.0 && std::isfinite(parameters.epsilon)),
    "Epsilon above 0", textOf(parameters.epsilon), "Raise it.");
  if (parameters.constraints == ConstraintChoice::MaskArray &&
    parameters.method != SmoothingMethod::Tikhonov)
  {
    checkMask(parameters.mask, count);
  }
}

/// Whether Tikhonov's function is needed.
bool needSmooth(const SmoothingParameters& parameters)
{
  return parameters.method == SmoothingMethod::FeaturePreserving ||
    parameters.method == SmoothingMethod::Tikhonov ||
    (parameters.smoothedStars &&
      (parameters.includeOneStars || parameters.constraints == ConstraintChoice::Persistent));
}

/// Epsilon, and the curve it is chosen from.
void findEpsilon(SmoothedFunction& result, const SmoothingMesh& mesh, const ValuesRef& values,
  const SmoothingParameters& parameters, const Execution& execution)
{
  result.epsilon = parameters.epsilon;
  if (parameters.epsilonChoice != EpsilonChoice::Manual)
  {
    result.curve = mesh.curve(parameters.norms, values, parameters.epsilonChoice, execution);
    result.epsilon = chooseEpsilon(result.curve, parameters.epsilonChoice);
  }
}

/// The standard deviation of errors that are independent from vertex to vertex, by the median of
/// what neighbors do not predict: neither spikes nor smooth functions count.
double noiseOf(const MeshTopology& mesh, const ValuesRef& values)
{
  return DeviationPerMedian *
    medianOfSome(mesh.vertexCount(),
      [&](std::size_t i)
      {
        const VertexRange link = mesh.link(static_cast<Index>(i));
        double sum = 0.0;
        for (const Index neighbor : link)
        {
          sum += values[neighbor];
        }
        const double count = static_cast<double>(link.size());
        return std::abs(values[static_cast<Eigen::Index>(i)] - sum / count) /
          std::sqrt(1.0 + 1.0 / count);
      });
}

/// What such errors change of persistences, at most.
double persistenceOfNoise(const MeshTopology& mesh, const ValuesRef& values)
{
  const auto count = static_cast<double>(mesh.vertexCount());
  return 2.0 * noiseOf(mesh, values) * std::sqrt(2.0 * std::log(2.0 * count / Improbable));
}

double areaOf(const SmoothingMesh& mesh)
{
  const Triangles& triangles = mesh.topology().triangles();
  const Points& vertices = mesh.vertices();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < triangles.cols(); ++i)
  {
    const Vector3d corner = vertices.col(triangles(0, i));
    const Vector3d a = vertices.col(triangles(1, i)) - corner;
    const Vector3d b = vertices.col(triangles(2, i)) - corner;
    sum += 0.5 * a.cross(b).norm();
  }
  return sum;
}

/// The extrema that are to be kept, placed by further smoothing and fits as far as the noise that
/// is left allows.
ExtremalVertices placedFeatures(const SmoothingData& data, const SmoothingParameters& parameters,
  double epsilon, const Execution& execution)
{
  const MeshTopology& topology = data.mesh.topology();
  const TikhonovSmoother& smoother = data.mesh.smoother(parameters.norms);
  const double length = smoother.smoothingLength(epsilon);
  const ExtremalVertices kept = extremaToKeep(data, parameters, execution.part(0.0, 0.3));
  const Values further = smoother.smooth(
    data.input, smoother.epsilonOfLength(PlacingLength * length), execution.part(0.3, 0.8));
  // The integral of the squared gain over all frequencies: a sixteenth of the vertices per length.
  const double perLength = std::sqrt(smoother.area() / topology.vertexCount()) / length;
  const double noise = noiseOf(topology, data.input);
  const double left = noise * std::min(1.0, perLength / 4.0);
  // The smoother measures areas as its weights do.
  const double unit = std::sqrt(areaOf(data.mesh) / smoother.area());
  return placed({ topology, data.mesh.vertices(), data.input, data.smooth, unit * length, noise },
    kept, further, PlacingNoise * left, execution.part(0.8, 1.0));
}

/// What is left of f, and which extrema it is promised to have.
Values smoothed(SmoothingData& data, const SmoothingParameters& parameters, double epsilon,
  const Execution& execution)
{
  const auto laplacian = data.mesh.laplacian(parameters.norms.weights);
  const SmoothingEnergy energy = parameters.norms.energy;
  switch (parameters.method)
  {
    case SmoothingMethod::Tikhonov:
      return data.smooth;
    case SmoothingMethod::InterpolatingConstraints:
      return interpolateConstraints(*laplacian, energy,
        constraintsOf(data, parameters, execution.part(0.0, 0.2)), execution.part(0.2, 1.0),
        data.mesh.nameOf());
    case SmoothingMethod::LeastSquaresConstraints:
      return fitConstraints(laplacian, energy,
        constraintsOf(data, parameters, execution.part(0.0, 0.2)), epsilon,
        execution.part(0.2, 1.0), data.mesh.nameOf());
    case SmoothingMethod::FeaturePreserving:
      data.asked = askedOfInput(data, parameters, execution.part(0.0, 0.1));
      data.promised = placedFeatures(data, parameters, epsilon, execution.part(0.1, 0.5));
      return keepExtrema(data.mesh.topology(), data.smooth, data.promised.minima,
        data.promised.maxima, execution.part(0.5, 1.0), data.mesh.nameOf());
  }
  throw InvalidInput("a method from 0 to 3", std::to_string(static_cast<int>(parameters.method)),
    "Choose one of these.");
}

/// The persistence above which extrema of f are missed if they have no counterpart: all that are
/// marked; of others those that noise does not explain.
double missedPersistence(const SmoothingData& data, const SmoothingParameters& parameters)
{
  if (parameters.constraints == ConstraintChoice::MaskArray)
  {
    return 0.0;
  }
  const double chosen = parameters.constraints == ConstraintChoice::Persistent
    ? parameters.persistenceThreshold * data.range
    : 0.0;
  return chosen + persistenceOfNoise(data.mesh.topology(), data.input);
}

/// The chosen extrema of f without a counterpart, and what was promised and is not there.
std::vector<Index> lostExtrema(const SmoothingData& data, const SmoothingParameters& parameters,
  const ExtremalVertices& found, const Execution& execution)
{
  std::vector<Index> lost = unmatchedExtrema(data.mesh.topology(), data.input, found,
    missedPersistence(data, parameters), data.asked, execution);
  const auto addMissing = [&](const std::vector<Index>& promised, const std::vector<Index>& there)
  {
    std::set_difference(
      promised.begin(), promised.end(), there.begin(), there.end(), std::back_inserter(lost));
  };
  addMissing(data.promised.minima, found.minima);
  addMissing(data.promised.maxima, found.maxima);
  return lost;
}

} // namespace

SmoothedFunction smoothFunction(const SmoothingMesh& mesh, const ValuesRef& values,
  const SmoothingParameters& parameters, const Execution& execution)
{
  checkInput(mesh, values, parameters);
  const MeshTopology& topology = mesh.topology();
  SmoothedFunction result;
  result.values = values;
  result.inputCounts = classifyVertices(topology, values, execution.part(0.0, 0.02)).counts;
  SmoothingData data{ mesh, values, {}, {}, values.maxCoeff() - values.minCoeff(), {} };
  if (data.range > 0.0)
  {
    const TikhonovSmoother& smoother = mesh.smoother(parameters.norms, execution.part(0.02, 0.05));
    if (needSmooth(parameters) || parameters.method == SmoothingMethod::LeastSquaresConstraints)
    {
      findEpsilon(result, mesh, values, parameters, execution.part(0.05, 0.75));
    }
    if (needSmooth(parameters))
    {
      data.smooth = smoother.smooth(values, result.epsilon, execution.part(0.75, 0.8));
    }
    result.values = smoothed(data, parameters, result.epsilon, execution.part(0.8, 0.9));
    result.largestError = (result.values - values).lpNorm<Eigen::Infinity>();
    result.seminorm = std::sqrt(smoother.energy(result.values));
  }
  result.critical =
    meshCriticalPoints(mesh.vertices(), topology, result.values, execution.part(0.9, 0.95));
  result.outputCounts = countsOf(result.critical.points);
  if (parameters.method == SmoothingMethod::FeaturePreserving && data.range > 0.0)
  {
    result.lost =
      lostExtrema(data, parameters, extremaOf(result.critical.points), execution.part(0.95, 1.0));
  }
  execution.report(1.0);
  return result;
}

} // namespace SurfaceScalars
