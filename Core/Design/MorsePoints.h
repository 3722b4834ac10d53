#pragma once

#include "FunctionDesign.h"

#include <vector>

namespace SurfaceScalars
{

/// A critical point of the function to be, with the sides of its neighbors.
struct MorsePoint
{
  Index vertex;
  CriticalType type;
  int multiplicity;
  std::vector<int> sides; ///< by neighbor: -1 lower, 1 higher than the point
};

/**
 * The critical points of a function on a closed mesh that has those that are asked for, and beside
 * them as few as Euler's formula allows in each component: its lowest minimum and its highest
 * maximum unless there is one, then the most persistent critical points of the given function that
 * make the sum of the indices that of the component.
 *
 * Neighbors of a point lie where the function has them, if the point is of its type there;
 * otherwise where they deviate the least from that.
 *
 * @returns minima first, then by value, ties by index; empty if the function has too few
 */
std::vector<MorsePoint> morsePoints(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution);

/// The points of -f.
std::vector<MorsePoint> upsideDown(std::vector<MorsePoint> points);

/// A saddle's neighbors on the lower side: m + 1 runs along the link.
std::vector<std::vector<Index>> lowerSectors(const MeshTopology& mesh, const MorsePoint& saddle);

} // namespace SurfaceScalars
