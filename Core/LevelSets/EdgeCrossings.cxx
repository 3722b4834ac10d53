#include "EdgeCrossings.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 4096;
constexpr std::ptrdiff_t EdgesPerPoint = 8; // enough to meet every curve about once a sampling step

struct LeveledCrossing
{
  Index level;
  EdgeCrossing crossing;
};

/// Number of levels that each value has reached.
std::vector<Index> rankValues(
  const Values& values, const std::vector<double>& levels, const Execution& execution)
{
  std::vector<Index> ranks(static_cast<std::size_t>(values.size()));
  parallelFor(ranks.size(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto above =
          std::upper_bound(levels.begin(), levels.end(), values[static_cast<Eigen::Index>(i)]);
        ranks[i] = static_cast<Index>(above - levels.begin());
      }
    });
  return ranks;
}

class PointCrossings
{
public:
  PointCrossings(const SampledFunction& function, const std::vector<double>& levels,
    const std::vector<Index>& ranks)
    : function_(function)
    , levels_(levels)
    , ranks_(ranks)
  {
  }

  /// Appends, for each level that meets an edge at `point` on this point's half, the crossing
  /// closest to the point.
  void append(Index point, std::vector<LeveledCrossing>& result)
  {
    const Neighbors neighbors = this->function_.graph.neighbors(point);
    const Index* last = std::min(neighbors.end(), neighbors.begin() + EdgesPerPoint);
    Index lowest = this->ranks_[point];
    Index highest = lowest;
    for (const Index* neighbor = neighbors.begin(); neighbor < last; ++neighbor)
    {
      lowest = std::min(lowest, this->ranks_[*neighbor]);
      highest = std::max(highest, this->ranks_[*neighbor]);
    }
    if (lowest == highest)
    {
      return; // most points
    }
    this->closest_.assign(highest - lowest, Closest());
    for (const Index* neighbor = neighbors.begin(); neighbor < last; ++neighbor)
    {
      if (this->ranks_[*neighbor] != this->ranks_[point])
      {
        this->addEdge(point, *neighbor, lowest);
      }
    }
    for (const Closest& closest : this->closest_)
    {
      if (std::isfinite(closest.distance))
      {
        result.push_back(closest.crossing);
      }
    }
  }

private:
  struct Closest
  {
    LeveledCrossing crossing{};
    double distance = INFINITY;
  };

  void addEdge(Index point, Index neighbor, Index lowest)
  {
    const double here = this->function_.values[point];
    const double there = this->function_.values[neighbor];
    const auto [first, last] = std::minmax(this->ranks_[point], this->ranks_[neighbor]);
    const double length =
      (this->function_.graph.points().col(neighbor) - this->function_.graph.points().col(point))
        .norm();
    for (Index level = first; level < last; ++level)
    {
      // The ends lie on different sides, so they differ; rounding may still leave [0, 1].
      const double parameter = std::clamp((this->levels_[level] - here) / (there - here), 0.0, 1.0);
      Closest& closest = this->closest_[level - lowest];
      // The other half belongs to the neighbor, if it knows of this edge.
      if (parameter * length < closest.distance &&
        (parameter <= 0.5 || !this->function_.graph.isEdge(neighbor, point)))
      {
        closest = { { level, { point, neighbor, parameter } }, parameter * length };
      }
    }
  }

  const SampledFunction& function_;
  const std::vector<double>& levels_;
  const std::vector<Index>& ranks_;
  std::vector<Closest> closest_;
};

} // namespace

LevelCrossings thinned(
  const LevelCrossings& crossings, const NeighborGraph& graph, double spacing, const Poll& poll)
{
  // The k-th neighbor is about sqrt(k / pi) steps away; farther points are reached in hops.
  const double hopLength = 2.0;
  const int hops = std::max(1, static_cast<int>(std::lround(spacing / hopLength)));
  const auto neighbors =
    static_cast<std::ptrdiff_t>(std::ceil(Pi * std::pow(std::min(spacing, hopLength), 2)));

  std::vector<bool> isBlocked(graph.pointCount(), false);
  std::vector<bool> isReached(graph.pointCount(), false);
  std::vector<Index> reached;
  const auto reach = [&](Index point)
  {
    if (!isReached[point])
    {
      isReached[point] = true;
      reached.push_back(point);
    }
  };
  const auto blockAround = [&](Index point)
  {
    reached.clear();
    reach(point);
    std::size_t begin = 0;
    for (int hop = 0; hop < hops; ++hop)
    {
      const std::size_t end = reached.size();
      for (; begin < end; ++begin)
      {
        const Neighbors around = graph.neighbors(reached[begin]);
        std::for_each(around.begin(), std::min(around.end(), around.begin() + neighbors), reach);
      }
    }
    for (const Index other : reached)
    {
      isReached[other] = false;
      isBlocked[other] = true;
    }
  };

  LevelCrossings result;
  for (const EdgeCrossing& crossing : crossings)
  {
    if (!isBlocked[crossing.from])
    {
      poll();
      result.push_back(crossing);
      blockAround(crossing.from);
    }
  }
  return result;
}

LevelCrossings chained(const LevelCrossings& crossings, const NeighborGraph& graph)
{
  std::vector<bool> isLeft(graph.pointCount(), false);
  for (const EdgeCrossing& crossing : crossings)
  {
    isLeft[crossing.from] = true;
  }
  LevelCrossings result;
  result.reserve(crossings.size());
  for (const EdgeCrossing& start : crossings)
  {
    Index point = start.from;
    while (isLeft[point])
    {
      isLeft[point] = false;
      result.push_back(*std::lower_bound(crossings.begin(), crossings.end(), point,
        [](const EdgeCrossing& crossing, Index other) { return crossing.from < other; }));
      const Neighbors around = graph.neighbors(point);
      const Index* next =
        std::find_if(around.begin(), around.end(), [&](Index other) { return isLeft[other]; });
      point = next != around.end() ? *next : point;
    }
  }
  return result;
}

std::vector<LevelCrossings> findCrossings(
  const SampledFunction& function, const std::vector<double>& levels, const Execution& execution)
{
  const std::vector<Index> ranks = rankValues(function.values, levels, execution.part(0.0, 0.2));
  std::vector<std::vector<LeveledCrossing>> blocks((ranks.size() + Grain - 1) / Grain);
  parallelFor(ranks.size(), Grain, execution.part(0.2, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      PointCrossings crossings(function, levels, ranks);
      for (std::size_t i = begin; i < end; ++i)
      {
        crossings.append(static_cast<Index>(i), blocks[begin / Grain]);
      }
    });
  std::vector<LevelCrossings> result(levels.size());
  for (const std::vector<LeveledCrossing>& block : blocks)
  {
    for (const LeveledCrossing& crossing : block)
    {
      result[crossing.level].push_back(crossing.crossing);
    }
  }
  return result;
}

} // namespace SurfaceScalars
