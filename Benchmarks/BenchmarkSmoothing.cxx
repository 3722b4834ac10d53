#include "ParameterCurve.h"
#include "PeakMemory.h"
#include "RowScaling.h"
#include "Tikhonov.h"
#include "TorusMesh.h"

#include <benchmark/benchmark.h>

#include <Eigen/SparseCholesky>
#ifdef SURFACE_SCALARS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

using namespace SurfaceScalars;

namespace
{

constexpr double Epsilon = 1e5;

/// A height with noise on a triangulated torus, R = 1, r = 0.4.
struct Input
{
  std::shared_ptr<const Laplacian> laplacian;
  Eigen::SparseMatrix<double> metric;
  Values values;
};

Input makeInput(int around)
{
  const auto [vertices, triangles] = torusMesh(around);
  Input result;
  result.laplacian =
    std::make_shared<Laplacian>(meshLaplacian(vertices, triangles, LaplacianWeights::Cotangent));
  result.metric = metricMatrix(DataMetric::Identity, *result.laplacian, vertices, triangles);
  result.values = vertices.row(0);
  for (Eigen::Index i = 0; i < result.values.size(); ++i)
  {
    const double hash = 1e4 * std::sin(12.9898 * static_cast<double>(i)); // as good as random
    result.values[i] += 0.2 * (hash - std::floor(hash) - 0.5);
  }
  return result;
}

const Input& input(int around)
{
  static std::map<int, Input> made;
  auto found = made.find(around);
  if (found == made.end())
  {
    found = made.emplace(around, makeInput(around)).first;
  }
  return found->second;
}

/// S A^-1 S + t W
Eigen::SparseMatrix<double> assembled(const Input& input)
{
  const Laplacian& laplacian = *input.laplacian;
  const double weight = Epsilon / std::pow(laplacian.mass.sum(), 2);
  const Eigen::SparseMatrix<double> scaled =
    scaleRows(laplacian.stiffness, laplacian.mass.cwiseInverse());
  return Eigen::SparseMatrix<double>(laplacian.stiffness * scaled) + weight * input.metric;
}

/// Normwise: ||K x - b|| / (||K|| ||x|| + ||b||), norms of the largest component.
double backwardError(const Input& input, const Values& x)
{
  const Eigen::SparseMatrix<double> matrix = assembled(input);
  const double weight = Epsilon / std::pow(input.laplacian->mass.sum(), 2);
  const Values right = weight * (input.metric * input.values);
  const double norm = (matrix.cwiseAbs() * Values::Ones(x.size())).maxCoeff();
  return (matrix * x - right).lpNorm<Eigen::Infinity>() /
    (norm * x.lpNorm<Eigen::Infinity>() + right.lpNorm<Eigen::Infinity>());
}

void tikhonov(benchmark::State& state)
{
  const Input& data = input(static_cast<int>(state.range(0)));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  Values result;
  double peak = 0.0;
  for (auto _ : state)
  {
    const PeakMemory memory;
    const TikhonovSmoother smoother(data.laplacian, data.metric, SmoothingEnergy::Biharmonic);
    result = smoother.smooth(data.values, Epsilon, execution);
    peak = std::max(peak, memory.bytes());
  }
  state.counters["peak bytes/vertex"] = peak / static_cast<double>(data.values.size());
  state.counters["backward error"] = backwardError(data, result);
}

/// Another function with the same epsilon: what interaction costs.
void tikhonovAgain(benchmark::State& state)
{
  const Input& data = input(static_cast<int>(state.range(0)));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  const TikhonovSmoother smoother(data.laplacian, data.metric, SmoothingEnergy::Biharmonic);
  smoother.smooth(data.values, Epsilon, execution);
  for (auto _ : state)
  {
    const Values result = smoother.smooth(data.values.reverse(), Epsilon, execution);
    benchmark::DoNotOptimize(result.data());
  }
}

void curve(benchmark::State& state)
{
  const Input& data = input(static_cast<int>(state.range(0)));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  for (auto _ : state)
  {
    const TikhonovSmoother smoother(data.laplacian, data.metric, SmoothingEnergy::Biharmonic);
    const ParameterCurve result = parameterCurve(smoother, data.values, execution);
    benchmark::DoNotOptimize(result.gcv.data());
  }
}

/// Order, factor and solve the assembled matrix; its assembly is not counted.
template <class Decomposition>
void direct(benchmark::State& state)
{
  const Input& data = input(static_cast<int>(state.range(0)));
  const Eigen::SparseMatrix<double> matrix = assembled(data);
  const double weight = Epsilon / std::pow(data.laplacian->mass.sum(), 2);
  const Values right = weight * (data.metric * data.values);
  Values result;
  double peak = 0.0;
  for (auto _ : state)
  {
    const PeakMemory memory;
    const Decomposition decomposition(matrix);
    result = decomposition.solve(right);
    peak = std::max(peak, memory.bytes());
  }
  state.counters["peak bytes/vertex"] = peak / static_cast<double>(data.values.size());
  state.counters["backward error"] = backwardError(data, result);
}

using Simplicial = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;

void sizes(benchmark::internal::Benchmark* benchmark, const std::vector<std::int64_t>& around,
  const std::vector<std::int64_t>& threads)
{
  benchmark->ArgNames({ "around", "threads" })
    ->ArgsProduct({ around, threads })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
}

// 10,082, 100,352 and 1,002,528 vertices
BENCHMARK(tikhonov)->Apply([](auto* it) { sizes(it, { 142, 448, 1416 }, { 1, 2 }); });
BENCHMARK(tikhonovAgain)->Apply([](auto* it) { sizes(it, { 142, 448, 1416 }, { 1, 2 }); });
BENCHMARK(curve)->Apply([](auto* it) { sizes(it, { 142, 448 }, { 1, 2 }); });
BENCHMARK_TEMPLATE(direct, Simplicial)->Apply([](auto* it) { sizes(it, { 142, 448 }, { 1 }); });
#ifdef SURFACE_SCALARS_CHOLMOD
using Supernodal = Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>;
BENCHMARK_TEMPLATE(direct, Supernodal)
  ->Apply(
    [](auto* it) {
      sizes(it, { 142, 448, 1416 }, { 1 });
    });
#endif

} // namespace
