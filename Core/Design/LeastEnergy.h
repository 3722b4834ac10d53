#pragma once

#include "GreensFunctions.h"
#include "LaplacianFunctions.h"
#include "RidgeSystem.h"

#include <vector>

namespace SurfaceScalars
{

/// Values at a few vertices, and what the functions of least energy need to know of these.
struct EnergyConstraints
{
  std::vector<Index> vertices; ///< different ones
  Values given;                ///< their values
  double lowest = 0.0;         ///< of these
  double range = 1.0;          ///< of these; 1 if they are all equal
  Values values;               ///< in the unit in which they are between 0 and 1
  Eigen::MatrixXd energies;    ///< G, of the Green's functions
  Eigen::MatrixXd constants;   ///< 1 where the vertex (row) is of the component (column)
};

/// @param constraints at least one in each connected component; several at a vertex must agree
/// @throws InvalidInput unless it is so; Aborted
SURFACESCALARSCORE_EXPORT EnergyConstraints energyConstraints(GreensFunctions& functions,
  const std::vector<ValueConstraint>& constraints, const Execution& execution,
  const VertexName& nameOf);

/**
 * (2) of the design paper: the function of least energy through values at a few vertices. ||L f||
 * there is not Dirichlet's energy, as the paper says, but the biharmonic one; and what it reduces
 * (2) to, L g = b at the other vertices, has the solution of least harmonic energy.
 *
 * f = sum lambda_j g_j + constants of components, G lambda + constants = values, the lambda of a
 * component sum to 0.
 *
 * @throws Error if rounding errors spoil it; Aborted
 */
SURFACESCALARSCORE_EXPORT Values leastEnergyThrough(const GreensFunctions& functions,
  const EnergyConstraints& constraints, const Execution& execution);

/**
 * (3): the functions that make energy(x) + t (x - values)^T W (x - values) least, for any t, after
 * one dense decomposition: f as above, but (G + (t W)^-1) lambda + constants = values.
 */
class SURFACESCALARSCORE_EXPORT LeastEnergyNear
{
public:
  /// @param metric W, of all vertices; positive definite
  /// @param functions outlives this, as do the constraints @throws Aborted
  LeastEnergyNear(const GreensFunctions& functions, const EnergyConstraints& constraints,
    const Eigen::SparseMatrix<double>& metric, const Execution& execution = {});

  ParameterCurve curve(double unit) const; ///< for all t = epsilon * unit
  Values solve(double weight) const;       ///< for t

private:
  const GreensFunctions& functions_;
  const EnergyConstraints& constraints_;
  Eigen::MatrixXd metric_; ///< among the constrained vertices
  RidgeSystem system_;
};

} // namespace SurfaceScalars
