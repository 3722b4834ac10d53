#include "Clouds.h"
#include "LevelSets.h"
#include "PeakMemory.h"

#include "vtkPointSetContour.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <algorithm>
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
  const auto count = static_cast<int>(state.range(0));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkNew<vtkDoubleArray> height;
  height->SetName("height");
  height->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, torusCloud(count).data() + 3 * i);
    height->SetValue(i, tiltedHeight(count)[i]);
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->GetPointData()->SetScalars(height);

  const std::vector<double> isoValues = twentyIsoValues(count);
  vtkNew<vtkPointSetContour> contour;
  contour->SetInputData(cloud);
  contour->SetNumberOfContourValues(static_cast<int>(isoValues.size()));
  for (int i = 0; i < static_cast<int>(isoValues.size()); ++i)
  {
    contour->SetContourValues(i, isoValues[static_cast<std::size_t>(i)]);
  }
  vtkSMPTools::Initialize(static_cast<int>(state.range(1)));
  double peak = 0.0;
  for (auto _ : state)
  {
    contour->Modified();
    const PeakMemory memory;
    contour->Update();
    peak = std::max(peak, memory.bytes());
  }
  vtkSMPTools::Initialize();
  state.counters["peak bytes/point"] = peak / count;
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "points", "threads" })
    ->ArgsProduct({ { 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(traceTwentyIsoValues)->Apply(sizes);
BENCHMARK(wholeFilter)->Apply(sizes);

} // namespace
