#pragma once

#include "Laplacian.h"
#include "VertexName.h"

#include <vector>

namespace SurfaceScalars
{

/// f = value at a vertex.
struct ValueConstraint
{
  Index vertex;
  double value;
};

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
 * The eigenfunctions of the smallest eigenvalues: stiffness f = lambda mass f (point-set paper,
 * sec. 2.2).
 *
 * There are as many eigenvalues 0 as connected components; their functions are constant on one of
 * these, 0 on the others. Of the others the entry of greatest magnitude is positive. The order of
 * equal eigenvalues, and the functions within their span, mean nothing but are always the same.
 *
 * Sixteen functions of 100,000 points take as long as some 45 of their neighbor graphs on one
 * thread with CHOLMOD and OpenBLAS, 60 with the reference BLAS, 80 without CHOLMOD; little of that
 * has use for more threads. An abort is heard within a second up to a million points.
 *
 * @param count how many, 1 to n - 1
 * @throws InvalidInput for another count, weights that are not symmetric, too many links; Error if
 * they do not converge to 1e-5; Aborted
 */
SURFACESCALARSCORE_EXPORT Eigenfunctions laplacianEigenfunctions(
  const Laplacian& laplacian, int count, const Execution& execution = {});

/**
 * What heat becomes after a time: the solution of mass df/dt = -stiffness f.
 *
 * With one matrix, G = (mass + time / 11 stiffness)^-1 mass, exp(-time lambda) is approximated by a
 * polynomial of degree 12 in G that is exact for lambda = 0 and tends to 0 for large lambda: the
 * error is below 1.2e-5 of the heat's norm, whatever time and surface, and so is what may fall
 * below the least heat. Twelve linear systems are solved.
 *
 * The heat of each connected component, the sum of mass f, remains the same to rounding errors if
 * the weights are symmetric.
 *
 * @param heat f at time 0, finite
 * @param time length^2, > 0: heat spreads over some 2 sqrt(time)
 * @throws InvalidInput for other heat or another time; Error if the solver fails; Aborted
 */
SURFACESCALARSCORE_EXPORT Values diffuse(
  const Laplacian& laplacian, const ValuesRef& heat, double time, const Execution& execution = {});

} // namespace SurfaceScalars
