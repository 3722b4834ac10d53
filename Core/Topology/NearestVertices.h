#pragma once

#include "MeshTopology.h"

#include <functional>
#include <string>
#include <vector>

namespace SurfaceScalars
{

/// What a place is called in messages; empty for "critical point 3".
using PlaceName = std::function<std::string(std::size_t place)>;

inline std::string nameOfPlace(std::size_t place, const PlaceName& nameOf)
{
  return nameOf ? nameOf(place) : "critical point " + std::to_string(place);
}

/**
 * The vertex next to each place, of equally near ones the first.
 *
 * @param vertices one column for each vertex of the mesh, finite
 * @param maximumDistance length; 0 = a twentieth of the diagonal of the mesh's bounding box, or the
 * longest edge at that vertex if that is longer
 * @param nameOfVertices for messages
 * @throws InvalidInput that names a place and the distance for one farther away or not finite; for
 * two places at one vertex, both named
 */
SURFACESCALARSCORE_EXPORT std::vector<Index> nearestVertices(const Points& vertices,
  const MeshTopology& mesh, const PointsRef& places, double maximumDistance,
  const PlaceName& nameOf = {}, const VertexName& nameOfVertices = {});

} // namespace SurfaceScalars
