#pragma once

#include "FuzzyCriticalPoints.h"
#include "ValueScaling.h"

#include <functional>
#include <memory>

namespace SurfaceScalars
{

/// An f~ in space.
struct CriticalField
{
  /// One for each thread that asks; places are those of the graph. Empty for ParameterizedMLS,
  /// whose fits know f on the surface themselves.
  std::function<std::unique_ptr<FieldApproximation>()> make;
  /// Whether its second derivatives are f's. Those of an average (6) are not: they tell how the
  /// samples lie.
  bool hasHessian = true;
};

/**
 * The volume function, if the probability model wants it, or else the f~ of the scheme.
 *
 * @param values f at the points of the graph, scaled; must outlive what is made
 */
CriticalField makeCriticalField(const NeighborGraph& graph, const Values& values,
  const ValueScaling& scaling, const CriticalPointParameters& parameters,
  const Execution& execution);

} // namespace SurfaceScalars
