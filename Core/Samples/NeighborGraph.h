#pragma once

#include "PointCloud.h"
#include "SurfaceScalarsCoreExport.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// Which samples count as neighbors.
struct NeighborQuery
{
  int count = 16;      ///< k, the point itself not counted
  double radius = 0.0; ///< sigma, length units; > 0 replaces count
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
 * An edge (i, j) exists if i is among the neighbors of j or j among those of i.
 *
 * Time O(n log n); memory 4 (k + 2) bytes per point beside the cloud. Results do not depend on the
 * number of threads.
 */
class SURFACESCALARSCORE_EXPORT NeighborGraph : public PointCloud
{
public:
  /// @param points 3 x n, finite, length units
  /// @throws InvalidInput if fewer than two points are distinct; Aborted
  NeighborGraph(
    const PointsRef& points, const NeighborQuery& query, const Execution& execution = {});

  Neighbors neighbors(Index point) const
  {
    const Index* indices = this->indices_.data();
    return { indices + this->begin(point), indices + this->begin(point + 1) };
  }
  bool isEdge(Index from, Index to) const; ///< whether `to` is stored as neighbor of `from`

  double samplingStep(Index point) const; ///< 1 / sqrt(density), density = k / (pi sigma_k^2)
  double medianSamplingStep() const;      ///< the paper's epsilon, as a length

private:
  std::size_t begin(Index point) const
  {
    return this->offsets_.empty() ? point * this->count_ : this->offsets_[point];
  }
  void linkNearest(const Execution& execution);
  void linkWithin(const Execution& execution);
  double measureStep(Index point) const;
  void measureSteps(const Execution& execution);

  NeighborQuery query_;
  std::size_t count_ = 0;            ///< neighbors of each point if query_.radius is 0
  std::vector<std::size_t> offsets_; ///< CSR row starts; empty if every point has count_ neighbors
  std::vector<Index> indices_;
  std::vector<double> steps_; ///< sampling steps
  double medianStep_ = 0.0;
};

} // namespace SurfaceScalars
