#include "MeshCriticalPoints.h"
#include "MorseComplex.h"
#include "TopologicalSimplification.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <tuple>
#include <utility>
#include <vector>

using namespace SurfaceScalars;

namespace
{

/// A torus cut into triangles, a wavy function with noise in percent of its range, and the extrema
/// of at least a third of that.
struct NoisyTorus
{
  NoisyTorus(int count, int percent)
    : columns(static_cast<Index>(std::lround(std::sqrt(count))))
    , points(3, columns * columns)
    , values(points.cols())
    , topology(columns * columns, this->triangles())
  {
    std::mt19937_64 engine(1);
    std::normal_distribution<double> noise(0.0, 0.04 * percent); // waves between -2 and 2
    for (Index i = 0; i < this->points.cols(); ++i)
    {
      const double u = 2.0 * Pi * (i / this->columns) / this->columns;
      const double v = 2.0 * Pi * (i % this->columns) / this->columns;
      const double axial = 1.0 + 0.4 * std::cos(v);
      this->points.col(i) << axial * std::cos(u), axial * std::sin(u), 0.4 * std::sin(v);
      this->values[i] = std::cos(3.0 * u) * std::cos(2.0 * v) + std::cos(u + v) + noise(engine);
    }
    this->threshold = (this->values.maxCoeff() - this->values.minCoeff()) / 3.0;
    for (const CriticalPoint& point :
      meshCriticalPoints(this->points, this->topology, this->values).points)
    {
      if (point.type != CriticalType::Saddle && point.persistence >= this->threshold)
      {
        (point.type == CriticalType::Minimum ? this->minima : this->maxima)
          .push_back(static_cast<Index>(point.input));
      }
    }
  }

  Triangles triangles() const
  {
    const auto vertex = [this](Index i, Index j)
    { return i % this->columns * this->columns + j % this->columns; };
    Triangles result(3, 2 * this->points.cols());
    for (Index i = 0; i < this->columns; ++i)
    {
      for (Index j = 0; j < this->columns; ++j)
      {
        const Index square = vertex(i, j);
        const Index opposite = vertex(i + 1, j + 1);
        result.col(2 * square) << square, vertex(i + 1, j), opposite;
        result.col(2 * square + 1) << square, opposite, vertex(i, j + 1);
      }
    }
    return result;
  }

  Index columns;
  Points points;
  Values values;
  MeshTopology topology;
  double threshold = 0.0;
  std::vector<Index> minima;
  std::vector<Index> maxima;
};

const NoisyTorus& noisyTorus(const benchmark::State& state)
{
  static std::map<std::pair<std::int64_t, std::int64_t>, NoisyTorus> made;
  const auto count = state.range(0);
  const auto percent = state.range(1);
  return made.try_emplace({ count, percent }, static_cast<int>(count), static_cast<int>(percent))
    .first->second;
}

/// The reference: the vertices in the order of the values, one thread.
void sortBeforeSimplification(benchmark::State& state)
{
  const Values& values = noisyTorus(state).values;
  std::vector<Index> order(static_cast<std::size_t>(values.size()));
  for (auto _ : state)
  {
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(),
      [&](Index a, Index b) { return std::tie(values[a], a) < std::tie(values[b], b); });
    benchmark::DoNotOptimize(order.data());
  }
}

void simplify(benchmark::State& state)
{
  const NoisyTorus& torus = noisyTorus(state);
  const Execution execution{ static_cast<int>(state.range(2)), {} };
  for (auto _ : state)
  {
    const Values kept =
      keepExtrema(torus.topology, torus.values, torus.minima, torus.maxima, execution);
    benchmark::DoNotOptimize(kept.data());
  }
}

/// Critical points before and after, simplification and paths.
void simplifiedComplex(benchmark::State& state)
{
  const NoisyTorus& torus = noisyTorus(state);
  const Execution execution{ static_cast<int>(state.range(2)), {} };
  for (auto _ : state)
  {
    const MorseComplex complex =
      morseComplex(torus.points, torus.topology, torus.values, torus.threshold, execution);
    benchmark::DoNotOptimize(complex.separatrices.data());
  }
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "vertices", "percent", "threads" })
    ->ArgsProduct({ { 10000, 100000, 1000000 }, { 1, 5 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(sortBeforeSimplification)
  ->ArgNames({ "vertices", "percent" })
  ->ArgsProduct({ { 10000, 100000, 1000000 }, { 1, 5 } })
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();
BENCHMARK(simplify)->Apply(sizes);
BENCHMARK(simplifiedComplex)->Apply(sizes);

} // namespace
