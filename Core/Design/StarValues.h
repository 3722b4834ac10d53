#pragma once

#include "FunctionDesign.h"
#include "LaplacianFunctions.h"

#include <vector>

namespace SurfaceScalars
{

/// A critical point whose value is decided, and what its surroundings shall look like.
struct StarRequest
{
  Index vertex;
  CriticalType type;
  int multiplicity;
  double value;
  std::vector<double> differences; ///< wanted of the link, in its order; their size counts
};

/**
 * Values of the vertices and their links with which each is critical as asked for, whatever
 * surrounds the links: the wanted differences with the signs that are closest to them and change as
 * often as they must.
 *
 * Links that share vertices, and neighbors, are reconciled: extrema first, then saddles in their
 * order get signs that agree with what is decided. A shared vertex has the mean of what is wanted
 * of it, or is half way between the values it must be between.
 *
 * @throws InvalidInput that names two requests that exclude each other, or one whose link is too
 * small
 */
std::vector<ValueConstraint> starValues(
  const MeshTopology& mesh, const std::vector<StarRequest>& requests, const PlaceName& nameOf);

} // namespace SurfaceScalars
