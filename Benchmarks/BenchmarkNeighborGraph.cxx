#include "Clouds.h"
#include "Execution.h"
#include "NeighborGraph.h"

#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <benchmark/benchmark.h>
#include <nanoflann.hpp>

#include <cstdint>
#include <vector>

using namespace SurfaceScalars;

namespace
{

constexpr std::size_t NeighborCount = 16;
constexpr std::size_t Grain = 1024;

struct PointAccess
{
  const Points& points;
  std::size_t kdtree_get_point_count() const
  {
    return static_cast<std::size_t>(this->points.cols());
  }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const
  {
    return this->points.data()[3 * point + axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<
  nanoflann::L2_Simple_Adaptor<double, PointAccess, double, std::uint32_t>, PointAccess, 3,
  std::uint32_t>;

/// The reference: nanoflann with its defaults, points and queries in the order in which they come.
void nanoflannInInputOrder(benchmark::State& state)
{
  const PointAccess access{ torusCloud(static_cast<int>(state.range(0))) };
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  const std::size_t count = access.kdtree_get_point_count();
  std::vector<std::uint32_t> neighbors(count * NeighborCount);
  for (auto _ : state)
  {
    const KdTree tree(3, access);
    parallelFor(count, Grain, execution,
      [&](std::size_t begin, std::size_t end)
      {
        std::uint32_t indices[NeighborCount + 1];
        double distances[NeighborCount + 1];
        for (std::size_t i = begin; i < end; ++i)
        {
          nanoflann::KNNResultSet<double, std::uint32_t> found(NeighborCount + 1);
          found.init(indices, distances);
          tree.findNeighbors(found, access.points.data() + 3 * i, {});
          std::copy(indices + 1, indices + 1 + NeighborCount, &neighbors[i * NeighborCount]);
        }
      });
    benchmark::DoNotOptimize(neighbors.data());
  }
}

void vtkLocator(benchmark::State& state)
{
  const Points& cloud = torusCloud(static_cast<int>(state.range(0)));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(cloud.cols());
  for (vtkIdType i = 0; i < cloud.cols(); ++i)
  {
    points->SetPoint(i, cloud.data() + 3 * i);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  const auto count = static_cast<std::size_t>(cloud.cols());
  std::vector<vtkIdType> neighbors(count * NeighborCount);
  for (auto _ : state)
  {
    vtkNew<vtkStaticPointLocator> locator;
    locator->SetDataSet(data);
    locator->BuildLocator();
    parallelFor(count, Grain, execution,
      [&](std::size_t begin, std::size_t end)
      {
        vtkNew<vtkIdList> found;
        for (std::size_t i = begin; i < end; ++i)
        {
          locator->FindClosestNPoints(NeighborCount + 1, cloud.data() + 3 * i, found);
          std::copy(found->GetPointer(1), found->GetPointer(1) + NeighborCount,
            &neighbors[i * NeighborCount]);
        }
      });
    benchmark::DoNotOptimize(neighbors.data());
  }
}

void neighborGraph(benchmark::State& state)
{
  const Points& cloud = torusCloud(static_cast<int>(state.range(0)));
  const Execution execution{ static_cast<int>(state.range(1)), {} };
  for (auto _ : state)
  {
    const NeighborGraph graph(cloud, { static_cast<int>(NeighborCount), 0.0 }, execution);
    benchmark::DoNotOptimize(graph.pointCount());
  }
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "points", "threads" })
    ->ArgsProduct({ { 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}

BENCHMARK(neighborGraph)->Apply(sizes);
BENCHMARK(nanoflannInInputOrder)->Apply(sizes);
BENCHMARK(vtkLocator)->Apply(sizes);

} // namespace
