#pragma once

#include "MeshTopology.h"

#include <functional>
#include <string>
#include <vector>

namespace SurfaceScalars
{

/// What a place is called in messages: "critical point 3".
using PlaceName = std::function<std::string(std::size_t place)>;

/**
 * The vertex next to each place, of equally near ones the first.
 *
 * @param maximumDistance length; 0 = a twentieth of the diagonal of the mesh's bounding box, or the
 * longest edge at that vertex if that is longer
 * @throws InvalidInput that names a place and the distance for one farther away or not finite; for
 * two places at one vertex, both named
 */
SURFACESCALARSCORE_EXPORT std::vector<Index> nearestVertices(const PointsRef& vertices,
  const MeshTopology& mesh, const PointsRef& places, double maximumDistance,
  const PlaceName& nameOf = {});

} // namespace SurfaceScalars
