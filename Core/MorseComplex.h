#pragma once

#include "MeshCriticalPoints.h"

#include <vector>

namespace SurfaceScalars
{

/// A steepest path along edges from a saddle to an extremum.
struct Separatrix
{
  std::size_t source;          ///< index of the saddle among the nodes
  std::size_t destination;     ///< index of the minimum or maximum
  bool ascending;
  double persistence;          ///< |f(saddle) - f(extremum)|
  std::vector<Index> vertices; ///< from the saddle to the extremum
};

/// The 1-skeleton of the Morse complex: its nodes and the separatrices between them.
struct MorseComplex
{
  std::vector<CriticalPoint> nodes;
  std::vector<Separatrix> separatrices;
};

/**
 * One path for each component of the lower link of each saddle down to a minimum, by the steepest
 * edge (difference of f over length), ties by index; likewise up. Paths of one direction merge but never cross.
 *
 * @param threshold f's unit: pairs of less persistence are cancelled first, by keepExtrema()
 * @throws as classifyVertices()
 */
SURFACESCALARSCORE_EXPORT MorseComplex morseComplex(const PointsRef& vertices,
  const MeshTopology& mesh, const ValuesRef& values, double threshold = 0.0,
  const Execution& execution = {});

} // namespace SurfaceScalars
