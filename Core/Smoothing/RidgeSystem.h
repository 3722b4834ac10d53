#pragma once

#include "Basics.h"
#include "Execution.h"
#include "ParameterCurve.h"

namespace SurfaceScalars
{

/**
 * x = G lambda + P c near values g: lambda^T G lambda + t (x - g)^T W (x - g) is least, where
 * P^T lambda = 0. For all t after one decomposition: with W = C C^T and an orthonormal basis Z of
 * what is orthogonal to C^T P, C Z diagonalizes (G + (t W)^-1) lambda + P c = g.
 */
class RidgeSystem
{
public:
  /// @param energies G, positive semidefinite where P^T lambda = 0
  /// @param free P, of independent columns
  /// @param metric W, positive definite
  RidgeSystem(const Eigen::MatrixXd& energies, const Eigen::MatrixXd& free,
    const Eigen::MatrixXd& metric, const Values& values);

  Values multipliers(double weight) const; ///< lambda, for t

  /// For all t = epsilon * unit between least energy and interpolation; empty if nothing, or
  /// nothing finite, has an energy.
  ParameterCurve curve(double unit) const;

private:
  Eigen::MatrixXd directions_; ///< of lambda: W^-1 is 1 there, and G diagonal
  Values energies_;            ///< G of these
  Values data_;                ///< the values in these
};

/// The same while an abort is listened to: the decomposition takes seconds for thousands of values.
/// @throws Aborted
RidgeSystem ridgeSystem(const Eigen::MatrixXd& energies, const Eigen::MatrixXd& free,
  const Eigen::MatrixXd& metric, const Values& values, const Execution& execution);

/// An orthonormal basis of what is orthogonal to the independent columns of a matrix.
Eigen::MatrixXd orthogonalComplement(const Eigen::MatrixXd& columns);

} // namespace SurfaceScalars
