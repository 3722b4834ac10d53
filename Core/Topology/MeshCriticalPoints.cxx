#include "MeshCriticalPoints.h"

#include "CriticalPairs.h"
#include "MergeTrees.h"
#include "MergeTreesBuilder.h"
#include "MeshValues.h"
#include "ValueOrder.h"

#include <algorithm>
#include <string>
#include <utility>

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

/// @param pointOfVertex gets the positions of the points in the list
std::vector<CriticalPoint> criticalPoints(const PointsRef& vertices, const ValuesRef& values,
  const VertexTypes& types, std::vector<Index>& pointOfVertex)
{
  std::vector<CriticalPoint> points;
  points.reserve(std::size_t(types.counts.minima) + types.counts.saddles + types.counts.maxima);
  for (Index vertex = 0; vertex < pointOfVertex.size(); ++vertex)
  {
    if (types.types[vertex] != CriticalType::Regular)
    {
      pointOfVertex[vertex] = static_cast<Index>(points.size());
      points.push_back(criticalVertex(
        vertices, values, vertex, types.types[vertex], types.multiplicities[vertex]));
    }
  }
  return points;
}

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
  checkVertexValues(mesh.vertexCount(), values);
  return pairsOf(meshMergeTrees(mesh, values, execution), values);
}

MeshCriticalPoints meshCriticalPoints(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const Execution& execution)
{
  checkVertexPlaces(mesh.vertexCount(), vertices, "mesh");
  const VertexTypes types = classifyVertices(mesh, values, execution.part(0.0, 0.1));
  const Execution ofTrees = execution.part(0.1, 0.9);
  const MergeTrees trees = mesh.isClosed() ? meshMergeTrees(mesh, values, ofTrees)
                                           : mirroredMergeTrees(mesh, values, ofTrees);
  std::vector<Index> pointOfVertex(mesh.vertexCount(), 0);
  PairCollector collector(mesh, values, criticalPoints(vertices, values, types, pointOfVertex));
  collector.add(trees.sublevel, pointOfVertex);
  collector.add(trees.superlevel, pointOfVertex);
  MeshCriticalPoints result = collector.conclude();
  execution.report(1.0);
  return result;
}

} // namespace SurfaceScalars
