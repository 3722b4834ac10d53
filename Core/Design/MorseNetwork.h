#pragma once

#include "MorsePoints.h"
#include "NetworkPaths.h"
#include "Precedence.h"

#include <optional>

namespace SurfaceScalars
{

/// See morseNetwork().
struct MorseNetwork
{
  std::vector<char> isInNetwork; ///< by vertex
  Precedence precedence;         ///< higher neighbors of points wait for these, these for their
                                 ///< lower ones, vertices of paths for the next lower
  Values heights;                ///< the given values, but on paths at most those of their saddles
};

/**
 * A network of descending paths that tells a function with the given critical points apart from all
 * that have more: from each saddle of multiplicity m lead m + 1 paths of vertices, one through each
 * of its lower sectors, to minima or to paths of saddles that come before it.
 *
 * What is left of a closed surface is disks, each with one maximum. Then from each point of the
 * network upwards a region can grow over all the disks that is met by the network's vertices in the
 * order of the paths, and changes its topology at the points only (sweepWithPoints()).
 *
 * Saddles take their paths in the order of the values; each path is the cheapest after which the
 * network can still be completed (complete()), of some that are spread along the network.
 *
 * @param points from morsePoints()
 * @returns none if there is no room for a path between the others
 */
std::optional<MorseNetwork> morseNetwork(const DesignMesh& mesh, const Values& values,
  const std::vector<MorsePoint>& points, const PathCosts& costs, const Execution& execution);

} // namespace SurfaceScalars
