#pragma once

#include "Laplacian.h"

#include <memory>

namespace SurfaceScalars
{

class SmoothingSystem;

/// What is made small. The numbers are fixed.
enum class SmoothingEnergy
{
  Harmonic = 0,  ///< f^T S f, Dirichlet's
  Biharmonic = 1 ///< f^T S^T A^-1 S f, the squared Laplacian's integral
};

/// How the distance to the data is measured: W. The numbers are fixed.
enum class DataMetric
{
  Identity = 0,   ///< (area / n) I: noise per vertex
  MassMatrix = 1, ///< of linear finite elements
  LumpedMass = 2  ///< A, its row sums
};

/**
 * W, n x n. The mass matrix of linear finite elements (smoothing paper, sec. 4.2) has b_ij = (|t_r|
 * + |t_l|) / 12, b_ii = sum |t_k| / 6; vertices without area have the lumped mass. The other
 * metrics are diagonal and need no triangles.
 *
 * @param vertices 3 x n
 */
SURFACESCALARSCORE_EXPORT Eigen::SparseMatrix<double> metricMatrix(DataMetric metric,
  const Laplacian& laplacian, const PointsRef& vertices, const Triangles& triangles);

/**
 * Tikhonov regularization (smoothing paper, sec. 4.2): minimizes energy(x) + t ||x - f||_W^2 with t
 * = epsilon / area for the harmonic and epsilon / area^2 for the biharmonic energy, where area is
 * the sum of the mass. With weights that are those of the surface, that does not depend on unit and
 * resolution, as (3) and (5) of the paper do. Nothing is prescribed at boundaries: there the
 * derivative across the boundary tends to 0.
 *
 * The biharmonic (S A^-1 S + t W) x = t W f is solved by conjugate gradients, preconditioned with
 * (S + s D) A^-1 (S + s D), s^2 = t, D^2 = A W, W's row sums: whatever the mesh, with W = A the
 * condition number is 2, and only S + s D is factored, which is much sparser. Of more than 100,000
 * vertices it is not factored: AcceleratedMultigrid stands for its inverse, in a fifth of the
 * memory, unless triangles are so thin that it takes many cycles. The harmonic system is solved
 * with Multigrid. Factors and, for another epsilon, their symbolic part are kept: a
 * smoother is not to be used by several threads at once.
 *
 * Weights that are not symmetric, or a metric with zeros: the biharmonic matrix is assembled and
 * factored. The former have no harmonic energy; what is solved is S x + t W (x - f) = 0, whose
 * solution is between the least and the greatest f as the weights are positive (W diagonal).
 */
class SURFACESCALARSCORE_EXPORT TikhonovSmoother
{
public:
  /// @param metric W, n x n, positive definite, of positive row sums: metricMatrix(). Or diagonal
  /// with zeros, but not all over a component: f is not known there
  /// @throws InvalidInput for another size
  TikhonovSmoother(std::shared_ptr<const Laplacian> laplacian,
    const Eigen::SparseMatrix<double>& metric, SmoothingEnergy energy);

  /**
   * Linear in f; constants on a component remain, and if the weights are symmetric the mean over
   * each component, weighted by W.
   *
   * @param epsilon > 0, no unit: larger = closer to f. Unit sphere, l = 6, biharmonic: gain 0.5 at
   * (42 * 4 pi)^2
   * @param accuracy of the estimated error relative to the largest |x|, means apart
   * @throws InvalidInput for other values or epsilon; Error if the error is above 1e-6 and accuracy
   * in the end, relative to a tenth of f where x is smaller; Aborted
   */
  Values smooth(const ValuesRef& values, double epsilon, const Execution& execution = {},
    double accuracy = 1e-7) const;

  double energy(const ValuesRef& values) const;                  ///< at least 0
  double distance(const ValuesRef& a, const ValuesRef& b) const; ///< ||a - b||_W
  double product(const ValuesRef& a, const ValuesRef& b) const;  ///< a^T W b
  double weight(double epsilon) const;                           ///< t

  /// Details smaller than this are smoothed: of length 1 / sqrt(lambda) where half of an
  /// eigenfunction of eigenvalue lambda is left. (area / sqrt(epsilon))^(1/2) biharmonic,
  /// (area / epsilon)^(1/2) harmonic
  double smoothingLength(double epsilon) const;
  double epsilonOfLength(double length) const; ///< its inverse

  Eigen::Index size() const; ///< of vertices
  double area() const;       ///< the sum of the mass

private:
  std::shared_ptr<SmoothingSystem> system_;
};

} // namespace SurfaceScalars
