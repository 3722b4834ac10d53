#include "PaperTables.h"

#include "MarkdownTable.h"
#include "PeerFilters.h"
#include "SimplificationCurve.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace SurfaceScalars::Benchmark
{
namespace
{

std::string text(const CriticalCounts& counts)
{
  return std::to_string(counts.minima) + " / " + std::to_string(counts.maxima) + " / " +
    std::to_string(counts.saddles);
}

CriticalCounts countsOf(const NoisyFunction& f, const Values& values)
{
  return classifyVertices(f.mesh.topology(), values).counts;
}

std::string largestDifference(const NoisyFunction& f, const Values& a, const Values& b)
{
  return number("%.3f", (a - b).cwiseAbs().maxCoeff() / f.range);
}

std::string meanDifference(const NoisyFunction& f, const Values& a, const Values& b)
{
  return number("%.4f", (a - b).norm() / std::sqrt(static_cast<double>(a.size())) / f.range);
}

SmoothingParameters parametersOf(SmoothingMethod method)
{
  SmoothingParameters parameters;
  parameters.method = method;
  return parameters;
}

SmoothingParameters withEpsilon(SmoothingMethod method, double epsilon)
{
  SmoothingParameters parameters = parametersOf(method);
  parameters.epsilonChoice = EpsilonChoice::Manual;
  parameters.epsilon = epsilon;
  return parameters;
}

/// The paper's epsilon of (7), L^T L + epsilon Delta, for vertices of equal area.
double fromPaper(double epsilon, const NoisyFunction& f)
{
  return epsilon * std::pow(static_cast<double>(f.clean.size()), 2.0);
}

/// Of f along an edge, a fraction of f's range: the unit of the paper's delta.
double largestStep(const NoisyFunction& f)
{
  double largest = 0.0;
  for (Index vertex = 0; vertex < f.mesh.topology().vertexCount(); ++vertex)
  {
    for (const Index neighbor : f.mesh.topology().link(vertex))
    {
      largest = std::max(largest, f.noisy[neighbor] - f.noisy[vertex]);
    }
  }
  return largest / (f.noisy.maxCoeff() - f.noisy.minCoeff());
}

/// A row of a table: who, counts, distances from f and from the function without noise.
std::vector<std::string> comparison(
  const std::string& what, const NoisyFunction& f, const Values& values)
{
  return { what, text(countsOf(f, values)), largestDifference(f, values, f.noisy),
    largestDifference(f, values, f.clean), meanDifference(f, values, f.clean) };
}

const std::vector<std::string> ComparisonHead = { "", "m / M / s", "L-infinity to f",
  "L-infinity to the function without noise", "L2 to it" };

} // namespace

void tabulateSimplification(const PaperMeshes& meshes)
{
  const NoisyFunction& f = meshes.elephant;
  const MeshTopology& topology = f.mesh.topology();
  const SimplificationCurve curve =
    simplificationCurve(meshCriticalPoints(f.mesh.vertices(), topology, f.noisy),
      deltaThresholds(topology, f.noisy, classifyVertices(topology, f.noisy)),
      f.noisy.maxCoeff() - f.noisy.minCoeff(),
      { 0.0, 0.001, 0.005, 0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.5 });
  writeHead("Fig. 2, 3: counts against thresholds, " + f.name,
    { "threshold, of f's range", "m / M / s with delta", "with persistence" });
  for (std::size_t i = 0; i < curve.thresholds.size(); ++i)
  {
    writeRow(
      { number("%g", curve.thresholds[i]), text(curve.byDelta[i]), text(curve.byPersistence[i]) });
  }
}

void tabulateTikhonov(const PaperMeshes& meshes)
{
  for (const NoisyFunction* f : { &meshes.elephant, &meshes.turbine })
  {
    writeHead("Fig. 4, 5: smoothing, " + f->name, ComparisonHead);
    writeRow(comparison("without noise", *f, f->clean));
    writeRow(comparison("f", *f, f->noisy));
    for (const auto& [choice, name] : { std::pair(EpsilonChoice::GCV, "Tikhonov, GCV"),
           std::pair(EpsilonChoice::LCurve, "Tikhonov, L-curve") })
    {
      SmoothingParameters parameters = parametersOf(SmoothingMethod::Tikhonov);
      parameters.epsilonChoice = choice;
      writeRow(comparison(name, *f, smoothFunction(f->mesh, f->noisy, parameters).values));
    }
    SmoothingParameters parameters = parametersOf(SmoothingMethod::FeaturePreserving);
    parameters.persistenceThreshold = 0.02;
    writeRow(comparison("FeaturePreserving, persistence 0.02", *f,
      smoothFunction(f->mesh, f->noisy, parameters).values));
  }
}

void tabulateMetrics(const PaperMeshes& meshes)
{
  const NoisyFunction& f = meshes.irregularTorus;
  writeHead("Fig. 6, 7, 8: the metric of the data, " + f.name, ComparisonHead);
  writeRow(comparison("without noise", f, f.clean));
  writeRow(comparison("f", f, f.noisy));
  for (const auto& [metric, name] :
    { std::pair(DataMetric::Identity, "Identity"), std::pair(DataMetric::MassMatrix, "MassMatrix"),
      std::pair(DataMetric::LumpedMass, "LumpedMass") })
  {
    SmoothingParameters parameters = parametersOf(SmoothingMethod::Tikhonov);
    parameters.norms.metric = metric;
    writeRow(comparison(name, f, smoothFunction(f.mesh, f.noisy, parameters).values));
  }
}

void tabulateConstraints(const PaperMeshes& meshes)
{
  const NoisyFunction& f = meshes.elephant;
  writeHead("Fig. 13, Table 1: all critical points and their stars by least squares, " + f.name,
    ComparisonHead);
  writeRow(comparison("f", f, f.noisy));
  for (const double epsilon : { 0.01, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, 0.08, 0.09, 1.0 })
  {
    SmoothingParameters parameters =
      withEpsilon(SmoothingMethod::LeastSquaresConstraints, fromPaper(epsilon, f));
    parameters.constraints = ConstraintChoice::AllCriticalPoints;
    parameters.smoothedStars = false;
    writeRow(comparison("the paper's epsilon " + number("%g", epsilon), f,
      smoothFunction(f.mesh, f.noisy, parameters).values));
  }

  writeHead(
    "Fig. 11, 12, 14: constraints at persistent critical points, " + f.name, ComparisonHead);
  for (const auto& [method, name] :
    { std::pair(SmoothingMethod::InterpolatingConstraints, "interpolating"),
      std::pair(SmoothingMethod::LeastSquaresConstraints, "least squares"),
      std::pair(SmoothingMethod::FeaturePreserving, "FeaturePreserving") })
  {
    for (const bool smoothed : { false, true })
    {
      for (const auto& [energy, kind] : { std::pair(SmoothingEnergy::Harmonic, "harmonic"),
             std::pair(SmoothingEnergy::Biharmonic, "biharmonic") })
      {
        SmoothingParameters parameters = parametersOf(method);
        parameters.persistenceThreshold = 0.3;
        parameters.smoothedStars = smoothed;
        parameters.norms.energy = energy;
        writeRow(comparison(std::string(name) + ", " + kind + (smoothed ? ", smoothed stars" : ""),
          f, smoothFunction(f.mesh, f.noisy, parameters).values));
      }
    }
  }
}

void tabulateEpsilons(const PaperMeshes& meshes)
{
  const NoisyFunction& f = meshes.turbine;
  writeHead("Fig. 9, 10, 15: m / M / s and L-infinity to f against epsilon, " + f.name,
    { "epsilon", "Tikhonov", "L-infinity", "semi-norm", "least squares, all critical points",
      "least squares, delta 0.2" });
  for (double exponent = 2.0; exponent <= 9.0; exponent += 1.0)
  {
    const double epsilon = std::pow(10.0, exponent);
    const SmoothedFunction smooth =
      smoothFunction(f.mesh, f.noisy, withEpsilon(SmoothingMethod::Tikhonov, epsilon));
    SmoothingParameters all = withEpsilon(SmoothingMethod::LeastSquaresConstraints, epsilon);
    all.constraints = ConstraintChoice::AllCriticalPoints;
    SmoothingParameters some = all;
    some.constraints = ConstraintChoice::DeltaSimplified;
    some.delta = 0.2 * largestStep(f);
    writeRow({ number("%.0e", epsilon), text(smooth.outputCounts),
      largestDifference(f, smooth.values, f.noisy), number("%.3g", smooth.seminorm),
      text(smoothFunction(f.mesh, f.noisy, all).outputCounts),
      text(smoothFunction(f.mesh, f.noisy, some).outputCounts) });
  }
}

void tabulatePeers(const PaperMeshes& meshes)
{
  for (const NoisyFunction* f : { &meshes.elephant, &meshes.irregularTorus })
  {
    writeHead("Fig. 16: other filters, " + f->name, ComparisonHead);
    writeRow(comparison("f", *f, f->noisy));
    SmoothingParameters parameters = parametersOf(SmoothingMethod::Tikhonov);
    parameters.norms.metric = DataMetric::MassMatrix;
    writeRow(comparison(
      "Tikhonov, MassMatrix, GCV", *f, smoothFunction(f->mesh, f->noisy, parameters).values));

    const Laplacian laplacian = meshLaplacian(
      f->mesh.vertices(), f->mesh.topology().triangles(), LaplacianWeights::Cotangent);
    for (const int passPairs : { 10, 50, 250 })
    {
      writeRow(comparison("low-pass [24], " + std::to_string(passPairs) + " pairs of passes", *f,
        lowPass(laplacian, f->noisy, passPairs, 0.33)));
    }
    const double step =
      std::sqrt(laplacian.mass.sum() / static_cast<double>(laplacian.mass.size()));
    for (const int steps : { 1, 5, 20 })
    {
      SalientParameters salient{ 2.5 * step, step * step, std::pow(0.1 * f->range, 2.0), steps };
      writeRow(comparison("salient [15], " + std::to_string(steps) + " steps", *f,
        salientSmoothing(f->mesh.vertices(), f->mesh.topology(), f->noisy, salient)));
    }
  }
}

} // namespace SurfaceScalars::Benchmark
