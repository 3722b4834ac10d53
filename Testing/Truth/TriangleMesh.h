#pragma once

#include "Basics.h"
#include "CriticalPoint.h"

#include <array>
#include <string>
#include <vector>

namespace SurfaceScalars::Truth
{

/// Triangles between points.
struct TriangleMesh
{
  Points points;
  std::vector<std::array<int, 3>> triangles;

  /// V - E + F of the points that triangles use. 2 - 2 genus if the mesh is closed.
  int eulerCharacteristic() const;
};

/// Faces of more corners are cut into triangles, and colors are ignored.
/// @throws std::runtime_error unless the file is in OFF format
TriangleMesh readOff(const std::string& fileName);

/// The same, moved and scaled such that the bounding box lies around the origin with a diagonal
/// of 2.
TriangleMesh readCentered(const std::string& fileName);

/**
 * The critical vertices of a closed mesh (design paper, (1)), ties by index: in each triangle the
 * middle vertex counts; one that is never in the middle is an extremum, one that is 2 + 2m times is
 * a saddle of multiplicity m.
 *
 * Persistence is that of union-find along the edges. A saddle has the largest of those it ends, or
 * f's range if it ends fewer than m.
 *
 * @param values one per point
 */
std::vector<CriticalPoint> meshCriticalPoints(const TriangleMesh& mesh, const ValuesRef& values);

} // namespace SurfaceScalars::Truth
