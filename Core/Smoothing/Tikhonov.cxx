#include "Tikhonov.h"

#include "NumberText.h"
#include "Require.h"
#include "SmoothingSystem.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr double NegligibleShare = 0.1; // of f: where less is left, errors are compared with this
constexpr double Flat = 8 * std::numeric_limits<double>::epsilon(); // no more than rounding errors

/// Where the lumped mass is not that of triangles, it is this.
Eigen::SparseMatrix<double> massMatrix(
  const Values& lumped, const PointsRef& vertices, const Triangles& triangles)
{
  std::vector<Eigen::Triplet<double, int>> entries;
  entries.reserve(static_cast<std::size_t>(9 * triangles.cols() + lumped.size()));
  Values areas = Values::Zero(lumped.size());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
  {
    const auto corners = triangles.col(t);
    const Vector3d first = vertices.col(corners[0]);
    const double area =
      (vertices.col(corners[1]) - first).cross(vertices.col(corners[2]) - first).norm() / 2;
    for (int row = 0; row < 3; ++row)
    {
      areas[corners[row]] += area;
      for (int column = 0; column < 3; ++column)
      {
        entries.emplace_back(static_cast<int>(corners[row]), static_cast<int>(corners[column]),
          row == column ? area / 6 : area / 12);
      }
    }
  }
  for (int i = 0; i < static_cast<int>(lumped.size()); ++i)
  {
    entries.emplace_back(i, i, areas[i] > 0.0 ? 0.0 : lumped[i]);
  }
  Eigen::SparseMatrix<double> result(lumped.size(), lumped.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

} // namespace

Eigen::SparseMatrix<double> metricMatrix(DataMetric metric, const Laplacian& laplacian,
  const PointsRef& vertices, const Triangles& triangles)
{
  const Values& mass = laplacian.mass;
  switch (metric)
  {
    case DataMetric::Identity:
      return Eigen::SparseMatrix<double>(Values::Constant(mass.size(), mass.mean()).asDiagonal());
    case DataMetric::MassMatrix:
      return massMatrix(mass, vertices, triangles);
    case DataMetric::LumpedMass:
      break;
  }
  return Eigen::SparseMatrix<double>(mass.asDiagonal());
}

TikhonovSmoother::TikhonovSmoother(std::shared_ptr<const Laplacian> laplacian,
  const Eigen::SparseMatrix<double>& metric, SmoothingEnergy energy)
{
  const std::string size = std::to_string(laplacian->mass.size());
  require(metric.rows() == laplacian->mass.size() && metric.cols() == metric.rows(),
    "a metric of " + size + " rows and columns, one for each vertex",
    std::to_string(metric.rows()) + " and " + std::to_string(metric.cols()),
    "Make it from the same mesh.");
  this->system_ = std::make_shared<SmoothingSystem>(std::move(laplacian), metric, energy);
}

Values TikhonovSmoother::smooth(
  const ValuesRef& values, double epsilon, const Execution& execution, double accuracy) const
{
  require(values.size() == this->size(),
    "a value at each of " + std::to_string(this->size()) + " vertices",
    std::to_string(values.size()) + " values", "Choose another array.");
  require(values.allFinite(), "finite values", "a value that is not", "Remove such points.");
  require(std::isfinite(epsilon) && epsilon > 0.0, "a finite Epsilon above 0", textOf(epsilon),
    "Choose about 1e5, or let it be chosen.");

  const Values rest = values - this->system_->means().of(values);
  const double scale = rest.lpNorm<Eigen::Infinity>();
  if (scale <= Flat * values.lpNorm<Eigen::Infinity>())
  {
    return values;
  }
  const double weight = this->weight(epsilon);
  const Values right = weight * this->system_->metricProduct(rest / scale, execution.part(0, 0));
  const Values smoothed =
    this->system_->solve(right, weight, accuracy / 100.0, NegligibleShare, execution);
  return values - (rest - scale * smoothed);
}

double TikhonovSmoother::energy(const ValuesRef& values) const
{
  const Values rest = values - this->system_->means().of(values);
  return std::max(0.0, rest.dot(this->system_->energyProduct(rest, {})));
}

double TikhonovSmoother::distance(const ValuesRef& a, const ValuesRef& b) const
{
  const Values difference = a - b;
  return std::sqrt(std::max(0.0, this->product(difference, difference)));
}

double TikhonovSmoother::product(const ValuesRef& a, const ValuesRef& b) const
{
  return a.dot(this->system_->metricProduct(b, {}));
}

double TikhonovSmoother::weight(double epsilon) const
{
  const bool isHarmonic = this->system_->energy() == SmoothingEnergy::Harmonic;
  return epsilon / this->area() / (isHarmonic ? 1.0 : this->area());
}

double TikhonovSmoother::smoothingLength(double epsilon) const
{
  const bool isHarmonic = this->system_->energy() == SmoothingEnergy::Harmonic;
  return std::sqrt(this->area() / (isHarmonic ? epsilon : std::sqrt(epsilon)));
}

double TikhonovSmoother::epsilonOfLength(double length) const
{
  const double squares = this->area() / length / length;
  return this->system_->energy() == SmoothingEnergy::Harmonic ? squares : squares * squares;
}

Eigen::Index TikhonovSmoother::size() const
{
  return this->system_->laplacian().mass.size();
}

double TikhonovSmoother::area() const
{
  return this->system_->laplacian().mass.sum();
}

} // namespace SurfaceScalars
