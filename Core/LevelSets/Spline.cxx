#include "Spline.h"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index FewestIntervals = 4;
// Weight of the second differences beside the mean weight of the data: only decides where data are
// missing.
constexpr double Stiffness = 1e-4;

} // namespace

CubicSpline::CubicSpline(const Points& points, const std::vector<double>& parameters,
  const std::vector<double>& weights, double length, double knotSpacing, bool closed)
  : intervals_(
      std::max(FewestIntervals, static_cast<Eigen::Index>(std::ceil(length / knotSpacing))))
  , length_(length)
  , closed_(closed)
{
  const Eigen::Index count = closed ? this->intervals_ : this->intervals_ + 3;
  std::vector<Eigen::Triplet<double>> triplets;
  Eigen::MatrixX3d rightSide = Eigen::MatrixX3d::Zero(count, 3);
  double totalWeight = 0.0;
  for (std::size_t i = 0; i < parameters.size(); ++i)
  {
    const Span span = this->spanAt(parameters[i]);
    totalWeight += weights[i];
    for (int a = 0; a < 4; ++a)
    {
      const double weighted = weights[i] * span.weights[a];
      rightSide.row(span.indices[a]) +=
        weighted * points.col(static_cast<Eigen::Index>(i)).transpose();
      for (int b = 0; b < 4; ++b)
      {
        triplets.emplace_back(span.indices[a], span.indices[b], weighted * span.weights[b]);
      }
    }
  }
  const double stiffness = Stiffness * totalWeight / static_cast<double>(count);
  const double difference[3] = { 1.0, -2.0, 1.0 };
  for (Eigen::Index i = 0; i < (closed ? count : count - 2); ++i)
  {
    for (Eigen::Index a = 0; a < 3; ++a)
    {
      for (Eigen::Index b = 0; b < 3; ++b)
      {
        triplets.emplace_back(
          (i + a) % count, (i + b) % count, stiffness * difference[a] * difference[b]);
      }
    }
  }
  Eigen::SparseMatrix<double> normalMatrix(count, count);
  normalMatrix.setFromTriplets(triplets.begin(), triplets.end());
  this->controls_ =
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(normalMatrix).solve(rightSide);
}

CubicSpline::Span CubicSpline::spanAt(double parameter) const
{
  const double x = parameter / this->length_ * static_cast<double>(this->intervals_);
  const Eigen::Index interval =
    std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::floor(x)), 0, this->intervals_ - 1);
  const double u = x - static_cast<double>(interval);
  const double v = 1.0 - u;
  Span span{ {},
    { v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
      (3.0 * v * v * v - 6.0 * v * v + 4.0) / 6.0, u * u * u / 6.0 } };
  for (Eigen::Index i = 0; i < 4; ++i)
  {
    span.indices[i] = this->closed_ ? (interval + i) % this->intervals_ : interval + i;
  }
  return span;
}

Vector3d CubicSpline::operator()(double parameter) const
{
  const Span span = this->spanAt(parameter);
  Vector3d place = Vector3d::Zero();
  for (int i = 0; i < 4; ++i)
  {
    place += span.weights[i] * this->controls_.row(span.indices[i]).transpose();
  }
  return place;
}

} // namespace SurfaceScalars
