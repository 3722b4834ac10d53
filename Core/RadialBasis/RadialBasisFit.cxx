#include "RadialBasisFit.h"

#include "RadialRefusal.h"
#include "RadialSum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t ColumnsPerBlock = 64; // of a parallel loop
// A column of a least-squares system that the others explain up to this share is left out.
constexpr double SmallestShare = 1e-10;
// The share of a center's unit vector that is orthogonal to all polynomials, squared: below this,
// the other centers lack a direction of the polynomial. At most four centers can have so little.
constexpr double SmallestFreedom = 1e-6;

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using FourColumns = Eigen::Matrix<double, Eigen::Dynamic, 4>;

/// Of places, one per row, from another.
template <class Places>
auto squaredDistances(const Places& places, const Vector3d& from)
{
  return (places.col(0).array() - from.x()).square() + (places.col(1).array() - from.y()).square() +
    (places.col(2).array() - from.z()).square();
}

} // namespace

/// sign() times the kernel matrix, its lower triangle.
void RadialBasisFit::assemble(double regularization, const Execution& execution)
{
  const Eigen::Index count = this->centers_.cols();
  this->matrix_.resize(count, count);
  const auto fillColumns = [&](std::size_t begin, std::size_t end)
  {
    for (auto j = static_cast<Eigen::Index>(begin); j < static_cast<Eigen::Index>(end); ++j)
    {
      auto column = this->matrix_.col(j).tail(count - j).array();
      column = squaredDistances(this->rows_.bottomRows(count - j), this->centers_.col(j));
      this->kernel_.apply(column);
      column *= this->kernel_.sign();
      column[0] += regularization;
    }
  };
  if (count <= static_cast<Eigen::Index>(ColumnsPerBlock))
  {
    fillColumns(0, static_cast<std::size_t>(count));
    return;
  }
  parallelFor(static_cast<std::size_t>(count), ColumnsPerBlock, execution, fillColumns);
}

/// Q^T A Q for the product Q = I - V T V^T of the reflections, by one pass over A for A V and one
/// for a symmetric update.
void RadialBasisFit::transformKernelMatrix()
{
  const Eigen::Index count = this->matrix_.rows();
  FourColumns v = FourColumns::Zero(count, 4);
  Eigen::Matrix4d t = Eigen::Matrix4d::Zero();
  for (Eigen::Index k = 0; k < this->terms_.count(); ++k)
  {
    v(k, k) = 1.0;
    v.col(k).tail(count - k - 1) = this->polynomials_.matrixQR().col(k).tail(count - k - 1);
    const double tau = this->polynomials_.hCoeffs()[k];
    const Eigen::Vector4d overlap = v.transpose() * v.col(k); // with those before
    t(k, k) = tau;
    t.col(k).head(k) = -tau * (t.topLeftCorner(k, k) * overlap.head(k));
  }
  FourColumns w = FourColumns::Zero(count, 4);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const Eigen::Index below = count - j - 1;
    const auto column = this->matrix_.col(j).tail(below);
    w.row(j) +=
      this->matrix_(j, j) * v.row(j) + column.transpose().lazyProduct(v.bottomRows(below));
    w.bottomRows(below) += column.lazyProduct(v.row(j));
  }
  w = (w * t).eval();
  w -= 0.5 * v * (t.transpose() * (v.transpose() * w)).eval();
  for (Eigen::Index j = 0; j < count; ++j)
  {
    const Eigen::Index rest = count - j;
    this->matrix_.col(j).tail(rest) -= w.bottomRows(rest).lazyProduct(v.row(j).transpose()) +
      v.bottomRows(rest).lazyProduct(w.row(j).transpose());
  }
}

bool RadialBasisFit::factor(const PointsRef& centers, const RadialKernel& kernel,
  double regularization, const Execution& execution)
{
  this->centers_ = centers;
  this->rows_ = centers.transpose();
  this->kernel_ = kernel;
  this->regularization_ = regularization;
  this->terms_ = LinearTerms(this->centers_);
  this->polynomials_.compute(this->terms_.at(this->centers_));
  // phi of the Linear kernel is a length, that of all others is of order 1.
  const double unit = kernel.type() == KernelType::Linear ? kernel.width() : 1.0;
  this->assemble(regularization * unit, execution.part(0.0, 0.1));
  this->transformKernelMatrix();

  const Eigen::Index count = centers.cols();
  const Eigen::Index rest = count - this->terms_.count();
  if (rest == 0)
  {
    this->pivotRatio_ = 1.0;
    return true;
  }
  this->cholesky_.compute(this->matrix_.bottomRightCorner(rest, rest), execution.part(0.1, 1.0));
  this->pivotRatio_ = 0.0;
  if (this->cholesky_.info() == Eigen::Success)
  {
    const auto pivots = this->cholesky_.matrixLLT().diagonal().array().square();
    this->pivotRatio_ = pivots.minCoeff() / pivots.maxCoeff();
  }
  // Where centers nearly coincide, the last pivots are made of rounding errors alone, which the
  // pivots before them have magnified: unless all are far above that, only the condition tells.
  const double precision = static_cast<double>(count) * std::numeric_limits<double>::epsilon();
  return this->pivotRatio_ > 10.0 * std::sqrt(precision) || this->reciprocalCondition() > precision;
}

void RadialBasisFit::solve(const ValuesRef& values)
{
  const Eigen::Index rest = this->matrix_.rows() - this->terms_.count();
  // The constant part is left to the polynomial, which keeps the digits of small differences.
  const double constant = values.mean();
  Values transformed =
    this->polynomials_.householderQ().adjoint() * (values.array() - constant).matrix();
  Values polynomial = transformed.head(this->terms_.count());
  Values kernel = Values::Zero(values.size());
  if (rest > 0)
  {
    kernel.tail(rest) = this->cholesky_.solve(transformed.tail(rest));
    polynomial -=
      this->matrix_.bottomLeftCorner(rest, this->terms_.count()).transpose() * kernel.tail(rest);
  }
  this->coefficients_ = this->kernel_.sign() * (this->polynomials_.householderQ() * kernel);
  this->polynomials_.matrixQR()
    .topLeftCorner(this->terms_.count(), this->terms_.count())
    .triangularView<Eigen::Upper>()
    .solveInPlace(polynomial);
  this->tail_ = this->terms_.polynomial(polynomial);
  this->tail_[0] += constant;
  this->values_ = values;
}

/// The transpose of what solve() does, step by step.
Eigen::MatrixXd RadialBasisFit::dependsOnValues(
  const Eigen::MatrixXd& kernels, const Eigen::MatrixXd& polynomials) const
{
  const Eigen::Index terms = this->terms_.count();
  const Eigen::Index rest = this->matrix_.rows() - terms;
  Eigen::MatrixXd result =
    this->kernel_.sign() * (this->polynomials_.householderQ().adjoint() * kernels);
  result.topRows(terms) = this->polynomials_.matrixQR()
                            .topLeftCorner(terms, terms)
                            .triangularView<Eigen::Upper>()
                            .transpose()
                            .solve(polynomials);
  if (rest > 0)
  {
    result.bottomRows(rest) -= this->matrix_.bottomLeftCorner(rest, terms) * result.topRows(terms);
    result.bottomRows(rest) = this->cholesky_.solve(result.bottomRows(rest)).eval();
  }
  return this->polynomials_.householderQ() * result;
}

double RadialBasisFit::largestResidual() const
{
  double largest = 0.0;
  for (Eigen::Index i = 0; i < this->values_.size(); ++i)
  {
    const double miss = std::abs(this->value(this->centers_.col(i)) - this->values_[i]);
    if (!std::isfinite(miss))
    {
      return std::numeric_limits<double>::infinity();
    }
    largest = std::max(largest, miss);
  }
  return largest;
}

double RadialBasisFit::residualBound() const
{
  const auto offsets = this->centers_.colwise() - this->terms_.origin();
  const double radius = std::sqrt(offsets.colwise().squaredNorm().maxCoeff());
  const double phi =
    std::max(std::abs(this->kernel_.value(0.0)), std::abs(this->kernel_.value(2.0 * radius)));
  return static_cast<double>(this->values_.size()) * std::numeric_limits<double>::epsilon() *
    (phi * this->coefficients_.lpNorm<1>() + this->tail_.tail<3>().norm() * radius);
}

bool RadialBasisFit::approximate(const PointsRef& centers, const RadialKernel& kernel,
  const PointsRef& places, const ValuesRef& values, const ValuesRef& weights)
{
  this->centers_ = centers;
  this->rows_ = centers.transpose();
  this->kernel_ = kernel;
  this->terms_ = LinearTerms(places);
  const Eigen::Index count = centers.cols();
  const Rows rows = places.transpose();
  this->matrix_.resize(places.cols(), count + this->terms_.count());
  for (Eigen::Index j = 0; j < count; ++j)
  {
    auto column = this->matrix_.col(j).array();
    column = squaredDistances(rows, centers.col(j));
    kernel.apply(column);
  }
  this->matrix_.rightCols(this->terms_.count()) = this->terms_.at(places);
  const Values factors = weights.cwiseSqrt();
  this->matrix_.array().colwise() *= factors.array();

  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(this->matrix_.rows(), this->matrix_.cols());
  qr.setThreshold(SmallestShare);
  const Values solution = qr.compute(this->matrix_).solve(factors.cwiseProduct(values));
  this->coefficients_ = solution.head(count);
  this->tail_ = this->terms_.polynomial(solution.tail(this->terms_.count()));
  return solution.allFinite();
}

double RadialBasisFit::value(const Vector3d& place) const
{
  Eigen::ArrayXd phi = squaredDistances(this->rows_, place);
  this->kernel_.apply(phi);
  return this->tail_[0] + this->tail_.tail<3>().dot(place - this->terms_.origin()) +
    this->coefficients_.dot(phi.matrix());
}

FieldJet RadialBasisFit::jet(const Vector3d& place, Derivatives derivatives) const
{
  FieldJet result = linearJet(this->tail_, place - this->terms_.origin());
  if (derivatives != Derivatives::None)
  {
    for (Eigen::Index i = 0; i < this->centers_.cols(); ++i)
    {
      addRadialTerm(
        result, this->coefficients_[i], this->kernel_, place - this->centers_.col(i), derivatives);
    }
  }
  result.value = this->value(place); // to the same bits, whatever derivatives are asked for
  return result;
}

double RadialBasisFit::reciprocalCondition() const
{
  const Eigen::Index rest = this->matrix_.rows() - this->terms_.count();
  const bool factored = rest == 0 || this->cholesky_.info() == Eigen::Success;
  if (!factored || rest == 0)
  {
    return factored ? 1.0 : 0.0;
  }
  return std::min(this->pivotRatio_, this->cholesky_.rcond());
}

double RadialBasisFit::errorWithout(Eigen::Index center) const
{
  const Eigen::Index last = this->centers_.cols() - 1;
  Points others = this->centers_.leftCols(last);
  Values values = this->values_.head(last);
  if (center < last)
  {
    others.col(center) = this->centers_.col(last);
    values[center] = this->values_[last];
  }
  RadialBasisFit fit;
  if (!fit.factor(others, this->kernel_, this->regularization_))
  {
    refuseSystem("a singular system without one of the centers", this->kernel_,
      1.0 / fit.reciprocalCondition());
  }
  fit.solve(values);
  return this->values_[center] - fit.value(this->centers_.col(center));
}

Values RadialBasisFit::leaveOneOutErrors(const Execution& execution) const
{
  const Eigen::Index count = this->matrix_.rows();
  if (count < 2)
  {
    throw InvalidInput("at least 2 samples for leave-one-out errors", std::to_string(count),
      "Use more samples, or switch the errors off.");
  }
  // With G = Q2 B22^-1 Q2^T, alpha = G f and the error at i is alpha_i / G_ii.
  const Eigen::Index rest = count - this->terms_.count();
  Values result(count);
  const auto divide = [&](std::size_t begin, std::size_t end)
  {
    const auto first = static_cast<Eigen::Index>(begin);
    const auto width = static_cast<Eigen::Index>(end) - first;
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(count, width);
    basis.middleRows(first, width).setIdentity();
    basis.applyOnTheLeft(this->polynomials_.householderQ().adjoint());
    Eigen::MatrixXd rows = basis.bottomRows(rest);
    const Values freedom = rows.colwise().squaredNorm().transpose();
    if (rest > 0)
    {
      this->cholesky_.matrixL().solveInPlace(rows);
    }
    for (Eigen::Index j = 0; j < width; ++j)
    {
      const Eigen::Index i = first + j;
      result[i] = freedom[j] < SmallestFreedom
        ? this->errorWithout(i)
        : this->kernel_.sign() * this->coefficients_[i] / rows.col(j).squaredNorm();
    }
  };
  parallelFor(static_cast<std::size_t>(count), ColumnsPerBlock, execution, divide);
  return result;
}

} // namespace SurfaceScalars
