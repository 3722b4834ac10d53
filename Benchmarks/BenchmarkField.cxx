#include "Clouds.h"
#include "Field.h"
#include "NeighborGraph.h"

#include <vtkDoubleArray.h>
#include <vtkGaussianKernel.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointInterpolator.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <benchmark/benchmark.h>

#include <cmath>

using namespace SurfaceScalars;

namespace
{

/// As many places on the torus that are no samples.
Points targetsBeside(int count)
{
  return torusCloud(2 * count).rightCols(count);
}

/// From samples to values at as many targets, everything included. Beside it in the same run:
/// neighborGraph.
void extend(benchmark::State& state, const FieldParameters& parameters)
{
  const auto count = static_cast<int>(state.range(0));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  const Points targets = targetsBeside(count);
  for (auto _ : state)
  {
    const Field field = Field::fit(torusCloud(count), tiltedHeight(count), parameters, execution);
    const FieldValues values = field.evaluate(targets, {}, execution);
    benchmark::DoNotOptimize(values.values.data());
  }
  state.SetItemsProcessed(state.iterations() * targets.cols());
}

FieldParameters usual(Scheme scheme)
{
  FieldParameters parameters;
  parameters.scheme = scheme;
  return parameters;
}

/// A radius that about twenty samples are within.
double sharedRadius(int count)
{
  constexpr double Area = 4.0 * Pi * Pi * 0.4;
  return std::sqrt(20.0 * Area / (Pi * count));
}

constexpr double Sharpness = 2.0; // radius / kernel width

void averageWithin(benchmark::State& state)
{
  FieldParameters parameters = usual(Scheme::ExplicitMLS);
  parameters.searchRadius = sharedRadius(static_cast<int>(state.range(0)));
  parameters.kernelWidth = parameters.searchRadius / Sharpness;
  extend(state, parameters);
}

vtkNew<vtkPolyData> polyDataOf(const Points& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(points.cols());
  for (vtkIdType i = 0; i < points.cols(); ++i)
  {
    places->SetPoint(i, points.data() + 3 * i);
  }
  vtkNew<vtkPolyData> result;
  result->SetPoints(places);
  return result;
}

/// The same averages by others.
void vtkInterpolatorWithin(benchmark::State& state)
{
  const auto count = static_cast<int>(state.range(0));
  const auto samples = polyDataOf(torusCloud(count));
  const auto targets = polyDataOf(targetsBeside(count));
  vtkNew<vtkDoubleArray> height;
  height->SetName("height");
  height->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    height->SetValue(i, tiltedHeight(count)[i]);
  }
  samples->GetPointData()->SetScalars(height);
  vtkNew<vtkGaussianKernel> kernel;
  kernel->SetRadius(sharedRadius(count));
  kernel->SetSharpness(Sharpness);
  vtkNew<vtkPointInterpolator> interpolator;
  interpolator->SetInputData(targets);
  interpolator->SetSourceData(samples);
  interpolator->SetKernel(kernel);
  vtkSMPTools::Initialize(static_cast<int>(state.range(1)));
  for (auto _ : state)
  {
    interpolator->Modified();
    interpolator->Update();
  }
  vtkSMPTools::Initialize();
  state.SetItemsProcessed(state.iterations() * count);
}

/// Places for which the samples are there already: queries per second.
void query(benchmark::State& state, Scheme scheme)
{
  const auto count = static_cast<int>(state.range(0));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  FieldParameters parameters = usual(scheme);
  parameters.neighborCount = 32;
  const Field field = Field::fit(torusCloud(count), tiltedHeight(count), parameters, execution);
  const Points targets = targetsBeside(count).leftCols(100000);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(field.evaluate(targets, {}, execution).values.data());
  }
  state.SetItemsProcessed(state.iterations() * targets.cols());
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "points", "threads" })
    ->ArgsProduct({ { 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK_CAPTURE(extend, ExplicitMLS, usual(Scheme::ExplicitMLS))->Apply(sizes);
BENCHMARK_CAPTURE(extend, ParameterizedMLS, usual(Scheme::ParameterizedMLS))->Apply(sizes);
BENCHMARK_CAPTURE(query, LocalRBF, Scheme::LocalRBF)->Apply(sizes);
BENCHMARK(averageWithin)->Apply(sizes);
BENCHMARK(vtkInterpolatorWithin)->Apply(sizes);

} // namespace
