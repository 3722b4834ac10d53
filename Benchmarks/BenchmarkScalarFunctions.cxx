#include "Clouds.h"
#include "GeodesicDistance.h"
#include "LaplacianFunctions.h"
#include "PeakMemory.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>

using namespace SurfaceScalars;

namespace
{

/// Work on a graph that is there already, to be compared with neighborGraph; the memory is that of
/// the graph as well.
void measure(benchmark::State& state,
  const std::function<void(const NeighborGraph& graph, const Execution& execution)>& work)
{
  const Points& cloud = torusCloud(static_cast<int>(state.range(0)));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  double peak = 0.0;
  for (auto _ : state)
  {
    state.PauseTiming();
    const PeakMemory memory;
    const NeighborGraph graph(cloud, {}, execution);
    state.ResumeTiming();
    work(graph, execution);
    peak = std::max(peak, memory.bytes());
  }
  state.counters["peak bytes/point"] = peak / static_cast<double>(cloud.cols());
}

void geodesic(benchmark::State& state)
{
  measure(state,
    [](const NeighborGraph& graph, const Execution& execution)
    {
      const Values distances = geodesicDistance(graph, { graph.pointOfInput(0) }, execution);
      benchmark::DoNotOptimize(distances.data());
    });
}

/// Laplacian and solution; two points are given, which is harder than many.
void harmonic(benchmark::State& state)
{
  measure(state,
    [](const NeighborGraph& graph, const Execution& execution)
    {
      const Laplacian laplacian =
        pointSetLaplacian(graph, LaplacianWeights::LocalScale, 0.0, execution);
      const Values function = harmonicFunction(
        laplacian, { { graph.pointOfInput(0), 0.0 }, { graph.pointOfInput(1), 1.0 } }, execution);
      benchmark::DoNotOptimize(function.data());
    });
}

/// Laplacian and eigenfunctions.
void sixteenEigenfunctions(benchmark::State& state)
{
  measure(state,
    [](const NeighborGraph& graph, const Execution& execution)
    {
      const Laplacian laplacian =
        pointSetLaplacian(graph, LaplacianWeights::LocalScale, 0.0, execution);
      const Eigenfunctions eigenfunctions = laplacianEigenfunctions(laplacian, 16, execution);
      benchmark::DoNotOptimize(eigenfunctions.functions.data());
    });
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "points", "threads" })
    ->ArgsProduct({ { 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(geodesic)->Apply(sizes);
BENCHMARK(harmonic)->Apply(sizes);
BENCHMARK(sixteenEigenfunctions)
  ->ArgNames({ "points", "threads" })
  ->ArgsProduct({ { 100000 }, { 1, 2 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

} // namespace
