#include "RadialBasisFit.h"

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
  this->terms_ = LinearTerms(this->centers_);
  this->polynomials_.compute(this->terms_.at(this->centers_));
  this->assemble(regularization, execution.part(0.0, 0.1));
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
  FieldJet result;
  result.value = this->value(place);
  if (derivatives == Derivatives::None)
  {
    return result;
  }
  result.gradient = this->tail_.tail<3>();
  result.hessian.setZero();
  for (Eigen::Index i = 0; i < this->centers_.cols(); ++i)
  {
    const Vector3d offset = place - this->centers_.col(i);
    const double radius = offset.norm();
    const KernelJet phi = this->kernel_.jet(radius);
    const double alpha = this->coefficients_[i];
    result.gradient += (alpha * phi.slopeOverRadius) * offset;
    if (derivatives == Derivatives::Hessian)
    {
      result.hessian.diagonal().array() += alpha * phi.slopeOverRadius;
      if (radius > 0.0)
      {
        const Vector3d direction = offset / radius;
        result.hessian +=
          (alpha * (phi.curvature - phi.slopeOverRadius)) * direction * direction.transpose();
      }
    }
  }
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

Values RadialBasisFit::leaveOneOutErrors() const
{
  // With G = Q2 B22^-1 Q2^T, alpha = G f and the error at i is alpha_i / G_ii.
  const Eigen::Index count = this->matrix_.rows();
  Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(count, count);
  basis.applyOnTheLeft(this->polynomials_.householderQ().adjoint());
  Eigen::MatrixXd rows = basis.bottomRows(count - this->terms_.count());
  this->cholesky_.matrixL().solveInPlace(rows);
  const Values diagonal = rows.colwise().squaredNorm().transpose();
  return this->kernel_.sign() * this->coefficients_.cwiseQuotient(diagonal);
}

} // namespace SurfaceScalars
