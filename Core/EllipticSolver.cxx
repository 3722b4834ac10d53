#include "EllipticSolver.h"

#include "Error.h"
#include "NumberText.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

// Of the estimated error, relative to the solution:
constexpr double Goal = 1e-11;
constexpr double SmallError = 1e-9; // not worth to begin anew
constexpr double LargestError = 1e-6;

constexpr int MostSteps = 1000; // 30 are usual, slivers of triangles take hundreds
constexpr int MostStarts = 3;

double largest(const Values& values)
{
  return values.lpNorm<Eigen::Infinity>();
}

} // namespace

/// One solution in the making.
class EllipticSolver::Iteration
{
public:
  Iteration(const Multigrid& preconditioner, const Values& right, const Execution& execution)
    : preconditioner_(preconditioner)
    , right_(right)
    , execution_(execution)
    , solution_(Values::Zero(right.size()))
  {
    this->beginAnew();
  }

  const Values& solution() const { return this->solution_; }
  double error() const { return largest(this->error_); } ///< of the solution, estimated
  bool isSolved(double tolerance) const
  {
    return this->error() <= tolerance * largest(this->solution_);
  }

  void beginAnew(); ///< Without the rounding errors of the residual.
  void conjugateGradients();
  void biconjugateGradients();

private:
  Execution polling() const { return this->execution_.part(this->done_, this->done_); }
  Values image(const Values& vector) const
  {
    return multiply(this->preconditioner_.matrix(), vector, this->polling());
  }
  void estimateError();

  const Multigrid& preconditioner_;
  const Values& right_;
  const Execution& execution_;
  Values solution_;
  Values residual_;
  Values error_;
  double firstError_ = 0.0;
  double done_ = 0.0;
};

void EllipticSolver::Iteration::beginAnew()
{
  this->residual_ = this->right_ - this->image(this->solution_);
  this->estimateError();
}

void EllipticSolver::Iteration::estimateError()
{
  this->error_ = this->preconditioner_.apply(this->residual_, this->polling());
  this->firstError_ = std::max(this->firstError_, this->error());
  const double reduction = std::log(this->firstError_ / this->error()) / std::log(1.0 / Goal);
  this->done_ = std::max(this->done_, std::min(1.0, reduction)); // of two, not NaN, the first
  this->execution_.report(this->done_);
}

void EllipticSolver::Iteration::conjugateGradients()
{
  Values direction = this->error_;
  double product = this->residual_.dot(this->error_);
  for (int step = 0; step < MostSteps && !this->isSolved(Goal); ++step)
  {
    const Values image = this->image(direction);
    const double length = product / direction.dot(image);
    this->solution_ += length * direction;
    this->residual_ -= length * image;
    this->estimateError();
    const double before = std::exchange(product, this->residual_.dot(this->error_));
    direction = this->error_ + product / before * direction;
  }
}

void EllipticSolver::Iteration::biconjugateGradients()
{
  const Values shadow = this->residual_;
  Values direction = this->residual_;
  double product = shadow.dot(this->residual_);
  for (int step = 0; step < MostSteps && !this->isSolved(Goal); ++step)
  {
    const Values move = this->preconditioner_.apply(direction, this->polling());
    const Values image = this->image(move);
    const double length = product / shadow.dot(image);
    this->solution_ += length * move;
    this->residual_ -= length * image;
    this->estimateError();
    const Values errorImage = this->image(this->error_);
    const double damping = errorImage.dot(this->residual_) / errorImage.squaredNorm();
    if (!(std::abs(damping) > 0.0))
    {
      return; // nothing is left, or nothing can be done
    }
    this->solution_ += damping * this->error_;
    this->residual_ -= damping * errorImage;
    const double before = std::exchange(product, shadow.dot(this->residual_));
    direction =
      this->residual_ + product / before * length / damping * (direction - damping * image);
  }
}

EllipticSolver::EllipticSolver(RowMatrix&& matrix, bool isSymmetric, const Execution& execution)
  : preconditioner_(std::move(matrix), isSymmetric, execution)
  , isSymmetric_(isSymmetric)
{
}

Values EllipticSolver::solve(const ValuesRef& right, const Execution& execution) const
{
  const Values copy = right;
  Iteration iteration(this->preconditioner_, copy, execution);
  for (int start = 0; start < MostStarts && !iteration.isSolved(SmallError); ++start)
  {
    if (this->isSymmetric_)
    {
      iteration.conjugateGradients();
    }
    else
    {
      iteration.biconjugateGradients();
    }
    iteration.beginAnew();
  }
  if (!iteration.isSolved(LargestError) || !iteration.solution().allFinite())
  {
    throw Error("a linear system of " + std::to_string(right.size()) +
      " equations was not solved: the error is still about " + textOf(iteration.error()) +
      " where the largest value is " + textOf(largest(iteration.solution())) + ".");
  }
  execution.report(1.0);
  return iteration.solution();
}

} // namespace SurfaceScalars
