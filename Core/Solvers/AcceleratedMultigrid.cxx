#include "AcceleratedMultigrid.h"

#include "RowOrder.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int NearRows = 8192; // whose values caches hold
constexpr int EstimationSteps = 8;
constexpr double Margin = 0.9; // of an estimate from above
constexpr double MostLeast = 0.999;
constexpr double Negligible = 1e-20; // what is left of a square: the method has come to its end

} // namespace

AcceleratedMultigrid::AcceleratedMultigrid(
  const RowMatrix& matrix, double error, const Execution& execution)
  : order_(orderOfRows(matrix, NearRows))
  , multigrid_(this->order_.empty()
        ? Multigrid(matrix, true, execution.part(0.0, 0.6))
        : Multigrid(inOrder(matrix, this->order_), true, execution.part(0.0, 0.6)))
  , least_(this->estimateLeast(matrix.rows(), execution.part(0.6, 1.0)))
  , cycleCount_(static_cast<int>(
      std::ceil(std::acosh(1.0 / error) / std::acosh((1.0 + this->least_) / (1.0 - this->least_)))))
{
}

/// By the method of Lanczos, from the coefficients of conjugate gradients.
double AcceleratedMultigrid::estimateLeast(Eigen::Index rows, const Execution& execution) const
{
  if (this->multigrid_.isExact())
  {
    return MostLeast;
  }
  std::mt19937_64 random(1);
  Values residual =
    Values::NullaryExpr(rows, [&]() { return (random() >> 63U) == 0 ? 1.0 : -1.0; });
  Values error = this->multigrid_.apply(residual, execution.part(0.0, 0.0));
  Values direction = error;
  double product = residual.dot(error);
  const double least = Negligible * product;
  Values diagonal(EstimationSteps);
  Values beside(EstimationSteps);
  const Values none = Values::Zero(rows);
  double carried = 0.0;
  int step = 0;
  for (; step < EstimationSteps && product > least; ++step)
  {
    const double done = static_cast<double>(step) / EstimationSteps;
    const Execution polling = execution.part(done, done);
    const Values image = -this->multigrid_.residual(none, direction, polling);
    const double curvature = direction.dot(image) / product;
    residual -= image / curvature;
    error = this->multigrid_.apply(residual, polling);
    const double ratio = residual.dot(error) / std::exchange(product, residual.dot(error));
    direction = error + ratio * direction;
    diagonal[step] = curvature + carried;
    beside[step] = std::sqrt(ratio) * curvature;
    carried = ratio * curvature;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigenvalues;
  eigenvalues.computeFromTridiagonal(
    diagonal.head(step), beside.head(step - 1), Eigen::EigenvaluesOnly);
  return std::min(MostLeast, Margin * eigenvalues.eigenvalues()[0]);
}

Values AcceleratedMultigrid::apply(const Values& right, const Execution& execution) const
{
  if (this->order_.empty())
  {
    return this->applyInOrder(right, execution);
  }
  Values result(right.size());
  result(this->order_) = this->applyInOrder(right(this->order_), execution);
  return result;
}

Values AcceleratedMultigrid::applyInOrder(const Values& right, const Execution& execution) const
{
  const double center = 0.5 * (1.0 + this->least_);
  const double radius = 0.5 * (1.0 - this->least_);
  Values move = this->multigrid_.apply(right, execution) / center;
  Values result = move;
  double ratio = radius / center; // of the polynomials of two degrees
  for (int cycle = 1; cycle < this->cycleCount_; ++cycle)
  {
    const Values left = this->multigrid_.residual(right, result, execution);
    const double next = 1.0 / (2.0 * center / radius - ratio);
    move = next * ratio * move + 2.0 * next / radius * this->multigrid_.apply(left, execution);
    result += move;
    ratio = next;
  }
  return result;
}

} // namespace SurfaceScalars
