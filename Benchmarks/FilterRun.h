#pragma once

#include <vtkPolyDataAlgorithm.h>

#include <benchmark/benchmark.h>

/// Runs a filter from input to output on torusCloud() with tiltedHeight() as scalars: state has the
/// numbers of points and of threads. Counts the peak memory beside the input.
void runFilter(benchmark::State& state, vtkPolyDataAlgorithm& filter);

/// 100,000 and 1,000,000 points, one thread and two.
void pointsAndThreads(benchmark::internal::Benchmark* benchmark);
