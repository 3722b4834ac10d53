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

/// Of a saddle that is not on the boundary and of its image, which may differ.
enum class ImagePairs
{
  Without,       ///< the saddle's own
  MostPersistent ///< of both, as many as its multiplicity: removeBelow() keeps what is persistent
};

/// Gives critical vertices of a mesh or volume their pairs and persistence.
template <class Topology>
class PairCollector
{
public:
  PairCollector(const Topology& mesh, const ValuesRef& values, std::vector<CriticalPoint> points,
    ImagePairs imagePairs)
    : mesh_(mesh)
    , values_(values)
    , imagePairs_(imagePairs)
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
      if (this->imagePairs_ == ImagePairs::MostPersistent || !mirrored.isImage(merge.vertex))
      {
        this->list(extremum, saddle);
      }
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
    std::vector<int> lasting;
    for (std::size_t i = 0; i < this->ended_.size(); ++i)
    {
      CriticalPoint& point = this->result_.points[i];
      const bool isSingle =
        this->mesh_.isClosed() || this->mesh_.isBoundary(static_cast<Index>(point.input));
      lasting.push_back(std::max(0, point.multiplicity * (isSingle ? 1 : 2) - this->ended_[i]));
      if (lasting[i] > 0)
      {
        point.persistence = range;
      }
    }
    if (this->imagePairs_ == ImagePairs::MostPersistent)
    {
      this->keepMostPersistent(std::move(lasting));
    }
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

  /// @param counts of each point: of those before all pairs, that are never cancelled
  void keepMostPersistent(std::vector<int> counts)
  {
    std::vector<CriticalPair>& pairs = this->result_.pairs;
    std::sort(pairs.begin(), pairs.end(),
      [](const CriticalPair& a, const CriticalPair& b)
      {
        return std::tie(a.saddle, b.persistence, a.extremum) <
          std::tie(b.saddle, a.persistence, b.extremum);
      });
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                  [&](const CriticalPair& pair) {
                    return ++counts[pair.saddle] > this->result_.points[pair.saddle].multiplicity;
                  }),
      pairs.end());
  }

  const Topology& mesh_;
  const ValuesRef& values_;
  ImagePairs imagePairs_;
  MeshCriticalPoints result_;
  std::vector<int> ended_; ///< in how many pairs each point is, with its image
};

} // namespace SurfaceScalars
