#pragma once

#include "FunctionDesign.h"
#include "StarValues.h"

#include <functional>
#include <vector>

namespace SurfaceScalars
{

/// What is known of requests before any function is: values that are given or follow from others.
struct DesignValues
{
  double lowest;                             ///< of minima whose value is chosen
  double highest;                            ///< of such maxima
  std::vector<std::optional<double>> values; ///< by request; none for saddles without one
};

/**
 * Minima and maxima without a value get one below, or above, all given values that are none of
 * theirs: 0 and 1 if none is given. Where that leaves a component of the mesh without two different
 * values, saddles there are half way between.
 */
DesignValues designValues(const MeshTopology& mesh, const std::vector<CriticalRequest>& requests);

/// A function with these values at some vertices, smooth elsewhere.
using ValueExtension =
  std::function<Values(const std::vector<ValueConstraint>& constraints, const Execution&)>;

/// By request: whether the vertex is of the type and multiplicity that are asked for.
std::vector<char> areMet(const VertexTypes& types, const std::vector<CriticalRequest>& requests);

/**
 * The values of all critical points and their links, in two passes: the extension of what is known
 * gives saddles without a value theirs, and links without values those that it has where it is
 * what is asked for, else those of its quadratic approximation with other curvatures
 * (starTemplate()).
 *
 * @throws InvalidInput for requests that exclude each other, and what the extension throws; Aborted
 */
std::vector<ValueConstraint> constraintsOf(const PointsRef& vertices, const MeshTopology& mesh,
  const std::vector<CriticalRequest>& requests, const ValueExtension& extension,
  const Execution& execution, const PlaceName& nameOf);

} // namespace SurfaceScalars
