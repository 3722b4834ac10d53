#pragma once

#include "MeshCriticalPoints.h"
#include "VolumeTopology.h"

#include <cstdint>
#include <vector>

namespace SurfaceScalars
{

/// How many critical points; saddles with their multiplicity.
struct VolumeCounts
{
  Index minima = 0;
  Index oneSaddles = 0;
  Index twoSaddles = 0;
  Index maxima = 0;

  /// Of the indices of Poincare and Hopf.
  std::int64_t indexSum() const
  {
    return std::int64_t(this->minima) - this->oneSaddles + this->twoSaddles - this->maxima;
  }
};

/// What each vertex is to a function on a volume.
struct VolumeTypes
{
  std::vector<CriticalType> types; ///< of two saddles the one of larger multiplicity, of equal ones
                                   ///< the 1-saddle
  std::vector<Index> oneSaddles;   ///< multiplicity of the 1-saddle at each vertex, 0 for none
  std::vector<Index> twoSaddles;   ///< and of the 2-saddle
  VolumeCounts counts;
};

/**
 * The types of the vertices of a volume, by the parts of their links (the boundaries of their
 * stars), ties by index. Lower and upper link are what lies between the lower and between the
 * higher neighbors.
 *
 * - A minimum has no lower link, a maximum no upper one.
 * - A lower link of 1 + m components is a 1-saddle (CriticalType::Saddle) of multiplicity m: that
 *   many components of {f <= t} meet.
 * - An upper link of 1 + m components is a 2-saddle of multiplicity m.
 *
 * A vertex can be both saddles at once. A vertex on the boundary is what it is on the volume glued
 * to its mirror image along the boundary, as on meshes: components of its link that do not touch
 * the boundary count twice.
 *
 * By Alexander's duality on the sphere of a link, minima - 1-saddles + 2-saddles - maxima of each
 * vertex is 1 less the Euler characteristic of its lower link. Its sum over the vertices, those of
 * the boundary counted half, is 0 identically: the Euler characteristic of the glued volume, as of
 * every closed manifold of dimension three.
 *
 * @param values one per vertex, finite
 * @throws InvalidInput for other values; Aborted
 */
SURFACESCALARSCORE_EXPORT VolumeTypes classifyVolumeVertices(
  const VolumeTopology& volume, const ValuesRef& values, const Execution& execution = {});

/**
 * The critical vertices with their persistence, as meshCriticalPoints(): pairs of minima and
 * 1-saddles and of maxima and 2-saddles by union-find along the edges, and pairs of 1-saddles and
 * 2-saddles, between which a tunnel of {f <= t} lasts, by homology over Z2. A vertex that is both
 * saddles is two points. A pair of saddles is two pairs: in each, the other one is in the place of
 * the extremum. So removeBelow() keeps the sum of the indices of a closed manifold.
 *
 * @warning Where the volume is no manifold, a tunnel may end at a vertex that is no 2-saddle, or in
 * more pairs than its multiplicity: such are left out, and what they leave has f's range.
 *
 * @throws as classifyVolumeVertices(); InvalidInput unless there is one place per vertex
 */
SURFACESCALARSCORE_EXPORT MeshCriticalPoints volumeCriticalPoints(const PointsRef& vertices,
  const VolumeTopology& volume, const ValuesRef& values, const Execution& execution = {});

SURFACESCALARSCORE_EXPORT VolumeCounts volumeCountsOf(const std::vector<CriticalPoint>& points);

} // namespace SurfaceScalars
