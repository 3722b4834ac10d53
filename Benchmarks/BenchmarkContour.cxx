#include "Clouds.h"
#include "FilterRun.h"
#include "LevelSets.h"

#include "vtkPointSetContour.h"

#include <vtkNew.h>

#include <vector>

using namespace SurfaceScalars;

namespace
{

/// Twenty iso-values on a graph that is there already.
void traceTwentyIsoValues(benchmark::State& state)
{
  const auto count = static_cast<int>(state.range(0));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  const NeighborGraph graph(torusCloud(count), {});
  ContourParameters parameters;
  parameters.isoValues = twentyIsoValues(count);
  for (auto _ : state)
  {
    const LevelSets levelSets =
      traceLevelSets(graph, graph.average(tiltedHeight(count)), parameters, execution);
    benchmark::DoNotOptimize(levelSets.curves.data());
  }
}

/// The filter from input to output: conversion, graph and twenty iso-values.
void wholeFilter(benchmark::State& state)
{
  const std::vector<double> isoValues = twentyIsoValues(static_cast<int>(state.range(0)));
  vtkNew<vtkPointSetContour> contour;
  contour->SetNumberOfContourValues(static_cast<int>(isoValues.size()));
  for (int i = 0; i < static_cast<int>(isoValues.size()); ++i)
  {
    contour->SetContourValues(i, isoValues[static_cast<std::size_t>(i)]);
  }
  runFilter(state, *contour);
}

BENCHMARK(traceTwentyIsoValues)->Apply(pointsAndThreads);
BENCHMARK(wholeFilter)->Apply(pointsAndThreads);

} // namespace
