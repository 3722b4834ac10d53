#pragma once

#include "CriticalPoint.h"
#include "MeshTopology.h"
#include "Persistence.h"

#include <vector>

namespace SurfaceScalars
{

/// How many critical points; saddles with their multiplicity.
struct CriticalCounts
{
  Index minima = 0;
  Index saddles = 0;
  Index maxima = 0;
};

/// What each vertex is to a function.
struct VertexTypes
{
  std::vector<CriticalType> types;
  std::vector<Index> multiplicities; ///< m of saddles, 1 of extrema, 0 of regular vertices
  CriticalCounts counts;
};

/**
 * The types of the vertices (smoothing paper, sec. 3, delta = 0; Banchoff), ties by index
 * (simulation of simplicity), so that constant functions too have a minimum and a maximum.
 *
 * In each triangle the middle vertex counts one: the link of an interior vertex changes its sign as
 * often as it is in the middle, 0 = extremum, 2 = regular, 2 + 2m = saddle of multiplicity m. A
 * vertex on the boundary is what it is on the mesh glued to its mirror image along the boundary (as
 * is the natural boundary condition): c changes of its link make 2c there.
 *
 * Euler's formula holds identically: minima - saddles + maxima, where boundary vertices count
 * half, is the Euler characteristic.
 *
 * @param values one per vertex, finite
 * @throws InvalidInput for other values; Aborted
 */
SURFACESCALARSCORE_EXPORT VertexTypes classifyVertices(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution = {});

/**
 * Up to which delta a critical vertex is one (smoothing paper, sec. 3; as printed, nearly every
 * vertex would be both a maximum and a minimum for large delta, see Documentation/equations.md):
 * f's unit, 0 for regular vertices. C_delta is {threshold > delta}, and all for delta = 0: nested.
 *
 * Of an extremum: the least |f_j - f_i| of its link. Of a saddle: the largest delta below which the
 * signs of f_j - f_i around the link, those of at most delta in magnitude left out, still change
 * four times; at the boundary there and back.
 *
 * @param types of the values
 * @throws as classifyVertices()
 */
SURFACESCALARSCORE_EXPORT Values deltaThresholds(const MeshTopology& mesh, const ValuesRef& values,
  const VertexTypes& types, const Execution& execution = {});

/// The extremum-saddle pairs by union-find along the edges, as on a graph (Persistence.h).
/// @throws as classifyVertices()
SURFACESCALARSCORE_EXPORT PersistencePairs persistencePairs(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution = {});

struct MeshCriticalPoints
{
  std::vector<CriticalPoint> points; ///< by vertex; `input` is the vertex
  std::vector<CriticalPair> pairs;   ///< indices into points; of volumes, of two saddles as well
};

/**
 * The critical vertices with their persistence: that of its pair, of a saddle the largest of those
 * it ends, f's range if it ends fewer than its multiplicity (a handle) and for the global minimum
 * and maximum of each component. On a closed mesh removeBelow() (Persistence.h) keeps the sum of
 * the indices.
 *
 * On a mesh with boundary the pairs are those on the mesh glued to its mirror image. A vertex that
 * is not on the boundary stands for its image, too, whose pairs may be others. A point has the
 * largest persistence of both (of extrema, that on the mesh itself), a saddle every second pair of
 * both, the most persistent first. So removeBelow() keeps what has the threshold's persistence, and
 * nothing else; of a saddle half the multiplicity that both keep, rounded up. The sum of the
 * indices, those of the boundary counted half, grows by half the indices of what one of the two
 * keeps alone. No other rule keeps both promises: of a hollow near the boundary and its image one
 * ends at the low saddle between them, which is on the boundary, and the other lasts.
 *
 * @throws as classifyVertices(); InvalidInput unless there is one place per vertex
 */
SURFACESCALARSCORE_EXPORT MeshCriticalPoints meshCriticalPoints(const PointsRef& vertices,
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution = {});

/// @param points minima, saddles and maxima
SURFACESCALARSCORE_EXPORT CriticalCounts countsOf(const std::vector<CriticalPoint>& points);

/// Keeps C_delta (smoothing paper, sec. 3).
/// @param deltas of all vertices, see deltaThresholds() @param delta f's unit; 0 keeps all
SURFACESCALARSCORE_EXPORT void removeUpToDelta(
  std::vector<CriticalPoint>& points, const ValuesRef& deltas, double delta);

} // namespace SurfaceScalars
