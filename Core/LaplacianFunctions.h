#pragma once

#include "Laplacian.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace SurfaceScalars
{

/// f = value at a vertex.
struct ValueConstraint
{
  Index vertex;
  double value;
};

/// What the caller calls a vertex, for messages; empty for the vertex itself.
using VertexName = std::function<std::size_t(Index vertex)>;

/**
 * The harmonic function with given values at some vertices: stiffness f = 0 at all others
 * (point-set paper, sec. 2.2). Between the smallest and the largest given value everywhere where
 * the weights are positive (maximum principle), to 1e-9 of their difference.
 *
 * @param constraints at least one in each connected component; several at a vertex must agree
 * @throws InvalidInput without constraints, for contradictory ones, for a component without any
 * (named); Error if the solver fails; Aborted
 */
SURFACESCALARSCORE_EXPORT Values harmonicFunction(const Laplacian& laplacian,
  const std::vector<ValueConstraint>& constraints, const Execution& execution = {},
  const VertexName& nameOf = {});

struct Eigenfunctions
{
  Values eigenvalues;        ///< ascending, 1 / length^2
  Eigen::MatrixXd functions; ///< one per column; F^T diag(mass) F = identity
};

/**
 * The eigenfunctions of the smallest eigenvalues: stiffness f = lambda mass f.
 *
 * @param count how many, 1 to n - 1; the first is constant on a connected surface
 * @throws InvalidInput for another count or weights that are not symmetric; Error if the solver
 * fails; Aborted
 */
SURFACESCALARSCORE_EXPORT Eigenfunctions laplacianEigenfunctions(
  const Laplacian& laplacian, int count, const Execution& execution = {});

/**
 * What heat becomes after a time: the solution of mass df/dt = -stiffness f.
 *
 * @param heat f at time 0
 * @param time length^2, > 0
 * @throws InvalidInput for another time; Error if the solver fails; Aborted
 */
SURFACESCALARSCORE_EXPORT Values diffuse(
  const Laplacian& laplacian, const ValuesRef& heat, double time, const Execution& execution = {});

} // namespace SurfaceScalars
