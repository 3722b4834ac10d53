#include "LocalFit.h"

#include "Monomials.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{

namespace
{

/// The following are in coordinates divided by the scale.
template <int Degree>
LocalFit::Slope slopeOf(const double* coefficients, const double* terms)
{
  LocalFit::Slope slope{ coefficients[0], Vector2d::Zero() };
  for (int d = 1; d <= Degree; ++d)
  {
    const double* c = coefficients + firstTerm(d);
    const double* current = terms + firstTerm(d);
    const double* lower = terms + firstTerm(d - 1);
    slope.value += c[d] * current[d];
    for (int y = 0; y < d; ++y)
    {
      slope.value += c[y] * current[y];
      // x^(d-y) y^y derives to terms of degree d - 1.
      slope.gradient.x() += c[y] * (d - y) * lower[y];
      slope.gradient.y() += c[y + 1] * (y + 1) * lower[y];
    }
  }
  return slope;
}

template <int Degree>
Eigen::Matrix2d hessianOf(const double* coefficients, const double* terms)
{
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  for (int d = 2; d <= Degree; ++d)
  {
    const double* lower = terms + firstTerm(d - 2);
    for (int y = 0; y <= d; ++y)
    {
      const double c = coefficients[firstTerm(d) + y];
      const int x = d - y;
      hessian(0, 0) += x > 1 ? c * x * (x - 1) * lower[y] : 0.0;
      hessian(0, 1) += x > 0 && y > 0 ? c * x * y * lower[y - 1] : 0.0;
      hessian(1, 1) += y > 1 ? c * y * (y - 1) * lower[y - 2] : 0.0;
    }
  }
  hessian(1, 0) = hessian(0, 1);
  return hessian;
}

} // namespace

LocalFit::Jet LocalFit::jet(int which, const Vector2d& uv) const
{
  return withDegree(this->degree_,
    [&](auto degree)
    {
      const double* coefficients = this->coefficients_.col(which).data();
      double terms[MaximumTerms];
      monomials(degree, uv.x() / this->scale_, uv.y() / this->scale_, terms);
      Jet jet{ slopeOf<degree>(coefficients, terms), hessianOf<degree>(coefficients, terms) };
      jet.gradient /= this->scale_;
      jet.hessian /= this->scale_ * this->scale_;
      return jet;
    });
}

LocalFit::Slope LocalFit::slope(int which, const Vector2d& uv) const
{
  return withDegree(this->degree_,
    [&](auto degree)
    {
      double terms[MaximumTerms];
      monomials(degree, uv.x() / this->scale_, uv.y() / this->scale_, terms);
      Slope slope = slopeOf<degree>(this->coefficients_.col(which).data(), terms);
      slope.gradient /= this->scale_;
      return slope;
    });
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
  return this->tangentialGradient(this->valueSlope(uv).gradient, this->heightSlope(uv).gradient);
}

Vector3d LocalFit::tangentialGradient(const Vector2d& derivatives, const Vector2d& slope) const
{
  // Raise the index with the metric I + s s^T of the graph z(u, v), s its slope: (I + s s^T)^-1 = I
  // - s s^T / (1 + s^T s).
  const Vector2d tangent =
    derivatives - slope * (slope.dot(derivatives) / (1.0 + slope.squaredNorm()));
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
