#pragma once

#include "ComponentMeans.h"
#include "SparseCholesky.h"
#include "Tikhonov.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// The inverse of a Laplacian's stiffness S, up to constants on each component: factored once, for
/// any energy.
class PoissonSolver
{
public:
  /// @param laplacian symmetric @throws as SparseCholesky; Aborted
  PoissonSolver(std::shared_ptr<const Laplacian> laplacian, const Execution& execution);

  const Laplacian& laplacian() const { return *this->laplacian_; }
  const std::vector<int>& components() const { return this->components_; } ///< by vertex

  /// T b, 0 at one vertex of each component: S T b = b for columns that sum to 0 over each
  /// component. T is symmetric and positive definite.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& columns) const;

private:
  std::shared_ptr<const Laplacian> laplacian_;
  std::vector<int> components_;
  SparseCholesky grounded_;
};

/**
 * The functions g_j of least energy whose combinations f = sum lambda_j g_j + constants, where the
 * lambda_j sum to 0 over each component, are the functions of least energy with given values at the
 * vertices j: E g_j = e_j up to what such sums cancel, E the matrix of the energy. For few vertices
 * (hundreds), for which that is much cheaper than to factor E, and to change one of them cheaper
 * still.
 *
 * Harmonic: E = S, g_j = T e_j. Biharmonic: E = S M^-1 S with the mass matrix M, which may be the
 * consistent one: only M itself is multiplied with, g_j = T M P T e_j, P removes means.
 *
 * The energies of the combinations of vertices asked for are kept, not the functions.
 */
class GreensFunctions
{
public:
  /// @param mass of the biharmonic energy, n x n, symmetric
  GreensFunctions(std::shared_ptr<const PoissonSolver> poisson, SmoothingEnergy energy,
    const Eigen::SparseMatrix<double>& mass);

  const PoissonSolver& poisson() const { return *this->poisson_; }

  /// g_j at vertex i for all pairs of these: lambda^T G lambda is the energy of the sum.
  /// @throws Aborted
  Eigen::MatrixXd among(const std::vector<Index>& vertices, const Execution& execution);

  /// sum lambda_j g_j, at all vertices.
  Values sum(const std::vector<Index>& vertices, const Values& lambda) const;

private:
  Eigen::MatrixXd functions(const Eigen::MatrixXd& columns) const;
  void add(const std::vector<Index>& added, const Execution& execution);

  std::shared_ptr<const PoissonSolver> poisson_;
  SmoothingEnergy energy_;
  Eigen::SparseMatrix<double> mass_;
  ComponentMeans means_; ///< weighted by the mass

  std::vector<Index> known_;
  std::vector<Index> positions_; ///< in known_, by vertex; None for others
  Eigen::MatrixXd entries_;      ///< among these
};

} // namespace SurfaceScalars
