#pragma once

#include "Laplacian.h"

#include <memory>

namespace SurfaceScalars
{

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

/// The mass matrix of linear finite elements (smoothing paper, sec. 4.2): b_ij = (|t_r| + |t_l|) /
/// 12, b_ii = sum |t_k| / 6; its row sums are the lumped masses.
SURFACESCALARSCORE_EXPORT Eigen::SparseMatrix<double> massMatrix(
  const PointsRef& vertices, const Triangles& triangles);

/**
 * Tikhonov regularization (smoothing paper, sec. 4.2): minimizes energy(x) + t ||x - f||_W^2, with t =
 * epsilon / area for the harmonic and epsilon / area^2 for the biharmonic energy, which does not
 * depend on unit and resolution, as (3) and (5) of the paper do.
 *
 * (how it is solved, by size; what is kept for the next epsilon or f)
 */
class SURFACESCALARSCORE_EXPORT TikhonovSmoother
{
public:
  /// @param metricMatrix W, n x n
  TikhonovSmoother(std::shared_ptr<const Laplacian> laplacian,
    Eigen::SparseMatrix<double> metricMatrix, SmoothingEnergy energy, const Execution& execution = {});

  /// @param epsilon > 0, no unit: larger = closer to f. Unit sphere, l = 6, biharmonic: gain 0.5 at (42 * 4 pi)^2
  Values smooth(const ValuesRef& values, double epsilon, const Execution& execution = {}) const;

  double energy(const ValuesRef& values) const;   ///< at least 0
  double distance(const ValuesRef& a, const ValuesRef& b) const; ///< ||a - b||_W

  /// The length below which details are smoothed: (area / sqrt(epsilon))^(1/2) biharmonic
  double smoothingLength(double epsilon) const;
};

} // namespace SurfaceScalars
