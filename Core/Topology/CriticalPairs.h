#pragma once

#include "MergeTree.h"
#include "MergeTreesBuilder.h"
#include "MeshCriticalPoints.h"
#include "MirroredMesh.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
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

/// Gives critical vertices of a mesh or volume their pairs and persistence.
template <class Topology>
class PairCollector
{
public:
  PairCollector(const Topology& mesh, const ValuesRef& values, std::vector<CriticalPoint> points)
    : mesh_(mesh)
    , values_(values)
    , result_{ std::move(points), {} }
    , listed_(this->result_.points.size(), 0)
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
      const Index extremum = mirrored.original(merge.younger);
      const Index saddle = mirrored.original(merge.vertex);
      const CriticalPair pair{ pointOfVertex[extremum], pointOfVertex[saddle],
        std::abs(this->values_[saddle] - this->values_[extremum]) };
      this->end(pair.extremum, pair.persistence);
      this->end(pair.saddle, pair.persistence);
      if (!mirrored.isImage(merge.vertex))
      {
        this->list(pair);
      }
    }
  }

  /// A pair of two saddles, which is one of each. What a saddle has beyond its multiplicity, as it
  /// can where the volume is no manifold, is not among the pairs.
  /// @param areImages of vertices that are not on the boundary
  void add(std::size_t oneSaddle, std::size_t twoSaddle, bool areImages)
  {
    const std::vector<CriticalPoint>& points = this->result_.points;
    const double persistence = std::abs(points[twoSaddle].value - points[oneSaddle].value);
    for (const auto& [other, saddle] :
      { std::pair(oneSaddle, twoSaddle), std::pair(twoSaddle, oneSaddle) })
    {
      this->end(saddle, persistence);
      if (!areImages || this->mesh_.isBoundary(static_cast<Index>(points[saddle].input)))
      {
        this->list({ other, saddle, persistence });
      }
    }
  }

  /// What is not cancelled as often as it is there has f's range.
  MeshCriticalPoints conclude()
  {
    const double range = this->values_.maxCoeff() - this->values_.minCoeff();
    for (std::size_t i = 0; i < this->ended_.size(); ++i)
    {
      CriticalPoint& point = this->result_.points[i];
      const bool isSingle =
        this->mesh_.isClosed() || this->mesh_.isBoundary(static_cast<Index>(point.input));
      if (this->ended_[i] < point.multiplicity * (isSingle ? 1 : 2))
      {
        point.persistence = range;
      }
    }
    return std::move(this->result_);
  }

private:
  void end(std::size_t point, double pairPersistence)
  {
    ++this->ended_[point];
    double& persistence = this->result_.points[point].persistence;
    persistence = std::max(persistence, pairPersistence);
  }

  void list(const CriticalPair& pair)
  {
    if (this->listed_[pair.saddle] < this->result_.points[pair.saddle].multiplicity)
    {
      ++this->listed_[pair.saddle];
      this->result_.pairs.push_back(pair);
    }
  }

  const Topology& mesh_;
  const ValuesRef& values_;
  MeshCriticalPoints result_;
  std::vector<int> listed_; ///< of how many pairs each point is the saddle
  std::vector<int> ended_;  ///< in how many pairs each point is, with its image
};

} // namespace SurfaceScalars
