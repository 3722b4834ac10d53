#include "DistortionIntervals.h"
#include "MeshFront.h"
#include "Polyline.h"
#include "Require.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t IntervalsPerFront = 8; // which takes memory for all vertices

/// Where a value meets a triangle: on the two edges of the corner that is alone on its side.
struct TriangleCrossing
{
  Index corner = 0;
  Index others[2] = { 0, 0 };
  Vector3d places[2]; ///< on the edges to these
};

class Geodesics
{
public:
  Geodesics(const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values,
    const ValuesRef& isoValues, const std::vector<Index>& ranks)
    : vertices_(vertices)
    , triangles_(mesh.triangles())
    , values_(values)
    , isoValues_(isoValues)
    , ranks_(ranks)
    , front_(vertices, mesh)
  {
  }

  /// The greatest distance of a point of one level set to the curve that is the other.
  double farthest(const CrossedCells& crossed, Index from, Index to, const Poll& poll)
  {
    this->front_.clear();
    for (const Index triangle : crossed.of(to))
    {
      const TriangleCrossing curve = this->crossing(triangle, to);
      for (const Index corner : this->triangles_.col(triangle))
      {
        this->front_.offer(
          corner, distanceToSegment(this->vertices_.col(corner), curve.places[0], curve.places[1]));
      }
    }
    const CrossedCells::Range triangles = crossed.of(from);
    std::vector<Index> targets;
    for (const Index triangle : triangles)
    {
      const auto corners = this->triangles_.col(triangle);
      targets.insert(targets.end(), corners.begin(), corners.end());
    }
    this->front_.reach(targets, poll);
    return this->farthestCrossing(triangles, from, to);
  }

private:
  /// Of a place: on which edge it is, and its distance in one of the triangles there.
  using Way = std::pair<std::uint64_t, double>;

  TriangleCrossing crossing(Index triangle, Index level) const
  {
    const auto corners = this->triangles_.col(triangle);
    const auto isAbove = [&](int i) { return this->ranks_[corners[i]] > level; };
    const int alone = isAbove(0) == isAbove(1) ? 2 : isAbove(0) == isAbove(2) ? 1 : 0;
    TriangleCrossing result;
    result.corner = corners[alone];
    for (const int i : { 0, 1 })
    {
      result.others[i] = corners[(alone + 1 + i) % 3];
      result.places[i] = crossingOf(
        this->vertices_, this->values_, result.corner, result.others[i], this->isoValues_[level]);
    }
    return result;
  }

  /// Within a triangle, from its other edges or the curve itself.
  double distanceIn(Index triangle, const TriangleCrossing& at, int i, Index to) const
  {
    const Vector3d& place = at.places[i];
    const Index opposite = at.others[1 - i];
    double distance = std::min(this->front_.across(place, at.corner, opposite),
      this->front_.across(place, at.others[i], opposite));
    if (rankRange(this->ranks_, this->triangles_.col(triangle)).crosses(to))
    {
      const TriangleCrossing curve = this->crossing(triangle, to);
      distance = std::min(distance, distanceToSegment(place, curve.places[0], curve.places[1]));
    }
    return distance;
  }

  double farthestCrossing(const CrossedCells::Range& triangles, Index from, Index to) const
  {
    std::vector<Way> ways;
    for (const Index triangle : triangles)
    {
      const TriangleCrossing at = this->crossing(triangle, from);
      for (const int i : { 0, 1 })
      {
        const auto [first, second] = std::minmax(at.corner, at.others[i]);
        ways.emplace_back(
          (std::uint64_t(first) << 32) | second, this->distanceIn(triangle, at, i, to));
      }
    }
    std::sort(ways.begin(), ways.end()); // the shorter of the ways to a place first
    double result = 0.0;
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      const bool isShortest = i == 0 || ways[i].first != ways[i - 1].first;
      result = isShortest ? std::max(result, ways[i].second) : result;
    }
    return result;
  }

  const PointsRef& vertices_;
  const Triangles& triangles_;
  const ValuesRef& values_;
  const ValuesRef& isoValues_;
  const std::vector<Index>& ranks_; ///< of the values among the iso-values
  MeshFront front_;
};

} // namespace

LevelSetDistortion geodesicDistortion(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const ValuesRef& isoValues, const ValuesRef& criticalValues,
  const Execution& execution)
{
  checkLevelValues(vertices, values);
  require(vertices.cols() == mesh.vertexCount(), "the vertices of the mesh",
    std::to_string(vertices.cols()) + " of " + std::to_string(mesh.vertexCount()),
    "Choose those of one mesh.");
  const std::vector<Index> ranks = ranksAmong(isoValues, values, { execution.threadCount, {} });
  return measureIntervals(mesh.triangles(), ranks, isoValues, criticalValues, execution,
    [&](const CrossedCells& crossed, const std::vector<Index>& intervals, double* distances,
      const Execution& part)
    {
      const std::size_t fronts = (intervals.size() + IntervalsPerFront - 1) / IntervalsPerFront;
      parallelForEach(fronts, part,
        [&](std::size_t front, const Poll& poll)
        {
          Geodesics geodesics(vertices, mesh, values, isoValues, ranks);
          const std::size_t end = std::min(intervals.size(), (front + 1) * IntervalsPerFront);
          for (std::size_t i = front * IntervalsPerFront; i < end; ++i)
          {
            const Index level = intervals[i];
            distances[i] = std::max(geodesics.farthest(crossed, level, level + 1, poll),
              geodesics.farthest(crossed, level + 1, level, poll));
          }
        });
    });
}

} // namespace SurfaceScalars
