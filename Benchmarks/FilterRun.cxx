#include "FilterRun.h"

#include "Clouds.h"
#include "PeakMemory.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>

void runFilter(benchmark::State& state, vtkPolyDataAlgorithm& filter)
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

  filter.SetInputData(cloud);
  vtkSMPTools::Initialize(static_cast<int>(state.range(1)));
  double peak = 0.0;
  for (auto _ : state)
  {
    filter.Modified();
    const PeakMemory memory;
    filter.Update();
    peak = std::max(peak, memory.bytes());
  }
  vtkSMPTools::Initialize();
  state.counters["peak bytes/point"] = peak / count;
}

void pointsAndThreads(benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames({ "points", "threads" })
    ->ArgsProduct({ { 100000, 1000000 }, { 1, 2 } })
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
}
