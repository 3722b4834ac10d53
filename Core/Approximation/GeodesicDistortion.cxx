#include "DistortionIntervals.h"
#include "MeshFront.h"
#include "MeshValues.h"
#include "Polyline.h"
#include "Require.h"
#include "StraightWays.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t IntervalsPerFront = 8; // which takes memory for all vertices
// Where two parts of a front meet it may be ahead of straight ways: seldom by this factor, hardly
// ever by that, if triangles are stretched.
constexpr double Ahead = 1.05;
constexpr double FarAhead = 1.5;
constexpr std::size_t ViewsPerVertex = 6; // that the front has reached: takes as long as that

class Geodesics
{
public:
  Geodesics(const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values,
    const ValuesRef& isoValues, const std::vector<Index>& ranks)
    : vertices_(vertices)
    , mesh_(mesh)
    , values_(values)
    , isoValues_(isoValues)
    , ranks_(ranks)
    , front_(vertices, mesh)
  {
  }

  /// The greatest distance of a point of one level set to the curve that is the other.
  double farthest(const CrossedCells& crossed, Index from, Index to, const Poll& poll)
  {
    const LevelCurve curve = this->curve(to);
    this->start(curve, crossed.of(to));
    const CrossedCells::Range triangles = crossed.of(from);
    std::vector<Index> targets;
    for (const Index triangle : triangles)
    {
      const auto corners = this->mesh_.triangles().col(triangle);
      targets.insert(targets.end(), corners.begin(), corners.end());
    }
    this->front_.reach(targets, poll);
    return this->farthestOf(this->placesOn(this->curve(from), triangles, curve), curve, poll);
  }

private:
  /// A point of a level set, on an edge.
  struct Place
  {
    Index a; ///< a < b
    Index b;
    Vector3d position;
    double distance; ///< as the front has it
  };

  LevelCurve curve(Index level) const
  {
    return { this->vertices_, this->values_, this->ranks_, level, this->isoValues_[level] };
  }

  void start(const LevelCurve& curve, const CrossedCells::Range& triangles)
  {
    this->front_.clear();
    for (const Index triangle : triangles)
    {
      const auto corners = this->mesh_.triangles().col(triangle);
      for (const Index corner : corners)
      {
        this->front_.offer(corner, distanceWithin(curve, corners, this->vertices_.col(corner)));
      }
    }
  }

  /// Of a place in a triangle to the curve there.
  template <class Corners>
  static double distanceWithin(
    const LevelCurve& curve, const Corners& corners, const Vector3d& place)
  {
    const auto ends = curve.aloneFirst(corners);
    return distanceToSegment(place, curve.place(ends[0], ends[1]), curve.place(ends[0], ends[2]));
  }

  /// The points of one level set, each once, with their distances to the other.
  std::vector<Place> placesOn(
    const LevelCurve& from, const CrossedCells::Range& triangles, const LevelCurve& to) const
  {
    std::vector<Place> places;
    for (const Index triangle : triangles)
    {
      const auto corners = this->mesh_.triangles().col(triangle);
      const auto ends = from.aloneFirst(corners);
      for (const int i : { 1, 2 })
      {
        const auto [a, b] = std::minmax(ends[0], ends[i]);
        const Vector3d position = from.place(a, b);
        double distance = std::min(this->front_.across(position, a, ends[3 - i]),
          this->front_.across(position, b, ends[3 - i]));
        if (to.meets(corners))
        {
          distance = std::min(distance, distanceWithin(to, corners, position));
        }
        places.push_back({ a, b, position, distance });
      }
    }
    const auto key = [](const Place& place)
    { return std::make_tuple(place.a, place.b, place.distance); };
    std::sort(places.begin(), places.end(),
      [&](const Place& one, const Place& other) { return key(one) < key(other); });
    const auto last = std::unique(places.begin(), places.end(),
      [](const Place& one, const Place& other) { return one.a == other.a && one.b == other.b; });
    places.erase(last, places.end());
    return places;
  }

  /// The greatest distance, by straight ways. The farthest places come first, so that few have to
  /// be looked at.
  double farthestOf(std::vector<Place> places, const LevelCurve& to, const Poll& poll) const
  {
    std::sort(places.begin(), places.end(),
      [](const Place& one, const Place& other) { return one.distance > other.distance; });
    StraightWays ways(this->mesh_, to, this->front_, ViewsPerVertex * this->front_.reachedCount());
    double farthest = 0.0;
    for (const Place& place : places)
    {
      if (Ahead * place.distance <= farthest || std::isinf(place.distance))
      {
        return std::max(farthest, place.distance);
      }
      poll();
      const double straight =
        ways.shortest(place.position, place.a, place.b, FarAhead * place.distance);
      const bool isKnown = std::isfinite(straight) && !ways.isExhausted();
      farthest = std::max(farthest, isKnown ? straight : place.distance);
    }
    return farthest;
  }

  const PointsRef& vertices_;
  const MeshTopology& mesh_;
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
  checkVertexValues(mesh.vertexCount(), values);
  checkValueRange(values);
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
