#include "SmoothingSystem.h"

#include "RowScaling.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// The preconditioner's least epsilon: below, what remains but for the constants, which are
/// projected out, is far from singular, and factors should be as well.
constexpr double LeastEpsilon = 1.0;

constexpr Eigen::Index MostFactored = 100000; // vertices: above, factors take too much memory;
constexpr int MostCycles = 24;                // where triangles are slivers, cycles too much time
constexpr double InverseError = 0.003;        // of cycles: smaller ones save no steps

} // namespace

SmoothingSystem::SmoothingSystem(std::shared_ptr<const Laplacian> laplacian,
  const Eigen::SparseMatrix<double>& metric, SmoothingEnergy energy)
  : laplacian_(std::move(laplacian))
  , energy_(energy)
  , stiffness_(laplacian_->stiffness)
  , metric_(metric)
  , rowSums_(metric_ * Values::Ones(metric_.cols()))
  , means_(*laplacian_, rowSums_)
{
  if (!this->laplacian_->symmetric)
  {
    this->transposed_ = this->stiffness_.transpose();
  }
}

Values SmoothingSystem::energyProduct(const Values& vector, const Execution& execution) const
{
  Values image = multiply(this->stiffness_, vector, execution);
  if (this->energy_ == SmoothingEnergy::Harmonic)
  {
    return image;
  }
  image = image.cwiseQuotient(this->laplacian_->mass);
  return multiply(
    this->laplacian_->symmetric ? this->stiffness_ : this->transposed_, image, execution);
}

Values SmoothingSystem::metricProduct(const Values& vector, const Execution& execution) const
{
  return multiply(this->metric_, vector, execution);
}

/// s D
Values SmoothingSystem::shift(double weight) const
{
  return std::sqrt(weight) * this->laplacian_->mass.cwiseProduct(this->rowSums_).cwiseSqrt();
}

/// S + s D, or E + t W where that does not help.
std::shared_ptr<const Eigen::SparseMatrix<double>> SmoothingSystem::toBeFactored(
  double weight) const
{
  const Eigen::SparseMatrix<double>& stiffness = this->laplacian_->stiffness;
  if (this->isSplit())
  {
    auto result = std::make_shared<Eigen::SparseMatrix<double>>(stiffness);
    result->diagonal() += this->shift(weight);
    return result;
  }
  const Eigen::SparseMatrix<double> scaled =
    scaleRows(stiffness, this->laplacian_->mass.cwiseInverse());
  const Eigen::SparseMatrix<double> metric = this->metric_;
  return std::make_shared<Eigen::SparseMatrix<double>>(
    Eigen::SparseMatrix<double>(stiffness.transpose() * scaled) + weight * metric);
}

void SmoothingSystem::factor(double weight, const Execution& execution)
{
  if (auto cholesky = std::exchange(this->cholesky_, nullptr))
  {
    cholesky->refactor(this->toBeFactored(weight), execution);
    this->cholesky_ = std::move(cholesky);
  }
  else
  {
    this->cholesky_ = std::make_unique<SparseCholesky>(this->toBeFactored(weight), execution);
  }
  if (this->isSplit())
  {
    this->rounded_ = std::make_unique<RoundedFactor>(this->cholesky_->rounded());
  }
}

/// @returns whether that is worthwhile: it does not depend on what was solved before
bool SmoothingSystem::prepareCycles(double weight, const Execution& execution)
{
  if (!this->isSplit() || this->stiffness_.rows() <= MostFactored)
  {
    return false;
  }
  RowMatrix shifted = this->stiffness_;
  shifted.diagonal() += this->shift(weight);
  this->cycles_ = std::make_unique<AcceleratedMultigrid>(shifted, InverseError, execution);
  if (this->cycles_->cycleCount() > MostCycles)
  {
    this->cycles_ = nullptr;
  }
  return this->cycles_ != nullptr;
}

void SmoothingSystem::prepare(double weight, const Execution& execution)
{
  if (weight == this->preparedWeight_)
  {
    return;
  }
  this->preparedWeight_ = 0.0;
  this->cycles_ = nullptr; // to be freed first
  if (this->energy_ == SmoothingEnergy::Harmonic)
  {
    this->multigrid_ = std::make_unique<Multigrid>(
      RowMatrix(this->stiffness_ + weight * this->metric_), this->laplacian_->symmetric, execution);
  }
  else if (!this->prepareCycles(weight, execution))
  {
    this->factor(weight, execution);
  }
  this->preparedWeight_ = weight;
}

Values SmoothingSystem::preconditioned(const Values& residual, const Execution& execution) const
{
  Values result;
  if (this->multigrid_)
  {
    result = this->multigrid_->apply(residual, execution);
  }
  else if (this->cycles_)
  {
    result = this->cycles_->apply(residual, execution);
    result = this->cycles_->apply(this->laplacian_->mass.cwiseProduct(result), execution);
  }
  else if (this->rounded_)
  {
    result = this->rounded_->solve(residual);
    execution.report(0.0);
    result = this->rounded_->solve(this->laplacian_->mass.cwiseProduct(result));
  }
  else
  {
    result = this->cholesky_->solve(residual);
  }
  return this->isSymmetric() ? Values(result - this->means_.of(result)) : result;
}

Values SmoothingSystem::solve(
  const Values& right, double weight, double goal, double least, const Execution& execution)
{
  const double area = this->laplacian_->mass.sum();
  const double leastWeight = LeastEpsilon / this->rowSums_.sum() *
    (this->energy_ == SmoothingEnergy::Harmonic ? 1.0 : 1.0 / area);
  this->prepare(
    this->isSymmetric() ? std::max(weight, leastWeight) : weight, execution.part(0.0, 0.5));
  const auto matrix = [&](const Values& vector, const Execution& polling) -> Values
  { return this->energyProduct(vector, polling) + weight * this->metricProduct(vector, polling); };
  const auto preconditioner = [&](const Values& residual, const Execution& polling)
  { return this->preconditioned(residual, polling); };
  return PreconditionedSystem{ matrix, preconditioner, this->isSymmetric() }.solve(
    right, goal, execution.part(0.5, 1.0), least);
}

} // namespace SurfaceScalars
