#include "MeshlessContour.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace SurfaceScalars;

namespace
{

double hills(double x, double y)
{
  return 0.1 * std::sin(5.0 * x) * std::cos(4.0 * y) + 0.03 * std::sin(17.0 * x + 3.0 * y);
}

double rain(const Vector3d& p)
{
  return std::sin(6.0 * p.x() + 1.0) * std::cos(7.0 * p.y()) +
    0.4 * std::sin(13.0 * p.x() - 9.0 * p.y()) + 0.5 * p.z();
}

/// A terrain of size x size points.
struct Terrain
{
  Points vertices;
  Triangles triangles;

  explicit Terrain(int size)
    : vertices(3, size * size)
    , triangles(3, 2 * (size - 1) * (size - 1))
  {
    Eigen::Index triangle = 0;
    for (int i = 0; i < size; ++i)
    {
      for (int j = 0; j < size; ++j)
      {
        const double x = static_cast<double>(i) / (size - 1);
        const double y = static_cast<double>(j) / (size - 1);
        this->vertices.col(i * size + j) << x, y, hills(x, y);
        if (i + 1 < size && j + 1 < size)
        {
          const auto corner = static_cast<Index>(i * size + j);
          const auto next = corner + static_cast<Index>(size);
          this->triangles.col(triangle++) << corner, next, next + 1;
          this->triangles.col(triangle++) << corner, next + 1, corner + 1;
        }
      }
    }
  }
};

/// Rain on the terrain, from a thousand gauges.
const Field& thousandCenters()
{
  static const Field field = []
  {
    constexpr int Side = 32;
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> shift(-0.012, 0.012);
    Points centers(3, 1000);
    Values values(1000);
    for (int i = 0; i < 1000; ++i)
    {
      const double x = (i % Side + 0.5) / Side + shift(generator);
      const double y = (i / Side + 0.5) / Side + shift(generator);
      centers.col(i) << x, y, hills(x, y);
      values[i] = rain(centers.col(i));
    }
    FieldParameters parameters;
    parameters.scheme = Scheme::GlobalRBF;
    return Field::fit(centers, values, parameters);
  }();
  return field;
}

constexpr double Level = 0.3;

/// Where the level meets the edges of triangles, linear along them: what Contour does, less its
/// polylines.
std::size_t linearCrossings(const Terrain& terrain, const Values& values)
{
  std::vector<Vector3d> places;
  for (Eigen::Index i = 0; i < terrain.triangles.cols(); ++i)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Index a = terrain.triangles(side, i);
      const Index b = terrain.triangles((side + 1) % 3, i);
      if ((values[a] < Level) != (values[b] < Level))
      {
        const double t = (Level - values[a]) / (values[b] - values[a]);
        places.emplace_back((1.0 - t) * terrain.vertices.col(a) + t * terrain.vertices.col(b));
      }
    }
  }
  return places.size();
}

/// The level set near which alone the model is evaluated.
void meshlessContour(benchmark::State& state)
{
  const Terrain terrain(static_cast<int>(state.range(0)));
  const Field& field = thousandCenters();
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  MeshlessContours contours;
  for (auto _ : state)
  {
    contours = traceMeshlessContours(
      field, terrain.vertices, terrain.triangles, { { Level }, 0.0, 8 }, execution);
  }
  const auto count = static_cast<double>(terrain.vertices.cols());
  state.counters["vertices%"] = 100.0 * static_cast<double>(contours.evaluatedVertices) / count;
  state.counters["evaluations%"] = 100.0 * static_cast<double>(contours.evaluations) / count;
  state.counters["curves"] = static_cast<double>(contours.sets.curves.size());
}

/// The reference: the model at all vertices, then linear contours.
void evaluationAtAllVertices(benchmark::State& state)
{
  const Terrain terrain(static_cast<int>(state.range(0)));
  const Field& field = thousandCenters();
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  for (auto _ : state)
  {
    const Values values = field.evaluate(terrain.vertices, {}, execution).values;
    benchmark::DoNotOptimize(linearCrossings(terrain, values));
  }
}

// 90,000 and 2.9 million points
void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "side", "threads" })
    ->ArgsProduct({ { 300, 1703 }, { 1, 2 } })
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();
}
BENCHMARK(meshlessContour)->Apply(sizes);
BENCHMARK(evaluationAtAllVertices)->Apply(sizes);

} // namespace
