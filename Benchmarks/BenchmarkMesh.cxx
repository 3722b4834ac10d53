#include "MeshCriticalPoints.h"
#include "PeakMemory.h"
#include "ValueOrder.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <utility>

using namespace SurfaceScalars;

namespace
{

/// A torus of squares, each cut along one of its diagonals, and a height with noise of 1%.
struct MeshCase
{
  explicit MeshCase(int count)
    : columns(static_cast<Index>(std::lround(std::sqrt(2.0 * count))))
    , rows(columns / 2)
    , vertices(3, columns * rows)
    , triangles(3, 2 * vertices.cols())
    , values(vertices.cols())
    , noise(vertices.cols())
  {
    std::mt19937 random(1);
    Eigen::Index triangle = 0;
    for (Index i = 0; i < this->columns; ++i)
    {
      for (Index j = 0; j < this->rows; ++j)
      {
        const Index a = this->vertex(i, j);
        const Index b = this->vertex(i + 1, j);
        const Index c = this->vertex(i + 1, j + 1);
        const Index d = this->vertex(i, j + 1);
        const bool isOther = random() % 2 == 0;
        this->triangles.col(triangle++) << a, b, isOther ? d : c;
        this->triangles.col(triangle++) << c, d, isOther ? b : a;
        const double u = 2.0 * Pi * i / this->columns;
        const double v = 2.0 * Pi * j / this->rows;
        const double axial = 1.0 + 0.4 * std::cos(v);
        this->vertices.col(a) << axial * std::cos(u), axial * std::sin(u), 0.4 * std::sin(v);
        this->values[a] = this->vertices.col(a).dot(Vector3d(0.3, 0.5, 0.8)) +
          0.02 * static_cast<double>(random()) / std::mt19937::max();
        this->noise[a] = std::sin(static_cast<double>(a) * a);
      }
    }
  }

  Index vertex(Index i, Index j) const { return i % this->columns * this->rows + j % this->rows; }
  Index count() const { return static_cast<Index>(this->vertices.cols()); }

  Index columns;
  Index rows;
  Points vertices;
  Triangles triangles;
  Values values;
  Values noise; ///< nothing else: the share of critical vertices is the same at any size
};

const MeshCase& meshCase(benchmark::State& state)
{
  static std::map<std::int64_t, MeshCase> made;
  const std::int64_t count = state.range(0);
  return made.try_emplace(count, static_cast<int>(count)).first->second;
}

const MeshTopology& topologyOf(benchmark::State& state)
{
  static std::map<std::int64_t, MeshTopology> made;
  const MeshCase& mesh = meshCase(state);
  return made.try_emplace(state.range(0), mesh.count(), mesh.triangles).first->second;
}

void meshTopology(benchmark::State& state)
{
  const MeshCase& mesh = meshCase(state);
  double peak = 0.0;
  for (auto _ : state)
  {
    const PeakMemory memory;
    const MeshTopology topology(
      mesh.count(), mesh.triangles, { static_cast<int>(state.range(1)), {} });
    benchmark::DoNotOptimize(topology.componentCount());
    peak = std::max(peak, memory.bytes());
  }
  state.counters["peak bytes/vertex"] = peak / mesh.count();
}

/// Work on a topology that is there already.
void measure(benchmark::State& state,
  const std::function<void(const MeshCase&, const MeshTopology&, const Execution&)>& work)
{
  const MeshCase& mesh = meshCase(state);
  const MeshTopology& topology = topologyOf(state);
  for (auto _ : state)
  {
    work(mesh, topology, { static_cast<int>(state.range(1)), {} });
  }
}

void classify(benchmark::State& state)
{
  measure(state,
    [](const MeshCase& mesh, const MeshTopology& topology, const Execution& execution)
    {
      const VertexTypes types = classifyVertices(topology, mesh.values, execution);
      benchmark::DoNotOptimize(types.counts.saddles);
    });
}

void deltas(benchmark::State& state)
{
  const VertexTypes types = classifyVertices(topologyOf(state), meshCase(state).values);
  measure(state,
    [&](const MeshCase& mesh, const MeshTopology& topology, const Execution& execution)
    {
      const Values thresholds = deltaThresholds(topology, mesh.values, types, execution);
      benchmark::DoNotOptimize(thresholds.data());
    });
}

void pairs(benchmark::State& state)
{
  measure(state,
    [](const MeshCase& mesh, const MeshTopology& topology, const Execution& execution)
    {
      const PersistencePairs found = persistencePairs(topology, mesh.values, execution);
      benchmark::DoNotOptimize(found.minima.data());
    });
}

void deltasOfNoise(benchmark::State& state)
{
  const VertexTypes types = classifyVertices(topologyOf(state), meshCase(state).noise);
  measure(state,
    [&](const MeshCase& mesh, const MeshTopology& topology, const Execution& execution)
    {
      const Values thresholds = deltaThresholds(topology, mesh.noise, types, execution);
      benchmark::DoNotOptimize(thresholds.data());
    });
}

void pairsOfNoise(benchmark::State& state)
{
  measure(state,
    [](const MeshCase& mesh, const MeshTopology& topology, const Execution& execution)
    {
      const PersistencePairs found = persistencePairs(topology, mesh.noise, execution);
      benchmark::DoNotOptimize(found.minima.data());
    });
}

void points(benchmark::State& state)
{
  measure(state,
    [](const MeshCase& mesh, const MeshTopology& topology, const Execution& execution)
    {
      const MeshCriticalPoints found =
        meshCriticalPoints(mesh.vertices, topology, mesh.values, execution);
      benchmark::DoNotOptimize(found.points.data());
    });
}

/// ValueOrder as one writes it down first: branches, which suit sorting but no walks.
struct PlainOrder
{
  const double* values;

  bool operator()(Index a, Index b) const
  {
    return this->values[a] < this->values[b] || (this->values[a] == this->values[b] && a < b);
  }
};

/// The reference: the vertices in the order of the values.
void sortValues(benchmark::State& state)
{
  const MeshCase& mesh = meshCase(state);
  std::vector<Index> order(mesh.count());
  for (auto _ : state)
  {
    std::iota(order.begin(), order.end(), Index(0));
    std::sort(order.begin(), order.end(), PlainOrder{ mesh.values.data() });
    benchmark::DoNotOptimize(order.data());
  }
}

/// The reference: changes of sign around each vertex, along links in flat arrays.
template <class Order>
void walkAlongLinks(benchmark::State& state)
{
  const MeshCase& mesh = meshCase(state);
  const MeshTopology& topology = topologyOf(state);
  const Order isBelow{ mesh.values.data() };
  std::vector<Index> changes(mesh.count());
  for (auto _ : state)
  {
    for (Index vertex = 0; vertex < mesh.count(); ++vertex)
    {
      const VertexRange path = topology.linkPath(vertex);
      bool last = isBelow(vertex, *path.first);
      Index count = 0;
      for (const Index* next = path.first + 1; next != path.last; ++next)
      {
        const bool isAbove = isBelow(vertex, *next);
        count += isAbove != last ? 1 : 0;
        last = isAbove;
      }
      changes[vertex] = count;
    }
    benchmark::DoNotOptimize(changes.data());
  }
}

Index nextCorner(Index corner)
{
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// Corners of triangles, three in a row, and across the opposite edge of each another.
struct CornerTable
{
  explicit CornerTable(const MeshCase& mesh)
    : opposite(static_cast<std::size_t>(mesh.triangles.size()))
    , first(mesh.count())
  {
    const Index* corners = mesh.triangles.data();
    std::map<std::pair<Index, Index>, Index> open;
    for (Index corner = 0; corner < this->opposite.size(); ++corner)
    {
      this->first[corners[corner]] = corner;
      const Index next = nextCorner(corner);
      const auto edge = std::minmax(corners[next], corners[nextCorner(next)]);
      const auto [place, isNew] = open.emplace(edge, corner);
      if (!isNew)
      {
        this->opposite[corner] = place->second;
        this->opposite[place->second] = corner;
        open.erase(place);
      }
    }
  }

  std::vector<Index> opposite;
  std::vector<Index> first; ///< a corner at each vertex
};

/// The same, walking from triangle to triangle, as on a mesh of half-edges.
template <class Order>
void walkAcrossTriangles(benchmark::State& state)
{
  const MeshCase& mesh = meshCase(state);
  static std::map<std::int64_t, CornerTable> made;
  const CornerTable& table = made.try_emplace(state.range(0), mesh).first->second;
  const Index* corners = mesh.triangles.data();
  const Order isBelow{ mesh.values.data() };
  std::vector<Index> changes(mesh.count());
  for (auto _ : state)
  {
    for (Index vertex = 0; vertex < mesh.count(); ++vertex)
    {
      Index count = 0;
      Index corner = table.first[vertex];
      do
      {
        const Index next = nextCorner(corner);
        const Index last = nextCorner(next);
        count += isBelow(vertex, corners[next]) != isBelow(vertex, corners[last]) ? 1 : 0;
        corner = nextCorner(table.opposite[next]);
      } while (corner != table.first[vertex]);
      changes[vertex] = count;
    }
    benchmark::DoNotOptimize(changes.data());
  }
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "vertices", "threads" })
    ->ArgsProduct({ { 10000, 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

void sizesOfReference(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgName("vertices")
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(meshTopology)->Apply(sizes);
BENCHMARK(classify)->Apply(sizes);
BENCHMARK(deltas)->Apply(sizes);
BENCHMARK(deltasOfNoise)->Apply(sizes);
BENCHMARK(pairs)->Apply(sizes);
BENCHMARK(pairsOfNoise)->Apply(sizes);
BENCHMARK(points)->Apply(sizes);
BENCHMARK(sortValues)->Apply(sizesOfReference);
BENCHMARK_TEMPLATE(walkAlongLinks, PlainOrder)->Apply(sizesOfReference);
BENCHMARK_TEMPLATE(walkAlongLinks, ValueOrder)->Apply(sizesOfReference);
BENCHMARK_TEMPLATE(walkAcrossTriangles, PlainOrder)->Apply(sizesOfReference);
BENCHMARK_TEMPLATE(walkAcrossTriangles, ValueOrder)->Apply(sizesOfReference);

} // namespace
