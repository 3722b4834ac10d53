#pragma once

#include "MeshCriticalPoints.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// A steepest path along edges from a saddle to an extremum.
struct Separatrix
{
  std::size_t source;      ///< index of the saddle among the nodes
  std::size_t destination; ///< index of the minimum or maximum
  bool ascending;
  double persistence;          ///< |f(saddle) - f(extremum)|, of the two ends: not that of a pair
  std::vector<Index> vertices; ///< from the saddle to the extremum
};

/// The 1-skeleton of the Morse complex: its nodes and the separatrices between them.
struct MorseComplex
{
  std::vector<CriticalPoint> nodes;     ///< by vertex
  std::vector<Separatrix> separatrices; ///< by source, descending ones first
  Values values; ///< f without what was cancelled: separatrices fall or rise strictly in it
};

/**
 * From each saddle one path down for each component of its lower link, and one path up for each of
 * its upper link: m + 1 of each from a saddle of multiplicity m, in all 3 from a simple one on the
 * boundary. Paths take the steepest edge, difference of f over length, of equal ones that to the
 * lowest vertex, ties by index: from each vertex there is one way, so that paths of one direction
 * merge but never cross.
 *
 * @param threshold f's unit, from 0 to f's range: extrema of less persistence, with as many
 * saddles, are cancelled first by keepExtrema(); the nodes are then those of the simplified f
 * @throws InvalidInput as classifyVertices() and for another threshold; Aborted
 */
SURFACESCALARSCORE_EXPORT MorseComplex morseComplex(const PointsRef& vertices,
  const MeshTopology& mesh, const ValuesRef& values, double threshold = 0.0,
  const Execution& execution = {});

} // namespace SurfaceScalars
