#pragma once

#include "Execution.h"
#include "MeshTopology.h"
#include "Simplices.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

/// How far consecutive level sets are from each other (design paper, sec. 4).
struct LevelSetDistortion
{
  Values isoValues;        ///< at which intervals begin, ascending
  Values nextIsoValues;    ///< at which they end
  Values distances;        ///< between the level sets of both ends, length units
  std::size_t leftOut = 0; ///< intervals with a critical value, or with an end that has no level
                           ///< set or none that a way leads to
};

/**
 * The distortion map by the Hausdorff distance: a level set is discretized as the points in which
 * edges cross its value, f linear along them; f < value is below, f >= value above. The distance is
 * the greatest of a point of either set to the nearest of the other, through space. Where level
 * sets are closer than vertices, it measures along edges and not at right angles to them.
 *
 * Time O(c log c) for c crossings in all; memory 12 bytes per vertex and edge, and some 50 MB at
 * most for crossings.
 *
 * @param vertices 3 x n @param edges 2 x m, corners below n, see edgesOf()
 * @param values one per vertex, finite @param isoValues ascending, different
 * @param criticalValues ascending; intervals that contain one, ends included, are left out. (The
 * paper leaves out those of saddles; at that of an extremum the number of curves changes, too.)
 * @throws InvalidInput unless it is so; Aborted
 */
SURFACESCALARSCORE_EXPORT LevelSetDistortion hausdorffDistortion(const PointsRef& vertices,
  const SimplicesRef& edges, const ValuesRef& values, const ValuesRef& isoValues,
  const ValuesRef& criticalValues, const Execution& execution = {});

/**
 * The same by the distance along the surface: of the points in which edges cross one value to the
 * curve that f, linear on triangles, makes of the other, by the shortest straight way over unfolded
 * triangles (StraightWays.h), never too short and on a flat mesh exact.
 *
 * A front from the curve says which points are farthest. What it says, on average too much, is
 * taken where a way has to bend, and of level sets so many edges apart that following straight ways
 * would take longer than the front. Where triangles are large against the bends of the curve it may
 * miss the farthest point: between circles of two edges and more, with triangles of 4 to 1, the
 * largest distance was up to 2% too small.
 *
 * Time in proportion to the vertices between level sets and an edge around, n at most per interval.
 *
 * @throws as hausdorffDistortion()
 */
SURFACESCALARSCORE_EXPORT LevelSetDistortion geodesicDistortion(const PointsRef& vertices,
  const MeshTopology& mesh, const ValuesRef& values, const ValuesRef& isoValues,
  const ValuesRef& criticalValues, const Execution& execution = {});

/// The largest k from 1 to `most` for which the level sets of dyadicIsoValues(values, k) cross
/// edges about `crossings` times or less.
/// @param values not all the same
SURFACESCALARSCORE_EXPORT int affordableHalvings(
  const SimplicesRef& edges, const ValuesRef& values, int most, double crossings);

/// The edges of a mesh or volume, each once. @param topology with link() and vertexCount()
template <class Topology>
Simplices edgesOf(const Topology& topology)
{
  const auto forEachEdge = [&](const auto& visit)
  {
    for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
    {
      for (const Index neighbor : topology.link(vertex))
      {
        if (vertex < neighbor)
        {
          visit(vertex, neighbor);
        }
      }
    }
  };
  Eigen::Index count = 0;
  forEachEdge([&](Index, Index) { ++count; });
  Simplices edges(2, count);
  count = 0;
  forEachEdge([&](Index from, Index to) { edges.col(count++) << from, to; });
  return edges;
}

} // namespace SurfaceScalars
