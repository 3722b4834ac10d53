#pragma once

#include "AcceleratedMultigrid.h"
#include "ComponentMeans.h"
#include "KrylovSolver.h"
#include "Multigrid.h"
#include "SparseCholesky.h"
#include "Tikhonov.h"

#include <memory>

namespace SurfaceScalars
{

/// (E + t W) x = b, where x^T E x is the energy: how it is solved, and what is kept for the next t
/// or b.
class SmoothingSystem
{
public:
  SmoothingSystem(std::shared_ptr<const Laplacian> laplacian,
    const Eigen::SparseMatrix<double>& metric, SmoothingEnergy energy);

  const Laplacian& laplacian() const { return *this->laplacian_; }
  SmoothingEnergy energy() const { return this->energy_; }
  const ComponentMeans& means() const { return this->means_; } ///< weighted by W

  Values energyProduct(const Values& vector, const Execution& execution) const; ///< E v
  Values metricProduct(const Values& vector, const Execution& execution) const; ///< W v

  /// @param right its sum over each component is 0, and so is that of W x
  /// @param goal, least as of PreconditionedSystem
  Values solve(
    const Values& right, double weight, double goal, double least, const Execution& execution);

private:
  bool isSymmetric() const ///< of the whole matrix
  {
    return this->energy_ == SmoothingEnergy::Biharmonic || this->laplacian_->symmetric;
  }
  bool isSplit() const
  {
    return this->energy_ == SmoothingEnergy::Biharmonic && this->laplacian_->symmetric &&
      this->rowSums_.minCoeff() > 0.0;
  }
  void prepare(double weight, const Execution& execution);
  bool prepareCycles(double weight, const Execution& execution);
  void factor(double weight, const Execution& execution);
  Values shift(double weight) const;
  std::shared_ptr<const Eigen::SparseMatrix<double>> toBeFactored(double weight) const;
  Values preconditioned(const Values& residual, const Execution& execution) const;

  std::shared_ptr<const Laplacian> laplacian_;
  SmoothingEnergy energy_;
  RowMatrix stiffness_;
  RowMatrix transposed_; ///< empty if the stiffness is symmetric
  RowMatrix metric_;
  Values rowSums_; ///< of the metric
  ComponentMeans means_;

  double preparedWeight_ = 0.0;                  ///< for which these are; 0 = none
  std::unique_ptr<Multigrid> multigrid_;         ///< harmonic
  std::unique_ptr<AcceleratedMultigrid> cycles_; ///< split, of many vertices
  std::unique_ptr<SparseCholesky> cholesky_;     ///< otherwise
  std::unique_ptr<RoundedFactor> rounded_;       ///< of these, if split
};

} // namespace SurfaceScalars
