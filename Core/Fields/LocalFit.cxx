#include "LocalFit.h"

#include "Monomials.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace SurfaceScalars
{
namespace
{

// A column of the normal matrix that the others explain to this fraction carries rounding errors
// only.
constexpr double SingularFraction = 1e-9;

// Of the shortest axis of a neighborhood, for a trace of 1; beyond these limits a slower way is
// taken.
constexpr int NewtonIterations = 8;
constexpr double RootTolerance = 1e-15;
constexpr double SmallestSpan = 1e-2; // product of the other two eigenvalues

constexpr int Lanes = 8; // samples that are computed with side by side
using Lane = Eigen::Array<double, Lanes, 1>;

/// Unit eigenvector of the smallest eigenvalue of a covariance.
Vector3d flattestDirection(const Eigen::Matrix3d& covariance)
{
  // Below that eigenvalue the characteristic polynomial falls and is convex: Newton's method from 0
  // ascends to it, in few steps where the points are flat.
  const Eigen::Matrix3d scaled = covariance / covariance.trace();
  const double minors = 0.5 * (1.0 - scaled.squaredNorm());
  const double determinant = scaled.determinant();
  double smallest = 0.0;
  for (int i = 0; i < NewtonIterations; ++i)
  {
    const double value = determinant - smallest * (minors - smallest * (1.0 - smallest));
    const double fall = minors - smallest * (2.0 - 3.0 * smallest);
    const double step = value / fall;
    smallest += step;
    if (std::abs(step) <= RootTolerance)
    {
      // The other two directions span the columns of what is left.
      Eigen::Matrix3d left = scaled;
      left.diagonal().array() -= smallest;
      const Vector3d normals[] = { left.col(0).cross(left.col(1)), left.col(1).cross(left.col(2)),
        left.col(2).cross(left.col(0)) };
      const Vector3d& longest = *std::max_element(std::begin(normals), std::end(normals),
        [](const Vector3d& a, const Vector3d& b) { return a.squaredNorm() < b.squaredNorm(); });
      if (longest.norm() > SmallestSpan)
      {
        return longest.normalized();
      }
      break;
    }
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(covariance);
  return axes.eigenvectors().col(0).normalized();
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

/// Replaces the lower triangle by Cholesky's factor L; false unless the matrix is positive
/// definite. Whole columns are computed, for which loops are unrolled: what is above the diagonal
/// has no meaning.
template <class Matrix>
bool factorize(Matrix& matrix)
{
  constexpr int Terms = Matrix::RowsAtCompileTime;
  for (int k = 0; k < Terms; ++k)
  {
    Eigen::Array<double, Terms, 1> known = Eigen::Array<double, Terms, 1>::Zero();
    for (int j = 0; j < k; ++j)
    {
      known += matrix.col(j).array() * matrix(k, j);
    }
    const double squaredPivot = matrix(k, k) - known[k];
    if (squaredPivot <= 0.0)
    {
      return false;
    }
    const double pivot = std::sqrt(squaredPivot);
    matrix.col(k).array() = (matrix.col(k).array() - known) / pivot;
    matrix(k, k) = pivot;
  }
  return true;
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
  return withDegree(this->degree_, [this](auto constant) { return this->solve<constant>(); });
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
  const Vector3d normal = flattestDirection(covariance);
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
  double squares = 0.0; // of the values, weighted
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
    squares += (terms[0] * values.square()).sum();
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
  Eigen::Matrix<double, Terms, Terms> matrix = arrange<Degree>(products);
  const Eigen::Array<double, Terms, 1> diagonal = matrix.diagonal();
  if (!factorize(matrix) ||
    (matrix.diagonal().array().square() < SingularFraction * diagonal).any())
  {
    return false;
  }
  const Eigen::Matrix<double, Terms, 1> valueSide = sides.col(1);
  solveTriangles(matrix, sides);
  this->valueMisfit_ =
    std::sqrt(std::max(0.0, squares - valueSide.dot(sides.col(1))) / products[0]);
  this->coefficients_.template topRows<Terms>() = sides;
  this->coefficients_.col(0) *= this->scale_;
  this->coefficients_(0, 1) += this->valueOrigin_;
  return this->coefficients_.template topRows<Terms>().allFinite();
}

} // namespace SurfaceScalars
