#include "FunctionDesign.h"
#include "RowScaling.h"
#include "TorusMesh.h"

#include <benchmark/benchmark.h>

#ifdef SURFACE_SCALARS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <vector>

using namespace SurfaceScalars;

namespace
{

/// Twenty critical points all over a torus, whose sum of indices is 0. @param shift of the first
std::vector<CriticalRequest> twentyPoints(Index vertexCount, Index shift)
{
  std::vector<CriticalRequest> result(20);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    const Index step = vertexCount / static_cast<Index>(result.size());
    result[i].vertex = static_cast<Index>(i) * step + step / 3 * static_cast<Index>(i % 3);
    result[i].type = i % 2 == 0 ? CriticalType::Saddle
      : i % 4 == 1              ? CriticalType::Minimum
                                : CriticalType::Maximum;
  }
  result.front().vertex += shift;
  return result;
}

DesignParameters parametersOf(const benchmark::State& state)
{
  DesignParameters parameters;
  parameters.approach = static_cast<DesignApproach>(state.range(2));
  parameters.cleanUp = state.range(3) != 0;
  return parameters;
}

/// On a mesh that was not seen before.
void firstDesign(benchmark::State& state)
{
  const TorusMesh torus = torusMesh(static_cast<int>(state.range(0)));
  const auto count = static_cast<Index>(torus.vertices.cols());
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  for (auto _ : state)
  {
    const DesignMesh mesh(torus.vertices, torus.triangles, execution);
    const DesignedFunction result =
      designFunction(mesh, twentyPoints(count, 0), parametersOf(state), execution);
    state.counters["added"] =
      static_cast<double>(result.critical.points.size()) - static_cast<double>(20);
  }
}

/// One point is somewhere else, each time.
void movedPoint(benchmark::State& state)
{
  const TorusMesh torus = torusMesh(static_cast<int>(state.range(0)));
  const auto count = static_cast<Index>(torus.vertices.cols());
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  const DesignMesh mesh(torus.vertices, torus.triangles, execution);
  designFunction(mesh, twentyPoints(count, 0), parametersOf(state), execution);
  Index shift = 0;
  for (auto _ : state)
  {
    shift += 3;
    const DesignedFunction result =
      designFunction(mesh, twentyPoints(count, shift), parametersOf(state), execution);
    benchmark::DoNotOptimize(result.values.data());
  }
}

#ifdef SURFACE_SCALARS_CHOLMOD
/// One analysis and factorization of S A^-1 S without the rows and columns of the points and their
/// neighbors, which is what (2) asks for; its assembly is not counted.
void constrainedFactorization(benchmark::State& state)
{
  using Matrix = Eigen::SparseMatrix<double>;
  const TorusMesh torus = torusMesh(static_cast<int>(state.range(0)));
  const auto count = static_cast<Index>(torus.vertices.cols());
  const MeshTopology topology(count, torus.triangles);
  const Laplacian laplacian =
    meshLaplacian(torus.vertices, torus.triangles, LaplacianWeights::Cotangent);
  Values isFree = Values::Ones(count);
  for (const CriticalRequest& request : twentyPoints(count, 0))
  {
    isFree[request.vertex] = 0.0;
    for (const Index neighbor : topology.link(request.vertex))
    {
      isFree[neighbor] = 0.0;
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  int unknowns = 0;
  for (Index i = 0; i < count; ++i)
  {
    if (isFree[i] != 0.0)
    {
      entries.emplace_back(static_cast<int>(i), unknowns++, 1.0);
    }
  }
  Matrix selection(count, unknowns);
  selection.setFromTriplets(entries.begin(), entries.end());
  const Matrix columns = laplacian.stiffness * selection;
  const Matrix scaled = scaleRows(columns, laplacian.mass.cwiseInverse());
  const Matrix matrix = columns.transpose() * scaled;
  for (auto _ : state)
  {
    const Eigen::CholmodSupernodalLLT<Matrix> factors(matrix);
    benchmark::DoNotOptimize(factors.info());
  }
}
BENCHMARK(constrainedFactorization)
  ->ArgName("around")
  ->Arg(448)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->MeasureProcessCPUTime();
#endif

void choices(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "around", "threads", "meshless", "cleanUp" })
    ->ArgsProduct({ { 448 }, { 1, 2 }, { 0, 1 }, { 0, 1 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
}

// 100,352 vertices
BENCHMARK(firstDesign)->Apply(choices);
BENCHMARK(movedPoint)->Apply(choices);

} // namespace
