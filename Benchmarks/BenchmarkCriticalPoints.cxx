#include "Clouds.h"
#include "FuzzyCriticalPoints.h"
#include "PeakMemory.h"

#include <benchmark/benchmark.h>

#include <algorithm>

using namespace SurfaceScalars;

namespace
{

/// On a graph that is there already; to be compared with neighborGraph.
void criticalPoints(benchmark::State& state)
{
  const auto count = static_cast<int>(state.range(0));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  const NeighborGraph graph(torusCloud(count), {});
  const Values values = graph.average(tiltedHeight(count));
  double peak = 0.0;
  for (auto _ : state)
  {
    const PeakMemory memory;
    const FuzzyCriticalPoints found = findCriticalPoints(graph, values, {}, execution);
    benchmark::DoNotOptimize(found.points.data());
    peak = std::max(peak, memory.bytes());
  }
  state.counters["peak bytes/point"] = peak / count;
}

BENCHMARK(criticalPoints)
  ->ArgNames({ "points", "threads" })
  ->ArgsProduct({ { 100000, 1000000 }, { 1, 2 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

} // namespace
