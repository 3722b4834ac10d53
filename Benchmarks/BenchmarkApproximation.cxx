#include "MeshlessApproximation.h"
#include "TorusMesh.h"

#include <benchmark/benchmark.h>

#include <cmath>

using namespace SurfaceScalars;

namespace
{

Values waves(const Points& points)
{
  return ((5.0 * points.row(0)).array().sin() * (4.0 * points.row(1)).array().cos() +
    0.3 * points.row(2).array())
    .transpose();
}

/// Critical points, their persistence, centers, coefficients, u at all vertices and its critical
/// points. The counter `paper` has the seconds of the paper's Table 1 for as many vertices.
void approximate(benchmark::State& state, CenterSelection selection)
{
  const TorusMesh torus = torusMesh(static_cast<int>(state.range(0)));
  const MeshTopology topology(static_cast<Index>(torus.vertices.cols()), torus.triangles);
  const Values values = waves(torus.vertices);
  ApproximationParameters parameters;
  parameters.centerSelection = selection;
  parameters.persistenceThreshold = 0.01;
  const Execution execution{ static_cast<int>(state.range(2)), {} };
  for (auto _ : state)
  {
    const MeshlessApproximation result =
      approximateMeshless(surfaceDomain(torus.vertices, topology), values, parameters, execution);
    state.counters["centers"] = static_cast<double>(result.model.centers.cols());
    state.counters["error"] = result.largestError / (values.maxCoeff() - values.minCoeff());
    state.counters["lost"] = static_cast<double>(result.lost.size());
  }
  state.counters["vertices"] = static_cast<double>(values.size());
  state.counters["paper"] = 0.01 * static_cast<double>(state.range(1));
}

void greedy(benchmark::State& state)
{
  approximate(state, CenterSelection::Greedy);
}

void levelSets(benchmark::State& state)
{
  approximate(state, CenterSelection::LevelSets);
}

/// 3,042 to 2,798,978 vertices; 1% of them, at most 6000, are centers beside the stars.
void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "around", "paper10ms", "threads" })
    ->Args({ 78, 8, 2 })
    ->Args({ 174, 57, 2 })
    ->Args({ 346, 212, 2 })
    ->Args({ 400, 317, 2 })
    ->Args({ 490, 534, 1 })
    ->Args({ 490, 534, 2 })
    ->Args({ 1000, 1721, 2 })
    ->Args({ 2366, 14535, 2 })
    ->Unit(benchmark::kSecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime()
    ->Iterations(1);
}

BENCHMARK(greedy)->Apply(sizes);
BENCHMARK(levelSets)->Apply(sizes);

} // namespace
