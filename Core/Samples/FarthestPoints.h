#pragma once

#include "Basics.h"
#include "Execution.h"

#include <vector>

namespace SurfaceScalars
{

/// Places that cover others.
struct FarthestPoints
{
  std::vector<Index> chosen; ///< in this order
  double radius = 0.0;       ///< within which each candidate has a chosen one or one there before
};

/**
 * Each is the candidate farthest from those chosen before it and from those that are there; ends
 * early where all candidates are. Time: candidates times centers.
 *
 * @param there may be empty: then the first candidate is chosen first
 */
FarthestPoints farthestPoints(const PointsRef& candidates, const PointsRef& there,
  std::size_t count, const Execution& execution);

/// At most `count` of the items, at even steps.
std::vector<Index> evenPart(const std::vector<Index>& items, std::size_t count);

/// Indices of at most `count` points, spread over all as evenly as these are, in the order of a
/// Morton curve.
std::vector<Index> evenSubset(
  const PointsRef& points, std::size_t count, const Execution& execution);

/// Without those that lie where another lies that comes before. Keeps the order.
std::vector<Index> distinctPlaces(
  const PointsRef& points, const std::vector<Index>& indices, const Execution& execution);

} // namespace SurfaceScalars
