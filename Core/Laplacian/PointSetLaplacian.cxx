#include "Laplacian.h"
#include "LaplacianScale.h"
#include "NumberText.h"
#include "Quantile.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1024; // rows per block of a parallel loop
const double LeastWeight = std::exp(-12.0);

using Matrix = Eigen::SparseMatrix<double>;

struct Link
{
  Index from;
  Index to;
};

/// Where `to` is a neighbor of `from` but not the reverse; by blocks of `from`.
std::vector<std::vector<Link>> oneWayLinks(const NeighborGraph& graph, const Execution& execution)
{
  std::vector<std::vector<Link>> result((graph.pointCount() + Grain - 1) / Grain);
  parallelFor(graph.pointCount(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto from = static_cast<Index>(begin); from < end; ++from)
      {
        for (const Index to : graph.neighbors(from))
        {
          if (!graph.isEdge(to, from))
          {
            result[begin / Grain].push_back({ from, to });
          }
        }
      }
    });
  return result;
}

/// A matrix with these numbers of entries, not yet set.
Matrix emptyRows(const std::vector<int>& entriesOfRow)
{
  const auto count = static_cast<Eigen::Index>(entriesOfRow.size());
  Matrix result(count, count);
  std::size_t entries = 0;
  for (std::size_t i = 0; i < entriesOfRow.size(); ++i)
  {
    entries += static_cast<std::size_t>(entriesOfRow[i]);
    require(entries <= std::numeric_limits<int>::max(), "at most 2^31 links between points",
      std::to_string(count) + " points with too many neighbors",
      "Choose fewer neighbors or thin the points.");
    result.outerIndexPtr()[i + 1] = static_cast<int>(entries);
  }
  result.resizeNonZeros(static_cast<Eigen::Index>(entries));
  return result;
}

/// The links of a neighbor graph in both directions, and the diagonal, as the pattern of a matrix;
/// built in place, as it is by far the largest object.
Matrix linkPattern(const NeighborGraph& graph, const Execution& execution)
{
  const auto links = oneWayLinks(graph, execution.part(0.0, 0.5));
  std::vector<int> entries(graph.pointCount());
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    entries[i] = 1 + static_cast<int>(graph.neighbors(i).size());
  }
  const auto forEachLink = [&](const auto& body)
  {
    for (const std::vector<Link>& block : links)
    {
      std::for_each(block.begin(), block.end(), body);
    }
  };
  forEachLink([&](const Link& link) { ++entries[link.to]; });
  Matrix result = emptyRows(entries);
  const int* starts = result.outerIndexPtr();
  int* columns = result.innerIndexPtr();
  forEachLink([&](const Link& link)
    { columns[starts[link.to] + --entries[link.to]] = static_cast<int>(link.from); });
  parallelFor(graph.pointCount(), Grain, execution.part(0.5, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<Index>(begin); i < end; ++i)
      {
        int* const row = columns + starts[i];
        const Neighbors neighbors = graph.neighbors(i);
        *row = static_cast<int>(i);
        std::copy(neighbors.begin(), neighbors.end(), row + 1);
        std::sort(row, columns + starts[i + 1]);
      }
    });
  return result;
}

/// Sets each entry beside the diagonal to -weight(i, j, entry), the diagonal so that rows sum to 0.
template <class Weight>
void setWeights(Matrix& stiffness, const Execution& execution, const Weight& weight)
{
  parallelFor(static_cast<std::size_t>(stiffness.cols()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<int>(begin); i < static_cast<int>(end); ++i)
      {
        double sum = 0.0;
        double* diagonal = nullptr;
        for (Matrix::InnerIterator entry(stiffness, i); entry; ++entry)
        {
          if (entry.row() == i)
          {
            diagonal = &entry.valueRef();
            continue;
          }
          const double value = weight(i, static_cast<int>(entry.row()), -entry.value());
          entry.valueRef() = -value;
          sum += value;
        }
        *diagonal = sum;
      }
    });
}

Values samplingSteps(const NeighborGraph& graph)
{
  Values result(graph.pointCount());
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    result[i] = graph.samplingStep(i);
  }
  return result;
}

/// k, where all points within a radius are neighbors the one that most points reach: sigma is then
/// the distance that holds as many, not the radius, which does not follow the density.
double neighborCount(const NeighborGraph& graph)
{
  std::vector<double> counts(graph.pointCount());
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    counts[i] = static_cast<double>(graph.neighbors(i).size());
  }
  return std::max(1.0, quantile(counts, 0.1));
}

/// A weight is exp(-d^2 / (h_i h_j)) with these h.
Values kernelWidths(
  const NeighborGraph& graph, const Values& steps, LaplacianWeights weights, double kernelWidth)
{
  const double sigmasPerStep = std::sqrt(neighborCount(graph) / Pi);
  if (weights == LaplacianWeights::LocalScale)
  {
    return steps * (sigmasPerStep / std::sqrt(3.0));
  }
  const double automatic = std::sqrt(steps.squaredNorm() / static_cast<double>(steps.size()) / 3.0);
  return Values::Constant(
    steps.size(), kernelWidth > 0.0 ? kernelWidth : sigmasPerStep * automatic);
}

/// Proportional to the rows' sums; as much as the areas in all, and the area where nothing is
/// linked.
Values massOfRows(const Matrix& stiffness, const Values& areas)
{
  const Values sums = stiffness.diagonal();
  const double scale = areas.sum() / std::max(sums.sum(), std::numeric_limits<double>::min());
  return (sums.array() > 0.0).select(scale * sums, areas);
}

void checkParameters(LaplacianWeights weights, double kernelWidth)
{
  require(weights == LaplacianWeights::Gaussian || weights == LaplacianWeights::DensityNormalized ||
      weights == LaplacianWeights::LocalScale,
    "weights of points (Gaussian 0, DensityNormalized 1 or LocalScale 2)",
    std::to_string(static_cast<int>(weights)), "Choose one of these or an input with triangles.");
  require(std::isfinite(kernelWidth) && kernelWidth >= 0.0,
    "a finite kernel width that is not negative", textOf(kernelWidth),
    "Set it to 0 to choose it from the sampling.");
}

} // namespace

Laplacian pointSetLaplacian(const NeighborGraph& graph, LaplacianWeights weights,
  double kernelWidth, const Execution& execution)
{
  checkParameters(weights, kernelWidth);
  const Values steps = samplingSteps(graph);
  const Values widths = kernelWidths(graph, steps, weights, kernelWidth);
  const Points& points = graph.points();

  Laplacian result{ linkPattern(graph, execution.part(0.0, 0.4)), steps.cwiseAbs2() };
  setWeights(result.stiffness, execution.part(0.4, 0.5),
    [&](int i, int j, double)
    {
      const double squaredDistance = (points.col(i) - points.col(j)).squaredNorm();
      return std::max(LeastWeight, std::exp(-squaredDistance / (widths[i] * widths[j])));
    });
  if (weights == LaplacianWeights::DensityNormalized)
  {
    const Values sums = result.stiffness.diagonal();
    setWeights(result.stiffness, execution.part(0.5, 0.6),
      [&](int i, int j, double weight) { return weight / (sums[i] * sums[j]); });
  }
  if (weights != LaplacianWeights::LocalScale)
  {
    result.mass = massOfRows(result.stiffness, result.mass);
  }
  result.stiffness *= stiffnessScale(result, graph, execution.part(0.6, 1.0));
  return result;
}

} // namespace SurfaceScalars
