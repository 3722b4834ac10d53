#pragma once

#include "CriticalPoint.h"
#include "MeshChart.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Where u may have critical points of a type on a chart: where the polynomial through its values at
 * the vertices around has, which costs no evaluation of u.
 *
 * @param type Minimum, Saddle or Maximum
 * @returns different places within the chart, those next to `place` first
 */
std::vector<Vector3d> predictedPlaces(const PointsRef& vertices, const MeshTopology& mesh,
  const MeshChart& chart, CriticalType type, const Vector3d& place);

} // namespace SurfaceScalars
