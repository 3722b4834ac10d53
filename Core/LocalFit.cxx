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

constexpr int Lanes = 8; // samples that are computed with side by side
using Lane = Eigen::Array<double, Lanes, 1>;

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

/// The matrix of the sums of products of two terms, of which few are different.
template <int Degree>
auto arrange(const double* products)
{
  constexpr int Terms = LocalFit::termCount(Degree);
  Eigen::Matrix<double, Terms, Terms> matrix;
  for (int d = 0; d <= Degree; ++d)
  {
    for (int k = 0; k <= d; ++k)
    {
      for (int e = 0; e <= Degree; ++e)
      {
        for (int l = 0; l <= e; ++l)
        {
          matrix(firstTerm(d) + k, firstTerm(e) + l) = products[firstTerm(d + e) + k + l];
        }
      }
    }
  }
  return matrix;
}

/// Solves L L^T x = b for both right sides at once.
template <class Matrix, class Sides>
void solveTriangles(const Matrix& lower, Sides& sides)
{
  constexpr int Terms = Matrix::RowsAtCompileTime;
  double inverse[Terms];
  for (int i = 0; i < Terms; ++i)
  {
    inverse[i] = 1.0 / lower(i, i);
    for (int j = 0; j < i; ++j)
    {
      sides.row(i) -= lower(i, j) * sides.row(j);
    }
    sides.row(i) *= inverse[i];
  }
  for (int i = Terms - 1; i >= 0; --i)
  {
    for (int j = i + 1; j < Terms; ++j)
    {
      sides.row(i) -= lower(j, i) * sides.row(j);
    }
    sides.row(i) *= inverse[i];
  }
}

} // namespace

bool LocalFit::compute(
  const Vector3d& center, const WeightedSamples& samples, double radius, int degree)
{
  this->center_ = center;
  this->scale_ = radius;
  this->degree_ = std::clamp(degree, 1, MaximumDegree);
  this->collect(samples);
  this->findFrame();
  if (!this->frame_.allFinite())
  {
    return false;
  }
  switch (this->degree_)
  {
    case 1:
      return this->solve<1>();
    case 2:
      return this->solve<2>();
    case 3:
      return this->solve<3>();
    default:
      return this->solve<4>();
  }
}

void LocalFit::collect(const WeightedSamples& samples)
{
  const Eigen::Index most = samples.weights.size();
  if (this->weights_.size() < most + Lanes)
  {
    this->offsets_.resize(most + Lanes, 3);
    this->weights_.resize(most + Lanes);
    this->values_.resize(most + Lanes);
  }
  this->collected_ = 0;
  // Values are taken relative to one of them, which keeps the digits of small differences.
  this->valueOrigin_ = most > 0 ? samples.values[0] : 0.0;
  for (Eigen::Index i = 0; i < most; ++i)
  {
    this->offsets_.row(this->collected_) = (samples.points.col(i) - this->center_).transpose();
    this->weights_[this->collected_] = samples.weights[i];
    this->values_[this->collected_] = samples.values[i] - this->valueOrigin_;
    this->collected_ += samples.weights[i] > 0.0 ? 1 : 0;
  }
  this->offsets_.middleRows<Lanes>(this->collected_).setZero();
  this->weights_.segment<Lanes>(this->collected_).setZero();
  this->values_.segment<Lanes>(this->collected_).setZero();
}

/// Tangent axes and normal of the weighted samples.
void LocalFit::findFrame()
{
  double weight = 0.0;
  Vector3d mean = Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (Eigen::Index begin = 0; begin < this->collected_; begin += Lanes)
  {
    const Lane weights = this->weights_.segment<Lanes>(begin);
    weight += weights.sum();
    for (int i = 0; i < 3; ++i)
    {
      const Lane weighted = weights * this->offsets_.col(i).segment<Lanes>(begin);
      mean[i] += weighted.sum();
      for (int j = 0; j <= i; ++j)
      {
        moments(i, j) += (weighted * this->offsets_.col(j).segment<Lanes>(begin)).sum();
      }
    }
  }
  mean /= weight;
  const Eigen::Matrix3d covariance =
    Eigen::Matrix3d(moments.selfadjointView<Eigen::Lower>()) / weight - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance);

  const Vector3d normal = axes.eigenvectors().col(0).normalized();
  const Vector3d u = normal.unitOrthogonal();
  this->frame_ << u, normal.cross(u), normal;
}

template <int Degree>
bool LocalFit::solve()
{
  constexpr int Terms = termCount(Degree);
  if (this->collected_ < Terms)
  {
    return false;
  }
  constexpr int Products = termCount(2 * Degree); // of two terms
  double products[Products] = {};
  Eigen::Matrix<double, Terms, 2, Eigen::RowMajor> sides = decltype(sides)::Zero();
  const Eigen::Matrix3d toLocal = this->frame_.transpose() / this->scale_;
  for (Eigen::Index begin = 0; begin < this->collected_; begin += Lanes)
  {
    const auto offsets = this->offsets_.middleRows<Lanes>(begin);
    const auto local = [&](int axis) -> Lane
    {
      return toLocal(axis, 0) * offsets.col(0) + toLocal(axis, 1) * offsets.col(1) +
        toLocal(axis, 2) * offsets.col(2);
    };
    const Lane u = local(0);
    const Lane v = local(1);
    const Lane heights = local(2);
    const Lane values = this->values_.segment<Lanes>(begin);
    Lane terms[Products]; // weighted
    terms[0] = this->weights_.segment<Lanes>(begin);
    for (int d = 1; d <= 2 * Degree; ++d)
    {
      for (int k = 0; k < d; ++k)
      {
        terms[firstTerm(d) + k] = u * terms[firstTerm(d - 1) + k];
      }
      terms[firstTerm(d) + d] = v * terms[firstTerm(d) - 1];
    }
    for (int term = 0; term < Products; ++term)
    {
      products[term] += terms[term].sum();
    }
    for (int term = 0; term < Terms; ++term)
    {
      sides(term, 0) += (terms[term] * heights).sum();
      sides(term, 1) += (terms[term] * values).sum();
    }
  }
  const Eigen::Matrix<double, Terms, Terms> normalMatrix = arrange<Degree>(products);
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
  solveTriangles(factor.matrixLLT(), sides);
  this->coefficients_.template topRows<Terms>() = sides;
  this->coefficients_.col(0) *= this->scale_;
  this->coefficients_(0, 1) += this->valueOrigin_;
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
  const double* c = this->coefficients_.col(which).data();
  Slope slope{ c[0], Vector2d::Zero() };
  for (int d = 1; d <= this->degree_; ++d)
  {
    const double* coefficients = c + firstTerm(d);
    const double* current = terms + firstTerm(d);
    const double* lower = terms + firstTerm(d - 1);
    slope.value += coefficients[d] * current[d];
    for (int y = 0; y < d; ++y)
    {
      slope.value += coefficients[y] * current[y];
      // x^(d-y) y^y derives to terms of degree d - 1.
      slope.gradient.x() += coefficients[y] * (d - y) * lower[y];
      slope.gradient.y() += coefficients[y + 1] * (y + 1) * lower[y];
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
