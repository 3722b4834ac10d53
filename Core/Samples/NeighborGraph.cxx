#include "NeighborGraph.h"

#include "Error.h"
#include "NearestSearch.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1024; // points per block of a parallel loop

const PointsRef& requireTwo(const PointsRef& points)
{
  if (points.cols() < 2)
  {
    throw InvalidInput(
      "at least 2 points", std::to_string(points.cols()), "Choose a larger input.");
  }
  return points;
}

/// The first `count` of those found that are not the point itself.
void copyOthers(
  const std::vector<NearestSearch::Found>& found, Index point, Index* others, std::size_t count)
{
  for (std::size_t i = 0, copied = 0; copied < count; ++i)
  {
    others[copied] = found[i].index;
    copied += found[i].index != point ? 1 : 0;
  }
}

} // namespace

NeighborGraph::NeighborGraph(
  const PointsRef& points, const NeighborQuery& query, const Execution& execution)
  : PointCloud(requireTwo(points), execution.part(0.0, 0.3))
  , query_(query)
  , count_(std::min<std::size_t>(
      static_cast<std::size_t>(std::max(1, query.count)), this->pointCount() - 1))
{
  if (this->count_ < 1)
  {
    throw InvalidInput("at least 2 different points",
      std::to_string(points.cols()) + " points at one place", "Choose a larger input.");
  }
  if (this->query_.radius > 0.0)
  {
    this->linkWithin(execution.part(0.3, 1.0));
  }
  else
  {
    this->linkNearest(execution.part(0.3, 1.0));
  }
  this->measureSteps(execution);
}

void NeighborGraph::linkNearest(const Execution& execution)
{
  const std::size_t points = this->pointCount();
  this->indices_.resize(points * this->count_);
  parallelFor(points, Grain, execution,
    [this](std::size_t begin, std::size_t end)
    {
      NearestSearch search(*this, this->count_ + 1);
      while (begin < end)
      {
        const Eigen::Index size = search.expect(this->points().middleCols(
          static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin)));
        for (const std::size_t next = begin + static_cast<std::size_t>(size); begin < next; ++begin)
        {
          const auto point = static_cast<Index>(begin);
          copyOthers(search.find(this->points().col(point)), point,
            &this->indices_[begin * this->count_], this->count_);
        }
      }
    });
}

void NeighborGraph::linkWithin(const Execution& execution)
{
  const std::size_t points = this->pointCount();
  std::vector<std::vector<Index>> blocks((points + Grain - 1) / Grain);
  this->offsets_.assign(points + 1, 0);
  parallelFor(points, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      Neighborhood found;
      std::vector<Index>& block = blocks[begin / Grain];
      for (std::size_t i = begin; i < end; ++i)
      {
        this->within(this->points().col(static_cast<Eigen::Index>(i)), this->query_.radius, found);
        const std::size_t before = block.size();
        std::copy_if(found.indices.begin(), found.indices.end(), std::back_inserter(block),
          [i](Index other) { return other != i; });
        this->offsets_[i + 1] = block.size() - before;
      }
    });
  for (std::size_t i = 0; i < points; ++i)
  {
    this->offsets_[i + 1] += this->offsets_[i];
  }
  this->indices_.reserve(this->offsets_.back());
  for (std::vector<Index>& block : blocks)
  {
    this->indices_.insert(this->indices_.end(), block.begin(), block.end());
    std::vector<Index>().swap(block);
  }
}

double NeighborGraph::measureStep(Index point) const
{
  const std::size_t begin = this->begin(point);
  const std::size_t end = this->begin(point + 1);
  if (begin == end)
  {
    return this->query_.radius;
  }
  const double sigma =
    (this->points().col(this->indices_[end - 1]) - this->points().col(point)).norm();
  return sigma * std::sqrt(Pi / static_cast<double>(end - begin));
}

void NeighborGraph::measureSteps(const Execution& execution)
{
  this->steps_.resize(this->pointCount());
  parallelFor(this->steps_.size(), Grain, { execution.threadCount, {} },
    [this](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        this->steps_[i] = this->measureStep(static_cast<Index>(i));
      }
    });
  this->medianStep_ =
    medianOfSome(this->steps_.size(), [this](std::size_t i) { return this->steps_[i]; });
}

bool NeighborGraph::isEdge(Index from, Index to) const
{
  const Neighbors neighbors = this->neighbors(from);
  return std::find(neighbors.begin(), neighbors.end(), to) != neighbors.end();
}

double NeighborGraph::samplingStep(Index point) const
{
  return this->steps_[point];
}

double NeighborGraph::medianSamplingStep() const
{
  return this->medianStep_;
}

} // namespace SurfaceScalars
