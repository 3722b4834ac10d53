#include "PaperTables.h"

#include "MarkdownTable.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <vector>

namespace SurfaceScalars::Benchmark
{
namespace
{

double secondsOf(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Seconds of each method of Table 2, on a mesh made anew for each.
std::vector<double> measure(int halvings)
{
  std::vector<double> seconds;
  const auto run = [&](SmoothingMethod method, DataMetric metric)
  {
    const NoisyFunction f = noisySphere(halvings, 0.05);
    SmoothingParameters parameters;
    parameters.method = method;
    parameters.norms.metric = metric;
    parameters.epsilonChoice = EpsilonChoice::Manual;
    parameters.persistenceThreshold = 0.3;
    seconds.push_back(secondsOf([&] { smoothFunction(f.mesh, f.noisy, parameters); }));
  };
  const NoisyFunction f = noisySphere(halvings, 0.05);
  seconds.push_back(secondsOf(
    [&]
    {
      const VertexTypes types = classifyVertices(f.mesh.topology(), f.noisy);
      deltaThresholds(f.mesh.topology(), f.noisy, types);
    }));
  run(SmoothingMethod::Tikhonov, DataMetric::LumpedMass);
  run(SmoothingMethod::Tikhonov, DataMetric::MassMatrix);
  run(SmoothingMethod::InterpolatingConstraints, DataMetric::Identity);
  run(SmoothingMethod::LeastSquaresConstraints, DataMetric::Identity);
  run(SmoothingMethod::FeaturePreserving, DataMetric::Identity);
  return seconds;
}

} // namespace

void tabulateGrowth()
{
  const std::vector<std::string> methods = { "critical points, delta thresholds",
    "Tikhonov, lumped masses", "Tikhonov, mass matrix", "interpolating constraints",
    "least squares", "FeaturePreserving" };
  writeHead("Table 2: time on a sphere, seconds, and its growth, time ~ n^p between the last two",
    { "", "16,386 vertices", "65,538", "262,146", "p" });
  std::vector<std::vector<double>> seconds;
  for (const int halvings : { 6, 7, 8 })
  {
    seconds.push_back(measure(halvings));
  }
  for (std::size_t method = 0; method < methods.size(); ++method)
  {
    std::vector<std::string> cells = { methods[method] };
    for (const std::vector<double>& ofSize : seconds)
    {
      cells.push_back(number("%.3f", ofSize[method]));
    }
    cells.push_back(
      number("%.2f", std::log(seconds[2][method] / seconds[1][method]) / std::log(4.0)));
    writeRow(cells);
  }
}

} // namespace SurfaceScalars::Benchmark
