#include "RidgeSystem.h"

#include "Background.h"
#include "LCurve.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double StepsPerDecade = 4;
constexpr double LeastEnergyRatio = 1e-14; // of energies: smaller ones are rounding errors

} // namespace

Eigen::MatrixXd orthogonalComplement(const Eigen::MatrixXd& columns)
{
  const Eigen::MatrixXd all = Eigen::HouseholderQR<Eigen::MatrixXd>(columns).householderQ();
  return all.rightCols(columns.rows() - columns.cols());
}

RidgeSystem::RidgeSystem(const Eigen::MatrixXd& energies, const Eigen::MatrixXd& free,
  const Eigen::MatrixXd& metric, const Values& values)
{
  const Eigen::MatrixXd root = Eigen::LLT<Eigen::MatrixXd>(metric).matrixL();
  const Eigen::MatrixXd basis = root * orthogonalComplement(root.transpose() * free);
  if (basis.cols() == 0) // P interpolates
  {
    this->directions_ = basis;
    return;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(basis.transpose() * energies * basis);
  this->directions_ = basis * eigen.eigenvectors();
  this->energies_ = eigen.eigenvalues().cwiseMax(0.0);
  this->data_ = this->directions_.transpose() * values;
}

RidgeSystem ridgeSystem(const Eigen::MatrixXd& energies, const Eigen::MatrixXd& free,
  const Eigen::MatrixXd& metric, const Values& values, const Execution& execution)
{
  return inBackground(execution,
    [energies, free, metric, values]() { return RidgeSystem(energies, free, metric, values); });
}

Values RidgeSystem::multipliers(double weight) const
{
  const Values strengths = (1.0 / weight + this->energies_.array()).inverse();
  return this->directions_ * strengths.cwiseProduct(this->data_);
}

ParameterCurve RidgeSystem::curve(double unit) const
{
  ParameterCurve result;
  const double largest = this->energies_.size() > 0 ? this->energies_.maxCoeff() : 0.0;
  if (!(largest > 0.0 && std::isfinite(largest)))
  {
    return result;
  }
  const double least = std::max(this->energies_.minCoeff(), LeastEnergyRatio * largest);
  const double first = std::log10(0.1 / largest);
  const double last = std::log10(10.0 / least);
  const Eigen::Index count = static_cast<Eigen::Index>(StepsPerDecade * (last - first)) + 1;
  for (Values* column :
    { &result.epsilons, &result.residuals, &result.seminorms, &result.gcv, &result.curvatures })
  {
    column->setZero(count);
  }
  const auto size = static_cast<double>(this->directions_.rows());
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const double weight = std::pow(10.0, first + static_cast<double>(i) / StepsPerDecade);
    const Eigen::ArrayXd strengths = weight * this->energies_.array();
    const Eigen::ArrayXd rest = (this->data_.array() / (1.0 + strengths)).square();
    const double residual = rest.sum();
    const double energy = weight * (strengths * rest).sum();
    const double change = -2.0 * (rest * strengths / (1.0 + strengths)).sum();
    const double share = (1.0 / (1.0 + strengths)).sum() / size;
    result.epsilons[i] = weight / unit;
    result.residuals[i] = std::sqrt(residual);
    result.seminorms[i] = std::sqrt(energy);
    result.gcv[i] = residual / (size * share * share);
    result.curvatures[i] = lCurveCurvature(residual, energy, change, weight);
  }
  return result;
}

} // namespace SurfaceScalars
