#include "MeshCriticalPoints.h"

#include "MergeTrees.h"
#include "MergeTreesBuilder.h"
#include "MeshValues.h"
#include "MirroredMesh.h"
#include "Require.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

MergeTrees meshMergeTrees(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution)
{
  const MeshLinks neighborsOf{ mesh };
  const ValueOrder isBelow{ values.data() };
  return MergeTreesBuilder(mesh.vertexCount(), neighborsOf, isBelow, execution).build();
}

/// An image comes right after its vertex: what is symmetric remains so.
struct MirroredOrder
{
  const MirroredMesh& mesh;
  ValueOrder ofOriginals;

  double value(Index vertex) const { return this->ofOriginals.value(this->mesh.original(vertex)); }
  bool operator()(Index a, Index b) const
  {
    const Index first = this->mesh.original(a);
    const Index second = this->mesh.original(b);
    return first == second ? a < b : this->ofOriginals(first, second);
  }
};

MergeTrees mirroredMergeTrees(
  const MirroredMesh& mirrored, const ValuesRef& values, const Execution& execution)
{
  const auto neighborsOf = [&](Index vertex) { return mirrored.neighbors(vertex); };
  const MirroredOrder isBelow{ mirrored, { values.data() } };
  return MergeTreesBuilder(mirrored.count(), neighborsOf, isBelow, execution).build();
}

class PairCollector
{
public:
  PairCollector(const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values,
    const VertexTypes& types)
    : mesh_(mesh)
    , values_(values)
    , pointOfVertex_(mesh.vertexCount(), 0)
  {
    const std::size_t most =
      std::size_t(types.counts.minima) + types.counts.saddles + types.counts.maxima;
    this->result_.points.reserve(most);
    this->result_.pairs.reserve(most / 2);
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    {
      if (types.types[vertex] != CriticalType::Regular)
      {
        this->pointOfVertex_[vertex] = static_cast<Index>(this->result_.points.size());
        CriticalPoint point;
        point.position = vertices.col(vertex);
        point.type = types.types[vertex];
        point.multiplicity = static_cast<int>(types.multiplicities[vertex]);
        point.value = values[vertex];
        point.input = vertex;
        this->result_.points.push_back(point);
      }
    }
    this->ended_.assign(this->result_.points.size(), 0);
  }

  void add(const MergeTree& tree)
  {
    const MirroredMesh mirrored(this->mesh_);
    for (const Merge& merge : tree.merges)
    {
      const Index extremum = mirrored.original(merge.younger);
      const Index saddle = mirrored.original(merge.vertex);
      const CriticalPair pair{ this->pointOfVertex_[extremum], this->pointOfVertex_[saddle],
        std::abs(this->values_[saddle] - this->values_[extremum]) };
      for (const std::size_t point : { pair.extremum, pair.saddle })
      {
        ++this->ended_[point];
        double& persistence = this->result_.points[point].persistence;
        persistence = std::max(persistence, pair.persistence);
      }
      if (!mirrored.isImage(merge.vertex))
      {
        this->result_.pairs.push_back(pair);
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
  const MeshTopology& mesh_;
  const ValuesRef& values_;
  std::vector<Index> pointOfVertex_; ///< of critical ones
  std::vector<int> ended_;           ///< in how many pairs each point is, with its image
  MeshCriticalPoints result_;
};

} // namespace

CriticalCounts countsOf(const std::vector<CriticalPoint>& points)
{
  CriticalCounts counts;
  for (const CriticalPoint& point : points)
  {
    Index& count = point.type == CriticalType::Minimum ? counts.minima
      : point.type == CriticalType::Maximum            ? counts.maxima
                                                       : counts.saddles;
    count += static_cast<Index>(point.multiplicity);
  }
  return counts;
}

void removeUpToDelta(std::vector<CriticalPoint>& points, const ValuesRef& deltas, double delta)
{
  const auto isSmall = [&](const CriticalPoint& point)
  { return delta > 0.0 && deltas[static_cast<Eigen::Index>(point.input)] <= delta; };
  points.erase(std::remove_if(points.begin(), points.end(), isSmall), points.end());
}

PersistencePairs persistencePairs(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution)
{
  checkMeshValues(mesh, values);
  return pairsOf(meshMergeTrees(mesh, values, execution), values);
}

MeshCriticalPoints meshCriticalPoints(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const Execution& execution)
{
  require(vertices.cols() == mesh.vertexCount(), "one place per vertex",
    std::to_string(vertices.cols()) + " places for " + std::to_string(mesh.vertexCount()) +
      " vertices",
    "Choose the vertices of the mesh.");
  const VertexTypes types = classifyVertices(mesh, values, execution.part(0.0, 0.1));
  const Execution ofTrees = execution.part(0.1, 0.9);
  const MergeTrees trees = mesh.isClosed()
    ? meshMergeTrees(mesh, values, ofTrees)
    : mirroredMergeTrees(MirroredMesh(mesh), values, ofTrees);
  PairCollector collector(vertices, mesh, values, types);
  collector.add(trees.sublevel);
  collector.add(trees.superlevel);
  MeshCriticalPoints result = collector.conclude();
  execution.report(1.0);
  return result;
}

} // namespace SurfaceScalars
