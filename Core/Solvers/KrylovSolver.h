#pragma once

#include "Basics.h"
#include "Execution.h"

#include <functional>

namespace SurfaceScalars
{

/// A linear map; polls for an abort.
using LinearMap = std::function<Values(const Values& vector, const Execution& execution)>;

/**
 * A system of linear equations that is solved step by step: by the method of conjugate gradients,
 * or if the matrix is not symmetric by the stabilized biconjugate gradients of van der Vorst
 * (1992).
 */
struct PreconditionedSystem
{
  LinearMap matrix;         ///< symmetric ones positive definite
  LinearMap preconditioner; ///< approximates the inverse; tells how large the error still is
  bool isSymmetric = true;

  /**
   * @param goal of the estimated error, relative to the largest component of the solution, at which
   * the steps end; if rounding errors leave a hundred times as much, they begin anew
   * @param least where the solution is smaller, in the end the error is relative to this
   * @throws Error if the error is not below the greater of 1e-6 and 100 goal in the end; Aborted
   */
  Values solve(
    const ValuesRef& right, double goal, const Execution& execution, double least = 0.0) const;
};

} // namespace SurfaceScalars
