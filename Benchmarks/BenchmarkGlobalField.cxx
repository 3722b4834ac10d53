#include "Clouds.h"
#include "Field.h"

#include <benchmark/benchmark.h>

using namespace SurfaceScalars;

namespace
{

FieldParameters globalParameters(const benchmark::State& state)
{
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  parameters.kernel = static_cast<KernelType>(state.range(1));
  if (parameters.kernel == KernelType::Wendland)
  {
    parameters.kernelWidth = 0.06; // some 70 neighbors; an automatic width follows the values
  }
  return parameters;
}

/// All that a first function needs: sorting, the width, the system, its coefficients.
void globalFirstStep(benchmark::State& state)
{
  const auto count = static_cast<int>(state.range(0));
  for (auto _ : state)
  {
    const Field field =
      Field::fit(torusCloud(count), tiltedHeight(count).array().sin(), globalParameters(state));
    benchmark::DoNotOptimize(field.model().coefficients.data());
  }
}

/// Another function on the same points.
void globalSecondStep(benchmark::State& state)
{
  const auto count = static_cast<int>(state.range(0));
  const Values second = tiltedHeight(count).array().cos();
  const Field first =
    Field::fit(torusCloud(count), tiltedHeight(count).array().sin(), globalParameters(state));
  for (auto _ : state)
  {
    const Field field = first.withValues(second);
    benchmark::DoNotOptimize(field.model().coefficients.data());
  }
}

/// Dense and sparse.
void systems(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "points", "kernel" })
    ->Args({ 2000, static_cast<int>(KernelType::Cubic) })
    ->Args({ 100000, static_cast<int>(KernelType::Wendland) })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(globalFirstStep)->Apply(systems);
BENCHMARK(globalSecondStep)->Apply(systems);

} // namespace
