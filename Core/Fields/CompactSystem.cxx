#include "CompactSystem.h"

#include "FieldChecks.h"
#include "NumberText.h"
#include "RadialRefusal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1024; // rows per block of a parallel loop
constexpr int MostSteps = 500;      // of conjugate gradients; some 40 are usual
constexpr int MostRestarts = 3;
constexpr int PowerSteps = 20; // for the order of magnitude
constexpr double LargestResidual = 1e-10;
constexpr double Tolerance = 1e-11; // of the residual, relative to the right-hand side; largest

double largest(const Values& values)
{
  return values.lpNorm<Eigen::Infinity>();
}

struct Rows
{
  std::vector<int> lengths;
  std::vector<int> columns;
  std::vector<double> entries;
};

Rows kernelRows(const PointCloud& cloud, const RadialKernel& kernel, double regularization,
  std::size_t begin, std::size_t end)
{
  Rows rows;
  Neighborhood found;
  std::vector<std::pair<int, double>> row;
  for (std::size_t i = begin; i < end; ++i)
  {
    cloud.within(cloud.points().col(static_cast<Eigen::Index>(i)), kernel.support(), found);
    row.clear();
    for (std::size_t j = 0; j < found.indices.size(); ++j)
    {
      row.emplace_back(found.indices[j],
        kernel.value(std::sqrt(found.squaredDistances[j])) +
          (found.indices[j] == i ? regularization : 0.0));
    }
    std::sort(row.begin(), row.end());
    for (const auto& [column, entry] : row)
    {
      rows.columns.push_back(column);
      rows.entries.push_back(entry);
    }
    rows.lengths.push_back(static_cast<int>(row.size()));
  }
  return rows;
}

SparseMatrix kernelMatrix(const PointCloud& cloud, const RadialKernel& kernel,
  double regularization, const Execution& execution)
{
  const std::size_t count = cloud.pointCount();
  std::vector<Rows> blocks((count + Grain - 1) / Grain);
  parallelFor(count, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    { blocks[begin / Grain] = kernelRows(cloud, kernel, regularization, begin, end); });
  std::size_t entryCount = 0;
  for (const Rows& block : blocks)
  {
    entryCount += block.entries.size();
  }
  const auto size = static_cast<Eigen::Index>(count);
  SparseMatrix matrix(size, size);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(entryCount));
  int* start = matrix.outerIndexPtr();
  int* column = matrix.innerIndexPtr();
  double* entry = matrix.valuePtr();
  *start = 0;
  for (Rows& block : blocks)
  {
    for (const int length : block.lengths)
    {
      start[1] = start[0] + length;
      ++start;
    }
    column = std::copy(block.columns.begin(), block.columns.end(), column);
    entry = std::copy(block.entries.begin(), block.entries.end(), entry);
    block = Rows(); // to not have everything twice
  }
  return matrix;
}

/// Of a positive definite matrix, from below, by power iteration.
/// @param multiply the product of the matrix with a vector
template <class Product>
double largestEigenvalue(Eigen::Index size, const Product& multiply)
{
  // Rough, to have a share in every eigenvector.
  Values vector = Values::NullaryExpr(
    size, [](Eigen::Index i) { return 1.0 + 0.5 * std::sin(static_cast<double>(i * i)); });
  double eigenvalue = 0.0;
  for (int step = 0; step < PowerSteps; ++step)
  {
    vector.normalize();
    vector = multiply(vector);
    eigenvalue = vector.norm();
  }
  return eigenvalue;
}

} // namespace

double meanNeighborCount(const PointCloud& cloud, double radius, const Execution& execution)
{
  const std::size_t stride = std::max<std::size_t>(1, cloud.pointCount() / 200);
  std::vector<double> counts((cloud.pointCount() + stride - 1) / stride);
  parallelFor(counts.size(), 1, execution,
    [&](std::size_t some, std::size_t)
    {
      Neighborhood found;
      cloud.within(cloud.points().col(static_cast<Eigen::Index>(some * stride)), radius, found);
      counts[some] = static_cast<double>(found.indices.size());
    });
  return std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
}

CompactSystem::CompactSystem(const PointCloud& cloud, const RadialKernel& kernel,
  double regularization, const Execution& execution)
  : kernel_(kernel)
  , terms_(cloud.points())
  , matrix_(kernelMatrix(cloud, kernel, regularization, execution.part(0.0, 0.1)))
  , preconditioner_(this->matrix_, execution.part(0.1, 0.3))
  , polynomials_(this->terms_.at(cloud.points()))
{
  if (!this->preconditioner_.isPositiveDefinite())
  {
    refuseSystem("a system that is singular at machine precision", kernel,
      std::numeric_limits<double>::infinity());
  }
  this->solved_.resizeLike(this->polynomials_);
  const auto count = static_cast<double>(this->terms_.count());
  for (Eigen::Index term = 0; term < this->terms_.count(); ++term)
  {
    const double before = static_cast<double>(term);
    this->solved_.col(term) = this->solveKernel(this->polynomials_.col(term),
      execution.part(0.3 + 0.7 * before / count, 0.3 + 0.7 * (before + 1.0) / count));
  }
  this->schur_.compute(this->polynomials_.transpose() * this->solved_);
}

Values CompactSystem::multiply(const Values& vector, const Execution& execution) const
{
  Values result(vector.size());
  parallelFor(static_cast<std::size_t>(vector.size()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto first = static_cast<Eigen::Index>(begin);
      const auto count = static_cast<Eigen::Index>(end - begin);
      result.segment(first, count).noalias() = this->matrix_.middleRows(first, count) * vector;
    });
  return result;
}

/// That of the matrix, estimated: the preconditioner stands for the inverse.
double CompactSystem::condition(const Execution& execution) const
{
  const auto size = this->matrix_.rows();
  return largestEigenvalue(
           size, [&](const Values& vector) { return this->multiply(vector, execution); }) *
    largestEigenvalue(
      size, [&](const Values& vector) { return this->preconditioner_.apply(vector, execution); });
}

/// Conjugate gradients, begun anew from where they are when rounding errors have led them astray.
Values CompactSystem::solveKernel(const Values& right, const Execution& execution) const
{
  const double goal = Tolerance * largest(right);
  const Execution polling = execution.part(0.0, 0.0);
  Values solution = Values::Zero(right.size());
  Values residual = right;
  for (int restart = 0; restart <= MostRestarts && largest(residual) > goal; ++restart)
  {
    Values direction = Values::Zero(right.size());
    double last = 1.0;
    for (int step = 0; step < MostSteps && largest(residual) > goal; ++step)
    {
      const Values preconditioned = this->preconditioner_.apply(residual, polling);
      const double product = residual.dot(preconditioned);
      direction = preconditioned + (step > 0 ? product / last : 0.0) * direction;
      last = product;
      const Values image = this->multiply(direction, polling);
      const double length = product / direction.dot(image);
      solution += length * direction;
      residual -= length * image;
    }
    residual = right - this->multiply(solution, polling);
  }
  if (!(largest(residual) <= LargestResidual * largest(right)))
  {
    refuseSystem("conjugate gradients that leave a residual of " +
        textOf(largest(residual) / largest(right)) + ", not " + textOf(LargestResidual) + ",",
      this->kernel_, this->condition(polling));
  }
  execution.report(1.0);
  return solution;
}

CompactSystem::Solution CompactSystem::solve(const Values& values, const Execution& execution) const
{
  // The constant part is left to the polynomial, which keeps the digits of small differences.
  const double constant = values.mean();
  const Values varying = values.array() - constant;
  const Values beta = this->schur_.solve(this->solved_.transpose() * varying);
  Solution result{ this->solveKernel(varying - this->polynomials_ * beta, execution),
    this->terms_.polynomial(beta) };
  result.tail[0] += constant;
  return result;
}

} // namespace SurfaceScalars
