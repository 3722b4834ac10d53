#pragma once

#include "Basics.h"
#include "Execution.h"
#include "SurfaceScalarsCoreExport.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// Which samples count as neighbors.
struct NeighborQuery
{
  int count = 16;      ///< k, the point itself not counted
  double radius = 0.0; ///< sigma, length units; > 0 replaces count
};

/// Points found around a place, nearest first.
struct Neighborhood
{
  std::vector<Index> indices;
  std::vector<double> squaredDistances;
};

/// The stored neighbors of a point: a view into the graph, nearest first.
struct Neighbors
{
  const Index* first;
  const Index* last;
  const Index* begin() const { return this->first; }
  const Index* end() const { return this->last; }
  std::size_t size() const { return static_cast<std::size_t>(this->last - this->first); }
};

/**
 * The neighbor graph T of a point set: the domain on which every point-set algorithm works
 * (point-set paper, sec. 2.1).
 *
 * Points are centered, exact duplicates become one point, and the rest is sorted along a Morton
 * curve so that neighbors lie close in memory. Every index below is in that order; pointOfInput()
 * and inputOfPoint() lead there and back.
 *
 * An edge (i, j) exists if i is among the neighbors of j or j among those of i.
 *
 * Time O(n log n); memory 4 (k + 2) bytes per point beside the points and the search tree. Results
 * do not depend on the number of threads.
 */
class SURFACESCALARSCORE_EXPORT NeighborGraph
{
public:
  /// @param points 3 x n, finite, length units
  /// @throws InvalidInput if fewer than two points are distinct; Aborted
  NeighborGraph(
    const PointsRef& points, const NeighborQuery& query, const Execution& execution = {});
  ~NeighborGraph();
  NeighborGraph(NeighborGraph&&) noexcept;
  NeighborGraph& operator=(NeighborGraph&&) noexcept;

  Index pointCount() const;       ///< distinct points
  const Points& points() const;   ///< relative to origin()
  const Vector3d& origin() const; ///< center of the input's bounding box

  Neighbors neighbors(Index point) const;
  bool isEdge(Index from, Index to) const; ///< whether `to` is stored as neighbor of `from`

  double samplingStep(Index point) const; ///< 1 / sqrt(density), density = k / (pi sigma_k^2)
  double medianSamplingStep() const;      ///< the paper's epsilon, as a length

  Index pointOfInput(std::size_t input) const;
  std::size_t inputOfPoint(Index point) const; ///< the first of its duplicates
  std::size_t inputCount() const;

  /// @param values one per input point @returns one per point of the graph: the mean over its
  /// duplicates
  Values average(const ValuesRef& values) const;

  /// The `count` points nearest to `place` (relative to origin()), at most all.
  void nearest(const Vector3d& place, int count, Neighborhood& result) const;
  /// All points closer to `place` than `radius`.
  void within(const Vector3d& place, double radius, Neighborhood& result) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace SurfaceScalars
