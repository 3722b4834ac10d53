#include "GeodesicDistance.h"

#include "Front.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 512; // points in a block of a parallel loop
// Between two reports. Where all points are neighbors of all, each takes millions.
constexpr std::size_t MostWays = 1 << 19;
constexpr double Infinity = std::numeric_limits<double>::infinity();

using Edge = std::pair<Index, Index>;

/// For each point those that store it as their neighbor without being stored by it.
class ReverseNeighbors
{
public:
  ReverseNeighbors(const NeighborGraph& graph, const Execution& execution);

  Neighbors of(Index point) const
  {
    const Index* sources = this->sources_.data();
    return { sources + this->offsets_[point], sources + this->offsets_[point + 1] };
  }

private:
  std::vector<std::size_t> offsets_;
  std::vector<Index> sources_;
};

ReverseNeighbors::ReverseNeighbors(const NeighborGraph& graph, const Execution& execution)
  : offsets_(graph.pointCount() + 1)
{
  const std::size_t points = graph.pointCount();
  std::vector<std::vector<Edge>> blocks((points + Grain - 1) / Grain);
  parallelFor(points, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto from = static_cast<Index>(begin); from < end; ++from)
      {
        for (const Index to : graph.neighbors(from))
        {
          if (!graph.isEdge(to, from))
          {
            blocks[begin / Grain].emplace_back(from, to);
          }
        }
      }
    });
  const auto forEachEdge = [&](const auto& visit)
  {
    for (const std::vector<Edge>& block : blocks)
    {
      std::for_each(block.begin(), block.end(), visit);
    }
  };
  forEachEdge([this](const Edge& edge) { ++this->offsets_[edge.second]; });
  for (std::size_t point = 0, sum = 0; point <= points; ++point)
  {
    sum += this->offsets_[point];
    this->offsets_[point] = sum; // one past the last, until the edges are filled in
  }
  this->sources_.resize(this->offsets_.back());
  forEachEdge(
    [this](const Edge& edge) { this->sources_[--this->offsets_[edge.second]] = edge.first; });
}

/// A point with two neighbors, the distances of which are known.
struct Triangle
{
  double toFirst; ///< lengths of the sides
  double toSecond;
  double between;
  double first; ///< distances
  double second;

  /// The wider the angle at the point, the less the front between the neighbors is known.
  bool isAcute() const
  {
    return this->between * this->between <=
      this->toFirst * this->toFirst + this->toSecond * this->toSecond;
  }
};

/**
 * The distance of the point if the straight way from the source crosses the segment between the
 * neighbors; infinite if it passes beside it.
 *
 * In the plane of the triangle the first neighbor is the origin, the second lies on the x axis, the
 * point above it and the source below.
 */
double unfoldedDistance(const Triangle& triangle)
{
  const double width = triangle.between;
  const auto place = [width](double toFirst, double toSecond)
  {
    const double x = 0.5 * ((toFirst - toSecond) * (toFirst + toSecond) / width + width);
    return Vector2d(x, std::sqrt((toFirst - x) * (toFirst + x)));
  };
  const Vector2d point = place(triangle.toFirst, triangle.toSecond);
  const Vector2d source = place(triangle.first, triangle.second);
  const double height = point.y() + source.y();
  const double crossing = (source.x() * point.y() + point.x() * source.y()) / height;
  // False as well for distances that no plane allows: not a number.
  const bool isBetween = crossing >= 0.0 && crossing <= width;
  return isBetween ? Vector2d(point.x() - source.x(), height).norm() : Infinity;
}

/// The front that starts at the sources.
class March
{
public:
  March(const NeighborGraph& graph, const std::vector<Index>& sources, const Execution& execution)
    : graph_(graph)
    , reverse_(graph, execution.part(0.0, 0.1))
    , front_(graph.pointCount())
    , isPassed_(graph.pointCount(), 0)
  {
    for (const Index source : sources)
    {
      this->front_.offer(source, 0.0);
    }
  }

  Values run(const Execution& execution);

private:
  double length(Index from, Index to) const
  {
    return (this->graph_.points().col(from) - this->graph_.points().col(to)).norm();
  }

  template <class Visit>
  void forEachNeighbor(Index point, const Visit& visit) const
  {
    const Neighbors stored = this->graph_.neighbors(point);
    const Neighbors reverse = this->reverse_.of(point);
    std::for_each(stored.begin(), stored.end(), visit);
    std::for_each(reverse.begin(), reverse.end(), visit);
  }

  std::size_t neighborCount(Index point) const
  {
    return this->graph_.neighbors(point).size() + this->reverse_.of(point).size();
  }

  double distanceThrough(Index passed, Index point) const;

  const NeighborGraph& graph_;
  ReverseNeighbors reverse_;
  Front front_;
  std::vector<char> isPassed_;
};

/// The shortest way to a point from the neighbor that was passed last, or across the segment
/// between it and another that was passed before.
double March::distanceThrough(Index passed, Index point) const
{
  Triangle triangle{};
  triangle.first = this->front_.distance(passed);
  triangle.toFirst = this->length(point, passed);
  double distance = triangle.first + triangle.toFirst;
  this->forEachNeighbor(point,
    [&](Index other)
    {
      if (this->isPassed_[other] != 0 && other != passed)
      {
        triangle.second = this->front_.distance(other);
        triangle.toSecond = this->length(point, other);
        triangle.between = this->length(passed, other);
        if (triangle.isAcute())
        {
          distance = std::min(distance, unfoldedDistance(triangle));
        }
      }
    });
  return distance;
}

Values March::run(const Execution& execution)
{
  const auto count = static_cast<double>(this->graph_.pointCount());
  std::size_t ways = 0; // since the last report
  std::size_t passed = 0;
  for (Index point = 0; this->front_.pass(point); ++passed)
  {
    this->isPassed_[point] = 1;
    this->forEachNeighbor(point,
      [&](Index next)
      {
        if (this->isPassed_[next] == 0)
        {
          this->front_.offer(next, this->distanceThrough(point, next));
          ways += this->neighborCount(next);
        }
        if (ways > MostWays)
        {
          execution.report(static_cast<double>(passed) / count);
          ways = 0;
        }
      });
  }
  execution.report(1.0);
  return this->front_.distances();
}

void checkSources(const NeighborGraph& graph, const std::vector<Index>& sources)
{
  require(!sources.empty(), "at least 1 source", "none", "Choose a point to measure from.");
  const Index largest = *std::max_element(sources.begin(), sources.end());
  require(largest < graph.pointCount(),
    "sources among the " + std::to_string(graph.pointCount()) + " points, counted from 0",
    std::to_string(largest), "Choose existing points.");
}

} // namespace

Values geodesicDistance(
  const NeighborGraph& graph, const std::vector<Index>& sources, const Execution& execution)
{
  checkSources(graph, sources);
  return March(graph, sources, execution).run(execution.part(0.1, 1.0));
}

} // namespace SurfaceScalars
