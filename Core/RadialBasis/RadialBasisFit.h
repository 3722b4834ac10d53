#pragma once

#include "BlockCholesky.h"
#include "Execution.h"
#include "FieldJet.h"
#include "LinearTerms.h"
#include "RadialKernel.h"
#include "SurfaceScalarsCoreExport.h"

#include <Eigen/QR>

namespace SurfaceScalars
{

/**
 * A sum of radial functions around centers and a linear polynomial, through or near given values:
 * (9) with the system (10) of the point-set paper, dense.
 *
 * The polynomial is centered and scaled. Directions in which the centers do not spread (coplanar or
 * collinear ones) are left out of it: the system of the paper would be singular. Solved in the null
 * space of the polynomials, where sign() times the kernel matrix is positive definite: unlike (10)
 * itself, that can be factored by Cholesky, and says so if it is not.
 *
 * Buffers are kept from one fit to the next. Not for several threads at once.
 */
class SURFACESCALARSCORE_EXPORT RadialBasisFit
{
public:
  /**
   * Prepares interpolation at these centers, which must be distinct.
   *
   * @param regularization >= 0, added to the diagonal of the kernel matrix: 0 interpolates, larger
   * values smooth. Relative to a phi of order 1, so without a unit: with the Linear kernel, whose
   * phi is a length, the kernel's width times this is added
   * @returns whether the system is positive definite; if not, nothing else may be called but
   * reciprocalCondition(), and, if that is above 0, solve() by who checks what comes of it
   * @throws Aborted
   */
  bool factor(const PointsRef& centers, const RadialKernel& kernel, double regularization,
    const Execution& execution = { 1, {} });

  /// @param values one per center
  void solve(const ValuesRef& values);

  /**
   * Instead of factor() and solve(): the sum and polynomial closest to values at places that need
   * not be the centers, in the sense of weighted least squares. What the places do not determine is
   * left out.
   *
   * @param weights one per place, >= 0: factors of the squared errors
   * @returns whether the result is finite; afterwards value() and jet() may be called
   */
  bool approximate(const PointsRef& centers, const RadialKernel& kernel, const PointsRef& places,
    const ValuesRef& values, const ValuesRef& weights);

  double value(const Vector3d& place) const;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const;

  const Points& centers() const { return this->centers_; }
  const Values& coefficients() const { return this->coefficients_; } ///< alpha
  /// beta: the polynomial is tail[0] + tail.tail(3) . (p - tailOrigin()).
  const Eigen::Vector4d& tail() const { return this->tail_; }
  const Vector3d& tailOrigin() const { return this->terms_.origin(); }

  /// What the rows of `polynomials` stand for in dependsOnValues().
  const LinearTerms& terms() const { return this->terms_; }

  /// How kernels . alpha + polynomials . (the polynomial in terms()) depends on the values that are
  /// solved for: its gradient, one entry per center; for each column. After factor().
  Eigen::MatrixXd dependsOnValues(
    const Eigen::MatrixXd& kernels, const Eigen::MatrixXd& polynomials) const;

  /// Estimate of 1 / condition of the factored matrix, 0 if it is not positive definite.
  double reciprocalCondition() const;

  /// By how much the sum misses a value that it was solved for, infinite if it is not finite; in
  /// the square of the count. After solve().
  double largestResidual() const;
  /// What rounding makes of it at most, from the size of the terms of the sum, where nothing
  /// regularizes; in time of the count. After solve().
  double residualBound() const;

  /**
   * What interpolation at all other centers would miss the value at each by, without solving again
   * (Rippa 1999, here with the polynomial). Only the few centers without which the polynomial loses
   * a direction, where that divides 0 by 0, are left out in earnest. After solve().
   *
   * @throws InvalidInput for a single center; Aborted
   */
  Values leaveOneOutErrors(const Execution& execution = { 1, {} }) const;

private:
  void assemble(double regularization, const Execution& execution);
  void transformKernelMatrix();
  double errorWithout(Eigen::Index center) const;

  Points centers_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> rows_; ///< the centers once more, for long loops
  RadialKernel kernel_{ KernelType::Cubic, 1.0 };
  double regularization_ = 0.0;
  LinearTerms terms_;
  Values values_; ///< that it was solved for
  Values coefficients_;
  Eigen::Vector4d tail_ = Eigen::Vector4d::Zero();
  Eigen::MatrixXd matrix_; ///< of the kernel, then in the basis of the reflections
  Eigen::HouseholderQR<Eigen::MatrixXd> polynomials_;
  BlockCholesky cholesky_;
  double pivotRatio_ = 0.0;
};

} // namespace SurfaceScalars
