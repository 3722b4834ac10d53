#include "LocalFit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// A column of the normal matrix that the others explain to this fraction carries rounding errors
// only.
constexpr double SingularFraction = 1e-9;

/// Index of the first monomial of a degree; monomial k of degree d is x^(d-k) y^k.
constexpr int firstTerm(int degree)
{
  return degree * (degree + 1) / 2;
}

inline void monomials(int degree, double x, double y, double* terms)
{
  terms[0] = 1.0;
  for (int d = 1; d <= degree; ++d)
  {
    const double* lower = terms + firstTerm(d - 1);
    double* current = terms + firstTerm(d);
    for (int k = 0; k < d; ++k)
    {
      current[k] = x * lower[k];
    }
    current[d] = y * lower[d - 1];
  }
}

/// Tangent axes and normal of weighted points, as columns.
Eigen::Matrix3d tangentFrame(const Vector3d& center, const WeightedSamples& samples)
{
  double weight = 0.0;
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < samples.weights.size(); ++i)
  {
    const double w = samples.weights[i];
    if (w <= 0.0)
    {
      continue;
    }
    const Vector3d offset = samples.points.col(i) - center;
    weight += w;
    mean += w * offset;
    moments.noalias() += (w * offset) * offset.transpose();
  }
  mean /= weight;
  const Eigen::Matrix3d covariance = moments / weight - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance);

  Eigen::Matrix3d frame;
  const Vector3d normal = axes.eigenvectors().col(0).normalized();
  const Vector3d u = normal.unitOrthogonal();
  frame << u, normal.cross(u), normal;
  return frame;
}

} // namespace

bool LocalFit::compute(
  const Vector3d& center, const WeightedSamples& samples, double radius, int degree)
{
  this->center_ = center;
  this->scale_ = radius;
  this->degree_ = std::clamp(degree, 1, MaximumDegree);
  this->frame_ = tangentFrame(center, samples);
  if (!this->frame_.allFinite())
  {
    return false;
  }
  switch (this->degree_)
  {
    case 1:
      return this->solve<1>(samples);
    case 2:
      return this->solve<2>(samples);
    case 3:
      return this->solve<3>(samples);
    default:
      return this->solve<4>(samples);
  }
}

template <int Degree>
bool LocalFit::solve(const WeightedSamples& samples)
{
  constexpr int Terms = termCount(Degree);
  Eigen::Matrix<double, Terms, Terms> normalMatrix = decltype(normalMatrix)::Zero();
  Eigen::Matrix<double, Terms, 2> rightSides = decltype(rightSides)::Zero();
  Eigen::Matrix<double, Terms, 1> terms;
  const Eigen::Matrix3d toLocal = this->frame_.transpose() / this->scale_;
  int used = 0;
  for (Eigen::Index i = 0; i < samples.weights.size(); ++i)
  {
    const double weight = samples.weights[i];
    if (weight <= 0.0)
    {
      continue;
    }
    ++used;
    const Vector3d local = toLocal * (samples.points.col(i) - this->center_);
    monomials(Degree, local.x(), local.y(), terms.data());
    const Eigen::Matrix<double, Terms, 1> weighted = weight * terms;
    normalMatrix.noalias() += weighted * terms.transpose();
    rightSides.col(0) += local.z() * weighted;
    rightSides.col(1) += samples.values[i] * weighted;
  }
  if (used < Terms)
  {
    return false;
  }
  const Eigen::LLT<Eigen::Matrix<double, Terms, Terms>> factor(normalMatrix);
  if (factor.info() != Eigen::Success)
  {
    return false;
  }
  const auto pivots = factor.matrixLLT().diagonal().array().square();
  if ((pivots < SingularFraction * normalMatrix.diagonal().array()).any())
  {
    return false;
  }
  for (int side = 0; side < 2;
       ++side) // one at a time: Eigen's matrix kernels are slow for sizes like these
  {
    this->coefficients_.col(side).template head<Terms>() = factor.solve(rightSides.col(side));
  }
  this->coefficients_.col(0) *= this->scale_;
  return this->coefficients_.template topRows<Terms>().allFinite();
}

LocalFit::Jet LocalFit::jet(int which, const Vector2d& uv) const
{
  double terms[MaximumTerms];
  monomials(this->degree_, uv.x() / this->scale_, uv.y() / this->scale_, terms);
  const auto c = this->coefficients_.col(which);
  Jet jet{ this->slope(which, uv), Eigen::Matrix2d::Zero() };
  for (int d = 2; d <= this->degree_; ++d)
  {
    const double* lower = terms + firstTerm(d - 2);
    for (int y = 0; y <= d; ++y)
    {
      const double coefficient = c[firstTerm(d) + y];
      const int x = d - y;
      jet.hessian(0, 0) += x > 1 ? coefficient * x * (x - 1) * lower[y] : 0.0;
      jet.hessian(0, 1) += x > 0 && y > 0 ? coefficient * x * y * lower[y - 1] : 0.0;
      jet.hessian(1, 1) += y > 1 ? coefficient * y * (y - 1) * lower[y - 2] : 0.0;
    }
  }
  jet.hessian /= this->scale_ * this->scale_;
  jet.hessian(1, 0) = jet.hessian(0, 1);
  return jet;
}

LocalFit::Slope LocalFit::slope(int which, const Vector2d& uv) const
{
  double terms[MaximumTerms];
  monomials(this->degree_, uv.x() / this->scale_, uv.y() / this->scale_, terms);
  const auto c = this->coefficients_.col(which);
  Slope slope{ c[0], Vector2d::Zero() };
  for (int d = 1; d <= this->degree_; ++d)
  {
    // x^(d-y) y^y derives to terms of degree d - 1.
    const double* current = terms + firstTerm(d);
    const double* lower = terms + firstTerm(d - 1);
    for (int y = 0; y <= d; ++y)
    {
      const double coefficient = c[firstTerm(d) + y];
      slope.value += coefficient * current[y];
      slope.gradient.x() += y < d ? coefficient * (d - y) * lower[y] : 0.0;
      slope.gradient.y() += y > 0 ? coefficient * y * lower[y - 1] : 0.0;
    }
  }
  slope.gradient /= this->scale_;
  return slope;
}

Vector3d LocalFit::lift(const Vector2d& uv) const
{
  return this->center_ + this->frame_ * Vector3d(uv.x(), uv.y(), this->heightSlope(uv).value);
}

Vector2d LocalFit::flatten(const Vector3d& p) const
{
  return (this->frame_.transpose() * (p - this->center_)).head<2>();
}

Vector3d LocalFit::normal(const Vector2d& uv) const
{
  const Vector2d slope = this->heightSlope(uv).gradient;
  return (this->frame_ * Vector3d(-slope.x(), -slope.y(), 1.0)).normalized();
}

Vector3d LocalFit::gradient(const Vector2d& uv) const
{
  // Raise the index with the metric I + s s^T of the graph z(u, v), s its slope: (I + s s^T)^-1 = I
  // - s s^T / (1 + s^T s).
  const Vector2d slope = this->heightSlope(uv).gradient;
  const Vector2d covector = this->valueSlope(uv).gradient;
  const Vector2d tangent = covector - slope * (slope.dot(covector) / (1.0 + slope.squaredNorm()));
  return this->frame_ * Vector3d(tangent.x(), tangent.y(), slope.dot(tangent));
}

double LocalFit::deviation(int which, const WeightedSamples& samples) const
{
  double squares = 0.0;
  double weight = 0.0;
  double squaredWeights = 0.0;
  double terms[MaximumTerms];
  for (Eigen::Index i = 0; i < samples.weights.size(); ++i)
  {
    const double w = samples.weights[i];
    const Vector3d local = this->frame_.transpose() * (samples.points.col(i) - this->center_);
    monomials(this->degree_, local.x() / this->scale_, local.y() / this->scale_, terms);
    double fitted = 0.0;
    for (int term = 0; term < termCount(this->degree_); ++term)
    {
      fitted += this->coefficients_(term, which) * terms[term];
    }
    const double residual = fitted - (which == 0 ? local.z() : samples.values[i]);
    squares += w * residual * residual;
    weight += w;
    squaredWeights += w * w;
  }
  const double effectiveCount = weight * weight / squaredWeights;
  const double freedom = 1.0 - std::min(0.85, termCount(this->degree_) / effectiveCount);
  return std::sqrt(squares / weight / freedom);
}

} // namespace SurfaceScalars
