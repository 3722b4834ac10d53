#include "SpatialQuadric.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double Determined = 1e-9; // of the largest eigenvalue: below, a quadric that vanishes
constexpr double MostDeviations = 6.0;
constexpr double Rounding = 1e-16; // squared, of the values

} // namespace

QuadricVector quadricTerms(const Vector3d& place)
{
  const double x = place.x();
  const double y = place.y();
  const double z = place.z();
  QuadricVector terms;
  terms << 1.0, x, y, z, x * x, x * y, x * z, y * y, y * z, z * z;
  return terms;
}

void QuadricMoments::add(const Vector3d& place, double value)
{
  const QuadricVector terms = quadricTerms(place);
  this->normal_.selfadjointView<Eigen::Lower>().rankUpdate(terms);
  this->right_ += value * terms;
  this->squares_ += value * value;
  ++this->count_;
}

SpatialQuadric QuadricMoments::solve() const
{
  const QuadricMatrix normal = this->normal_.selfadjointView<Eigen::Lower>();
  const QuadricVector scale = normal.diagonal().unaryExpr(
    [](double square) { return square > 0.0 ? 1.0 / std::sqrt(square) : 0.0; });
  const Eigen::SelfAdjointEigenSolver<QuadricMatrix> scaled(
    scale.asDiagonal() * normal * scale.asDiagonal());
  const double least = Determined * scaled.eigenvalues().maxCoeff();
  const QuadricVector inverted = scaled.eigenvalues().unaryExpr(
    [&](double eigenvalue) { return eigenvalue > least ? 1.0 / eigenvalue : 0.0; });
  const QuadricMatrix vectors = scale.asDiagonal() * scaled.eigenvectors();
  SpatialQuadric quadric;
  quadric.inverse = vectors * inverted.asDiagonal() * vectors.transpose();
  quadric.coefficients = quadric.inverse * this->right_;
  const auto unknowns = static_cast<Index>((inverted.array() > 0.0).count());
  const double residual = this->squares_ - quadric.coefficients.dot(this->right_);
  quadric.variance = this->count_ > unknowns
    ? std::max(Rounding * this->squares_, residual) / (this->count_ - unknowns)
    : 0.0;
  return quadric;
}

QuadricMatrix QuadricMoments::spread() const
{
  const QuadricVector sums = this->normal_.col(0);
  QuadricMatrix result = this->normal_.selfadjointView<Eigen::Lower>();
  result -= sums * sums.transpose() / std::max<Index>(1, this->count_);
  return result;
}

bool areAlike(
  const SpatialQuadric& ofSome, const SpatialQuadric& ofAll, const QuadricMatrix& spread)
{
  const QuadricVector difference = ofSome.coefficients - ofAll.coefficients;
  const QuadricMatrix expected = ofSome.variance * spread * (ofSome.inverse - ofAll.inverse);
  const double deviation = std::sqrt(std::max(0.0, 2.0 * (expected * expected).trace()));
  return difference.dot(spread * difference) <= expected.trace() + MostDeviations * deviation;
}

} // namespace SurfaceScalars
