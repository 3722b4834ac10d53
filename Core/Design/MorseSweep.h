#pragma once

#include "MeshTopology.h"
#include "MorseNetwork.h"
#include "VertexOrder.h"

#include <optional>

namespace SurfaceScalars
{

/**
 * A strict order near that of the network's heights in which a vertex is critical if and only if it
 * is among the points.
 *
 * One vertex after the other is added to a region that is empty at first: always the lowest whose
 * link meets the region in one run, so that it is regular, or a point, of its type and
 * multiplicity, once its lower neighbors are all there; its higher neighbors wait for it.
 * (Thinning by simple points, as of digital topology.)
 *
 * @param points with a network that leads the region from each to the next (morseNetwork());
 * closed meshes
 * @param network what waits for what on it
 * @returns none if the region cannot grow to the end
 */
std::optional<VertexOrder> sweepWithPoints(const MeshTopology& mesh,
  const std::vector<MorsePoint>& points, const MorseNetwork& network, const Execution& execution);

} // namespace SurfaceScalars
