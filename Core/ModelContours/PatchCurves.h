#pragma once

#include "ContourPatch.h"
#include "LevelSets.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The segments of a refined patch, joined to curves. Larger values lie to the left, seen against
 * the normals, which agree along each curve and with most of its triangles. Curves end at the
 * boundary of the surface, at edges of more than two triangles and where u is not defined. The
 * branches of saddles are joined as joinArcs() says.
 *
 * @returns places relative to the origin of the field's cloud; level and component are not set
 */
std::vector<LevelSetCurve> curvesOf(const ContourPatch& patch);

} // namespace SurfaceScalars
