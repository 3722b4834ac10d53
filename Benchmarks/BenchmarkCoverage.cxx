#include "LevelSetCoverage.h"
#include "LevelSetDistortion.h"
#include "TorusMesh.h"

#include <Eigen/Geometry>

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

using namespace SurfaceScalars;

namespace
{

/// A torus of so many vertices and the waves on it.
struct CoverageCase
{
  explicit CoverageCase(std::int64_t count)
    : mesh(torusMesh(static_cast<int>(std::lround(std::sqrt(2.0 * static_cast<double>(count))))))
    , values(mesh.vertices.cols())
  {
    for (Eigen::Index i = 0; i < this->values.size(); ++i)
    {
      const Vector3d place = this->mesh.vertices.col(i);
      this->values[i] = std::sin(3.0 * place.x()) + std::cos(2.0 * place.y()) + place.z();
    }
  }

  TorusMesh mesh;
  Values values;
};

const CoverageCase& caseOf(benchmark::State& state)
{
  static std::map<std::int64_t, CoverageCase> made;
  return made.try_emplace(state.range(0), state.range(0)).first->second;
}

void coverage(benchmark::State& state)
{
  const CoverageCase& input = caseOf(state);
  std::size_t steps = 0;
  for (auto _ : state)
  {
    const LevelSetCoverage result = levelSetCoverage(input.mesh.vertices, input.mesh.triangles,
      input.values, 1e-4, { static_cast<int>(state.range(1)), {} });
    steps = result.coverages.size();
  }
  state.counters["steps"] = static_cast<double>(steps);
}

/// The reference: one pass that sums areas.
void sumAreas(benchmark::State& state)
{
  const TorusMesh& mesh = caseOf(state).mesh;
  for (auto _ : state)
  {
    double area = 0.0;
    for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
    {
      const auto corners = mesh.triangles.col(i);
      const Vector3d origin = mesh.vertices.col(corners[0]);
      area += (mesh.vertices.col(corners[1]) - origin)
                .cross(mesh.vertices.col(corners[2]) - origin)
                .norm();
    }
    benchmark::DoNotOptimize(area);
  }
}

/// The map of the level sets between 64 parts of the range.
template <class Measure>
void measureMap(benchmark::State& state, const Measure& measure)
{
  const CoverageCase& input = caseOf(state);
  const MeshTopology mesh(static_cast<Index>(input.values.size()), input.mesh.triangles);
  const Values isoValues = dyadicIsoValues(input.values, 6);
  for (auto _ : state)
  {
    const LevelSetDistortion map =
      measure(input, mesh, isoValues, Execution{ static_cast<int>(state.range(1)), {} });
    benchmark::DoNotOptimize(map.distances.data());
  }
}

void hausdorffMap(benchmark::State& state)
{
  measureMap(state,
    [](const CoverageCase& input, const MeshTopology& mesh, const Values& isoValues,
      const Execution& execution)
    {
      return hausdorffDistortion(
        input.mesh.vertices, edgesOf(mesh), input.values, isoValues, Values(), execution);
    });
}

void geodesicMap(benchmark::State& state)
{
  measureMap(state,
    [](const CoverageCase& input, const MeshTopology& mesh, const Values& isoValues,
      const Execution& execution)
    {
      return geodesicDistortion(
        input.mesh.vertices, mesh, input.values, isoValues, Values(), execution);
    });
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "vertices", "threads" })
    ->ArgsProduct({ { 10000, 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(coverage)->Apply(sizes);
BENCHMARK(hausdorffMap)->Apply(sizes);
BENCHMARK(geodesicMap)->Apply(sizes);
BENCHMARK(sumAreas)
  ->ArgName("vertices")
  ->Arg(10000)
  ->Arg(100000)
  ->Arg(1000000)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime();

} // namespace
