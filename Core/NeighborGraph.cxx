#include "NeighborGraph.h"

#include "Error.h"
#include "MortonOrder.h"
#include "PointTree.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1024; // points per block of a parallel loop

/// The points in Morton order without duplicates, and the way there from the caller's order.
struct SortedPoints
{
  Points points;
  Vector3d origin;
  std::vector<Index> pointOfInput;
  std::vector<Index> inputOfPoint;
};

/// The center of the bounding box, which does not depend on the order of the points. @throws
/// InvalidInput if a coordinate is not finite
Vector3d boxCenter(const PointsRef& input, const Execution& execution)
{
  const auto count = static_cast<std::size_t>(input.cols());
  const std::size_t blocks = (count + Grain - 1) / Grain;
  Points low(3, static_cast<Eigen::Index>(blocks));
  Points high(3, static_cast<Eigen::Index>(blocks));
  parallelFor(count, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto block =
        input.middleCols(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
      if (!block.allFinite())
      {
        throw InvalidInput("finite coordinates", "NaN or infinity", "Leave such points out.");
      }
      const auto column = static_cast<Eigen::Index>(begin / Grain);
      low.col(column) = block.rowwise().minCoeff();
      high.col(column) = block.rowwise().maxCoeff();
    });
  const Vector3d lowest = low.rowwise().minCoeff();
  return lowest + 0.5 * (high.rowwise().maxCoeff() - lowest);
}

/// Numbers runs of equal points, in the order given, from 0: duplicates get the same number.
/// @returns how many runs
std::size_t numberRuns(const Points& points, const std::vector<Index>& order,
  std::vector<Index>& runs, const Execution& execution)
{
  const auto startsRun = [&](std::size_t i)
  { return i == 0 || points.col(order[i]) != points.col(order[i - 1]); };
  std::vector<std::size_t> before((order.size() + Grain - 1) / Grain + 1, 0);
  parallelFor(order.size(), Grain, execution.part(0.0, 0.5),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        before[begin / Grain + 1] += startsRun(i) ? 1 : 0;
      }
    });
  std::partial_sum(before.begin(), before.end(), before.begin());
  runs.resize(order.size());
  parallelFor(order.size(), Grain, execution.part(0.5, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t started = before[begin / Grain];
      for (std::size_t i = begin; i < end; ++i)
      {
        started += startsRun(i) ? 1 : 0;
        runs[i] = static_cast<Index>(started - 1);
      }
    });
  return before.back();
}

SortedPoints sortPoints(const PointsRef& input, const Execution& execution)
{
  SortedPoints sorted;
  sorted.origin = boxCenter(input, execution.part(0.0, 0.05));
  // Centered before all else: what becomes equal by that is a duplicate too.
  const auto count = static_cast<std::size_t>(input.cols());
  Points centered(3, input.cols());
  parallelFor(count, Grain, execution.part(0.05, 0.1),
    [&](std::size_t begin, std::size_t end)
    {
      const auto first = static_cast<Eigen::Index>(begin);
      const auto size = static_cast<Eigen::Index>(end - begin);
      centered.middleCols(first, size) = input.middleCols(first, size).colwise() - sorted.origin;
    });
  const std::vector<Index> order = mortonOrder(centered, execution.part(0.1, 0.8));
  std::vector<Index> runs;
  const std::size_t distinct = numberRuns(centered, order, runs, execution.part(0.8, 0.9));

  sorted.points.resize(3, static_cast<Eigen::Index>(distinct));
  sorted.inputOfPoint.resize(distinct);
  sorted.pointOfInput.resize(count);
  parallelFor(count, Grain, execution.part(0.9, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        sorted.pointOfInput[order[i]] = runs[i];
        if (i == 0 || runs[i] != runs[i - 1])
        {
          sorted.points.col(runs[i]) = centered.col(order[i]);
          sorted.inputOfPoint[runs[i]] = order[i];
        }
      }
    });
  return sorted;
}

} // namespace

struct NeighborGraph::Implementation
{
  SortedPoints sorted;
  NeighborQuery query;
  std::size_t count; ///< neighbors of each point if query.radius is 0
  PointTree tree;
  std::vector<std::size_t> offsets; ///< CSR row starts; empty if every point has `count` neighbors
  std::vector<Index> indices;
  std::vector<double> steps; ///< sampling steps
  double medianStep = 0.0;

  Implementation(const PointsRef& points, const NeighborQuery& query, const Execution& execution);
  std::size_t begin(Index point) const
  {
    return this->offsets.empty() ? point * this->count : this->offsets[point];
  }
  void linkNearest(const Execution& execution);
  void linkWithin(const Execution& execution);
  double samplingStep(Index point) const;
  void measureSteps(const Execution& execution);
};

NeighborGraph::Implementation::Implementation(
  const PointsRef& points, const NeighborQuery& neighborQuery, const Execution& execution)
  : sorted(sortPoints(points, execution.part(0.0, 0.15)))
  , query(neighborQuery)
  , count(std::min<std::size_t>(
      static_cast<std::size_t>(std::max(1, neighborQuery.count)), sorted.inputOfPoint.size() - 1))
  , tree(sorted.points, execution.part(0.15, 0.3))
{
  if (this->count < 1)
  {
    throw InvalidInput("at least 2 different points",
      std::to_string(points.cols()) + " points at one place", "Choose a larger input.");
  }
  if (this->query.radius > 0.0)
  {
    this->linkWithin(execution.part(0.3, 1.0));
  }
  else
  {
    this->linkNearest(execution.part(0.3, 1.0));
  }
}

void NeighborGraph::Implementation::linkNearest(const Execution& execution)
{
  const std::size_t points = this->sorted.inputOfPoint.size();
  this->indices.resize(points * this->count);
  parallelFor(points, Grain, execution,
    [this](std::size_t begin, std::size_t end)
    {
      NearestSearch search(this->tree, this->count + 1);
      for (std::size_t i = begin; i < end; ++i)
      {
        const Index* nearest = search.around(this->sorted.points.col(static_cast<Eigen::Index>(i)));
        std::copy(nearest + 1, nearest + 1 + this->count, &this->indices[i * this->count]);
      }
    });
}

void NeighborGraph::Implementation::linkWithin(const Execution& execution)
{
  const std::size_t points = this->sorted.inputOfPoint.size();
  std::vector<std::vector<Index>> blocks((points + Grain - 1) / Grain);
  this->offsets.assign(points + 1, 0);
  parallelFor(points, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      Neighborhood found;
      std::vector<Index>& block = blocks[begin / Grain];
      for (std::size_t i = begin; i < end; ++i)
      {
        this->tree.within(
          this->sorted.points.col(static_cast<Eigen::Index>(i)), this->query.radius, found);
        const std::size_t before = block.size();
        std::copy_if(found.indices.begin(), found.indices.end(), std::back_inserter(block),
          [i](Index other) { return other != i; });
        this->offsets[i + 1] = block.size() - before;
      }
    });
  for (std::size_t i = 0; i < points; ++i)
  {
    this->offsets[i + 1] += this->offsets[i];
  }
  this->indices.reserve(this->offsets.back());
  for (std::vector<Index>& block : blocks)
  {
    this->indices.insert(this->indices.end(), block.begin(), block.end());
    std::vector<Index>().swap(block);
  }
}

double NeighborGraph::Implementation::samplingStep(Index point) const
{
  const std::size_t begin = this->begin(point);
  const std::size_t end = this->begin(point + 1);
  if (begin == end)
  {
    return this->query.radius;
  }
  const double sigma =
    (this->sorted.points.col(this->indices[end - 1]) - this->sorted.points.col(point)).norm();
  return sigma * std::sqrt(Pi / static_cast<double>(end - begin));
}

void NeighborGraph::Implementation::measureSteps(const Execution& execution)
{
  this->steps.resize(this->sorted.inputOfPoint.size());
  parallelFor(this->steps.size(), Grain, { execution.threadCount, {} },
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->steps[i] = this->samplingStep(static_cast<Index>(i));
      }
    });
  this->medianStep =
    medianOfSome(this->steps.size(), [this](std::size_t i) { return this->steps[i]; });
}

NeighborGraph::NeighborGraph(
  const PointsRef& points, const NeighborQuery& query, const Execution& execution)
{
  const std::string remedy = "Choose a larger input.";
  if (points.cols() < 2)
  {
    throw InvalidInput("at least 2 points", std::to_string(points.cols()), remedy);
  }
  if (points.cols() > std::numeric_limits<int>::max())
  {
    throw InvalidInput(
      "at most 2147483647 points", std::to_string(points.cols()), "Thin them out.");
  }
  this->implementation_ = std::make_unique<Implementation>(points, query, execution);
  this->implementation_->measureSteps(execution);
}

NeighborGraph::~NeighborGraph() = default;
NeighborGraph::NeighborGraph(NeighborGraph&&) noexcept = default;
NeighborGraph& NeighborGraph::operator=(NeighborGraph&&) noexcept = default;

Index NeighborGraph::pointCount() const
{
  return static_cast<Index>(this->implementation_->sorted.inputOfPoint.size());
}

const Points& NeighborGraph::points() const
{
  return this->implementation_->sorted.points;
}

const Vector3d& NeighborGraph::origin() const
{
  return this->implementation_->sorted.origin;
}

Neighbors NeighborGraph::neighbors(Index point) const
{
  const Index* indices = this->implementation_->indices.data();
  return { indices + this->implementation_->begin(point),
    indices + this->implementation_->begin(point + 1) };
}

bool NeighborGraph::isEdge(Index from, Index to) const
{
  const Neighbors neighbors = this->neighbors(from);
  return std::find(neighbors.begin(), neighbors.end(), to) != neighbors.end();
}

double NeighborGraph::samplingStep(Index point) const
{
  return this->implementation_->steps[point];
}

double NeighborGraph::medianSamplingStep() const
{
  return this->implementation_->medianStep;
}

Index NeighborGraph::pointOfInput(std::size_t input) const
{
  return this->implementation_->sorted.pointOfInput[input];
}

std::size_t NeighborGraph::inputOfPoint(Index point) const
{
  return this->implementation_->sorted.inputOfPoint[point];
}

std::size_t NeighborGraph::inputCount() const
{
  return this->implementation_->sorted.pointOfInput.size();
}

Values NeighborGraph::average(const ValuesRef& values) const
{
  Values result = Values::Zero(this->pointCount());
  Eigen::VectorXi weights = Eigen::VectorXi::Zero(this->pointCount());
  for (std::size_t i = 0; i < this->inputCount(); ++i)
  {
    const Index point = this->pointOfInput(i);
    // A running mean: a sum of huge values could overflow, and equal values must stay what they
    // are.
    result[point] += (values[static_cast<Eigen::Index>(i)] - result[point]) / ++weights[point];
  }
  return result;
}

void NeighborGraph::nearest(const Vector3d& place, int count, Neighborhood& result) const
{
  const auto wanted = static_cast<std::size_t>(std::max(1, count));
  this->implementation_->tree.nearest(
    place, std::min<std::size_t>(wanted, this->pointCount()), result);
}

void NeighborGraph::within(const Vector3d& place, double radius, Neighborhood& result) const
{
  this->implementation_->tree.within(place, radius, result);
}

} // namespace SurfaceScalars
