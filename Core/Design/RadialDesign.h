#pragma once

#include "Field.h"
#include "FunctionDesign.h"
#include "LaplacianFunctions.h"

namespace SurfaceScalars
{

/**
 * Sums of radial functions through, or near, given values at a few places, taken at others (design
 * paper, sec. 3.3).
 *
 * The kernel 1 / r is infinite at its centers, which are therefore offset along the normals, by
 * two edges. How far is a choice that changes the result: unlike the paper says, u is not unique,
 * nor of least energy on the surface.
 */
class RadialDesign
{
public:
  /// @param mesh outlives this @param kernelWidth length, 0 = automatic
  RadialDesign(const DesignMesh& mesh, KernelType kernel, double kernelWidth)
    : mesh_(mesh)
    , kernel_(kernel)
    , kernelWidth_(kernelWidth)
  {
  }

  /// @throws InvalidInput for too many constraints, or a system that is singular at machine
  /// precision; Aborted
  Values through(const std::vector<ValueConstraint>& constraints, const Execution& execution) const;

  /// Epsilon is the inverse of RadialBasisFit's regularization. Not for the Harmonic kernel, whose
  /// system is not symmetric. @throws as through()
  Values near(const std::vector<ValueConstraint>& constraints, double epsilon,
    const Execution& execution) const;
  ParameterCurve curve(
    const std::vector<ValueConstraint>& constraints, const Execution& execution) const;

private:
  Field field(const std::vector<ValueConstraint>& constraints, double regularization,
    const Execution& execution) const;
  Values evaluated(const std::vector<ValueConstraint>& constraints, double regularization,
    const Execution& execution) const;

  const DesignMesh& mesh_;
  KernelType kernel_;
  double kernelWidth_;
};

} // namespace SurfaceScalars
