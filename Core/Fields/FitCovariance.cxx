#include "FitCovariance.h"

#include "Monomials.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace SurfaceScalars
{
namespace
{

using Terms = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, LocalFit::MaximumTerms, 1>;
using TermGradients = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, LocalFit::MaximumTerms, 2>;

Terms termsAt(int degree, const Vector2d& place)
{
  Terms terms(LocalFit::termCount(degree));
  monomials(degree, place.x(), place.y(), terms.data());
  return terms;
}

TermGradients termGradientsAt(int degree, const Vector2d& place)
{
  const Terms terms = termsAt(degree, place);
  TermGradients gradients = TermGradients::Zero(terms.size(), 2);
  for (int d = 1; d <= degree; ++d)
  {
    const double* lower = terms.data() + firstTerm(d - 1);
    for (int k = 0; k < d; ++k)
    {
      gradients(firstTerm(d) + k, 0) = (d - k) * lower[k];
      gradients(firstTerm(d) + k + 1, 1) = (k + 1) * lower[k];
    }
  }
  return gradients;
}

} // namespace

bool FitCovariance::compute(const LocalFit& fit, const WeightedSamples& samples)
{
  this->degree_ = fit.degree();
  this->scale_ = fit.scale();
  const int count = LocalFit::termCount(this->degree_);
  Matrix normal = Matrix::Zero(count, count);
  Matrix squared = Matrix::Zero(count, count);
  double weightSum = 0.0;
  double squares = 0.0; // of the residuals
  for (Eigen::Index i = 0; i < samples.weights.size(); ++i)
  {
    const double weight = samples.weights[i];
    if (!(weight > 0.0))
    {
      continue;
    }
    const Vector2d uv = fit.flatten(samples.points.col(i));
    const Terms terms = termsAt(this->degree_, uv / this->scale_);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(terms, weight);
    squared.selfadjointView<Eigen::Lower>().rankUpdate(terms, weight * weight);
    const double residual = samples.values[i] - fit.valueSlope(uv).value;
    weightSum += weight;
    squares += weight * residual * residual;
  }
  const Eigen::LLT<Matrix> factor(normal.selfadjointView<Eigen::Lower>());
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  const Matrix symmetric = squared.selfadjointView<Eigen::Lower>();
  const Matrix half = factor.solve(symmetric); // N^-1 Q
  const double freedom = weightSum - half.trace();
  if (!(freedom > 0.0))
  {
    return false;
  }
  const double variance = squares / freedom;
  this->deviation_ = std::sqrt(variance);
  this->covariance_ = variance * factor.solve(half.transpose());
  return this->covariance_.allFinite();
}

double FitCovariance::ofValue(const Vector2d& uv) const
{
  const Terms terms = termsAt(this->degree_, uv / this->scale_);
  return terms.dot(this->covariance_ * terms);
}

Eigen::Matrix2d FitCovariance::ofGradient(const Vector2d& uv) const
{
  const TermGradients gradients = termGradientsAt(this->degree_, uv / this->scale_) / this->scale_;
  return gradients.transpose() * this->covariance_ * gradients;
}

Eigen::Matrix3d FitCovariance::ofHessianAtCenter() const
{
  if (this->degree_ < 2)
  {
    return Eigen::Matrix3d::Zero();
  }
  const Vector3d derivatives = Vector3d(2.0, 1.0, 2.0) / (this->scale_ * this->scale_);
  return derivatives.asDiagonal() * this->covariance_.block<3, 3>(3, 3) * derivatives.asDiagonal();
}

} // namespace SurfaceScalars
