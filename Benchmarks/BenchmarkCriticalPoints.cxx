#include "Clouds.h"
#include "FilterRun.h"
#include "FuzzyCriticalPoints.h"
#include "PeakMemory.h"

#include "vtkFuzzyCriticalPoints.h"

#include <vtkNew.h>

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

/// The filter from input to output: conversion, graph and critical points.
void criticalPointsFilter(benchmark::State& state)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  runFilter(state, *filter);
}

BENCHMARK(criticalPoints)->Apply(pointsAndThreads);
BENCHMARK(criticalPointsFilter)->Apply(pointsAndThreads);

} // namespace
