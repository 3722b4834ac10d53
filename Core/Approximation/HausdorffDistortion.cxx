#include "DistortionIntervals.h"
#include "MeshValues.h"
#include "PointTree.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index PointsPerPoll = 4096;
constexpr double PointShare = 0.3; // of a block, to find crossings

/// The points in which edges cross a value.
struct LevelSetPoints
{
  Points points;
  std::unique_ptr<const PointTree> tree;
};

class LevelSetFinder
{
public:
  LevelSetFinder(const PointsRef& vertices, const SimplicesRef& edges, const ValuesRef& values)
    : vertices_(vertices)
    , edges_(edges)
    , values_(values)
  {
  }

  LevelSetPoints find(const CrossedCells::Range& crossed, double isoValue) const
  {
    LevelSetPoints result{ Points(3, static_cast<Eigen::Index>(crossed.size())), nullptr };
    Eigen::Index count = 0;
    for (const Index edge : crossed)
    {
      result.points.col(count++) = crossingOf(
        this->vertices_, this->values_, this->edges_(0, edge), this->edges_(1, edge), isoValue);
    }
    result.tree = std::make_unique<const PointTree>(result.points, Execution{ 1, {} });
    return result;
  }

private:
  const PointsRef& vertices_;
  const SimplicesRef& edges_;
  const ValuesRef& values_;
};

/// The greatest squared distance of a point to the nearest of the others.
double farthest(const Points& points, const PointTree& others, const Poll& poll)
{
  Neighborhood nearest;
  double result = 0.0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    if (i % PointsPerPoll == 0)
    {
      poll();
    }
    others.nearest(points.col(i), 1, nearest);
    result = std::max(result, nearest.squaredDistances.front());
  }
  return result;
}

double hausdorffDistance(const LevelSetPoints& one, const LevelSetPoints& other, const Poll& poll)
{
  return std::sqrt(
    std::max(farthest(one.points, *other.tree, poll), farthest(other.points, *one.tree, poll)));
}

} // namespace

LevelSetDistortion hausdorffDistortion(const PointsRef& vertices, const SimplicesRef& edges,
  const ValuesRef& values, const ValuesRef& isoValues, const ValuesRef& criticalValues,
  const Execution& execution)
{
  checkVertexValues(static_cast<Index>(vertices.cols()), values);
  checkValueRange(values);
  const LevelSetFinder finder(vertices, edges, values);
  const std::vector<Index> ranks = ranksAmong(isoValues, values, { execution.threadCount, {} });
  return measureIntervals(edges, ranks, isoValues, criticalValues, execution,
    [&](const CrossedCells& crossed, const std::vector<Index>& intervals, double* distances,
      const Execution& part)
    {
      const Index first = intervals.front();
      std::vector<LevelSetPoints> sets(intervals.back() + 2 - first);
      parallelForEach(sets.size(), part.part(0.0, PointShare),
        [&](std::size_t i, const Poll&)
        {
          const Index level = first + static_cast<Index>(i);
          sets[i] = finder.find(crossed.of(level), isoValues[level]);
        });
      parallelForEach(intervals.size(), part.part(PointShare, 1.0),
        [&](std::size_t i, const Poll& poll)
        {
          const std::size_t set = intervals[i] - first;
          distances[i] = hausdorffDistance(sets[set], sets[set + 1], poll);
        });
    });
}

} // namespace SurfaceScalars
