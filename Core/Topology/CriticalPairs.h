#pragma once

#include "MergeTree.h"
#include "MergeTreesBuilder.h"
#include "MeshCriticalPoints.h"
#include "MirroredMesh.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace SurfaceScalars
{

inline CriticalPoint criticalVertex(const PointsRef& vertices, const ValuesRef& values,
  Index vertex, CriticalType type, Index multiplicity)
{
  CriticalPoint point;
  point.position = vertices.col(vertex);
  point.type = type;
  point.multiplicity = static_cast<int>(multiplicity);
  point.value = values[vertex];
  point.input = vertex;
  return point;
}

/// An image comes right after its vertex: what is symmetric remains so.
template <class Topology>
struct MirroredOrder
{
  const MirroredMesh<Topology>& mesh;
  ValueOrder ofOriginals;

  double value(Index vertex) const { return this->ofOriginals.value(this->mesh.original(vertex)); }
  bool operator()(Index a, Index b) const
  {
    const Index first = this->mesh.original(a);
    const Index second = this->mesh.original(b);
    return first == second ? a < b : this->ofOriginals(first, second);
  }
};

/// Of a mesh or volume glued to its mirror image. @throws Aborted
template <class Topology>
MergeTrees mirroredMergeTrees(
  const Topology& mesh, const ValuesRef& values, const Execution& execution)
{
  const MirroredMesh<Topology> mirrored(mesh);
  const auto neighborsOf = [&](Index vertex) { return mirrored.neighbors(vertex); };
  const MirroredOrder<Topology> isBelow{ mirrored, { values.data() } };
  return MergeTreesBuilder(mirrored.count(), neighborsOf, isBelow, execution).build();
}

/**
 * Gives critical vertices of a mesh or volume their pairs and persistence.
 *
 * A vertex that is not on the boundary stands for its image, too, whose pairs may be others. By
 * descending persistence, what is never cancelled first, a saddle has every second of all these:
 * where the two agree those of one, and removeBelow() leaves half of what it leaves of both on the
 * glued mesh, rounded up.
 */
template <class Topology>
class PairCollector
{
public:
  PairCollector(const Topology& mesh, const ValuesRef& values, std::vector<CriticalPoint> points)
    : mesh_(mesh)
    , values_(values)
    , result_{ std::move(points), {} }
    , ended_(this->result_.points.size(), 0)
  {
    this->result_.pairs.reserve(this->result_.points.size() / 2);
  }

  /// @param tree of the mesh, or of it glued to its mirror image
  /// @param pointOfVertex the critical points that the extrema and saddles of this tree are
  void add(const MergeTree& tree, const std::vector<Index>& pointOfVertex)
  {
    const MirroredMesh<Topology> mirrored(this->mesh_);
    for (const Merge& merge : tree.merges)
    {
      const Index extremum = pointOfVertex[mirrored.original(merge.younger)];
      const Index saddle = pointOfVertex[mirrored.original(merge.vertex)];
      this->end(extremum, this->difference(extremum, saddle));
      this->end(saddle, this->difference(extremum, saddle));
      this->list(extremum, saddle);
    }
  }

  /// A pair of saddles, which is one of each.
  void add(Index oneSaddle, Index twoSaddle)
  {
    for (const auto& [other, saddle] :
      { std::pair(oneSaddle, twoSaddle), std::pair(twoSaddle, oneSaddle) })
    {
      this->end(saddle, this->difference(other, saddle));
      this->list(other, saddle);
    }
  }

  /// What is not cancelled as often as it is there has f's range.
  MeshCriticalPoints conclude()
  {
    const double range = this->values_.maxCoeff() - this->values_.minCoeff();
    std::vector<int> counts; // of each point: of what it lists, or would
    for (std::size_t i = 0; i < this->ended_.size(); ++i)
    {
      counts.push_back(std::max(0, this->multiplicity(i) - this->ended_[i]));
      if (counts[i] > 0)
      {
        this->result_.points[i].persistence = range;
      }
    }
    std::vector<CriticalPair>& pairs = this->result_.pairs;
    std::sort(pairs.begin(), pairs.end(),
      [](const CriticalPair& a, const CriticalPair& b)
      {
        return std::tie(a.saddle, b.persistence, a.extremum) <
          std::tie(b.saddle, a.persistence, b.extremum);
      });
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                  [&](const CriticalPair& pair)
                  {
                    const int place = counts[pair.saddle]++;
                    return place >= this->multiplicity(pair.saddle) ||
                      (this->hasImage(pair.saddle) && place % 2 != 0);
                  }),
      pairs.end());
    return std::move(this->result_);
  }

private:
  double difference(Index a, Index b) const
  {
    return std::abs(this->result_.points[a].value - this->result_.points[b].value);
  }

  void end(Index point, double pairPersistence)
  {
    ++this->ended_[point];
    double& persistence = this->result_.points[point].persistence;
    persistence = std::max(persistence, pairPersistence);
  }

  void list(Index extremum, Index saddle)
  {
    this->result_.pairs.push_back({ extremum, saddle, this->difference(extremum, saddle) });
  }

  bool hasImage(std::size_t point) const
  {
    return !this->mesh_.isClosed() &&
      !this->mesh_.isBoundary(static_cast<Index>(this->result_.points[point].input));
  }

  /// With that of the image.
  int multiplicity(std::size_t point) const
  {
    return this->result_.points[point].multiplicity * (this->hasImage(point) ? 2 : 1);
  }

  const Topology& mesh_;
  const ValuesRef& values_;
  MeshCriticalPoints result_;
  std::vector<int> ended_; ///< in how many pairs each point is, with its image
};

} // namespace SurfaceScalars
