#include "KrylovSolver.h"

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

constexpr double LargestError = 1e-6; // estimated, relative to the solution
constexpr double SmallError = 100.0;  // in goals: not worth to begin anew

constexpr int MostSteps = 1000; // 30 are usual, slivers of triangles take hundreds
constexpr int MostStarts = 3;

double largest(const Values& values)
{
  return values.lpNorm<Eigen::Infinity>();
}

/// One solution in the making.
class Iteration
{
public:
  Iteration(const PreconditionedSystem& system, const Values& right, double goal,
    const Execution& execution)
    : system_(system)
    , right_(right)
    , goal_(goal)
    , execution_(execution)
    , solution_(Values::Zero(right.size()))
  {
    this->beginAnew();
  }

  const Values& solution() const { return this->solution_; }
  double error() const { return largest(this->error_); } ///< of the solution, estimated
  bool isSolved(double tolerance, double least = 0.0) const
  {
    return this->error() <= tolerance * std::max(largest(this->solution_), least);
  }

  void beginAnew(); ///< Without the rounding errors of the residual.
  void conjugateGradients();
  void biconjugateGradients();

private:
  Execution polling() const { return this->execution_.part(this->done_, this->done_); }
  Values image(const Values& vector) const { return this->system_.matrix(vector, this->polling()); }
  Values preconditioned(const Values& vector) const
  {
    return this->system_.preconditioner(vector, this->polling());
  }
  void estimateError();

  const PreconditionedSystem& system_;
  const Values& right_;
  double goal_;
  const Execution& execution_;
  Values solution_;
  Values residual_;
  Values error_;
  double firstError_ = 0.0;
  double done_ = 0.0;
};

void Iteration::beginAnew()
{
  this->residual_ = this->right_ - this->image(this->solution_);
  this->estimateError();
}

void Iteration::estimateError()
{
  this->error_ = this->preconditioned(this->residual_);
  this->firstError_ = std::max(this->firstError_, this->error());
  const double reduction =
    std::log(this->firstError_ / this->error()) / std::log(1.0 / this->goal_);
  this->done_ = std::max(this->done_, std::min(1.0, reduction)); // of two, not NaN, the first
  this->execution_.report(this->done_);
}

void Iteration::conjugateGradients()
{
  Values direction = this->error_;
  double product = this->residual_.dot(this->error_);
  for (int step = 0; step < MostSteps && !this->isSolved(this->goal_); ++step)
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

void Iteration::biconjugateGradients()
{
  const Values shadow = this->residual_;
  Values direction = this->residual_;
  double product = shadow.dot(this->residual_);
  for (int step = 0; step < MostSteps && !this->isSolved(this->goal_); ++step)
  {
    const Values move = this->preconditioned(direction);
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

} // namespace

Values PreconditionedSystem::solve(
  const ValuesRef& right, double goal, const Execution& execution, double least) const
{
  const Values copy = right;
  Iteration iteration(*this, copy, goal, execution);
  const double smallError = SmallError * goal;
  for (int start = 0; start < MostStarts && !iteration.isSolved(smallError); ++start)
  {
    if (this->isSymmetric)
    {
      iteration.conjugateGradients();
    }
    else
    {
      iteration.biconjugateGradients();
    }
    iteration.beginAnew();
  }
  if (!iteration.isSolved(std::max(smallError, LargestError), least) ||
    !iteration.solution().allFinite())
  {
    throw Error("a linear system of " + std::to_string(right.size()) +
      " equations was not solved: the error is still about " + textOf(iteration.error()) +
      " where the largest value is " + textOf(largest(iteration.solution())) + ".");
  }
  execution.report(1.0);
  return iteration.solution();
}

} // namespace SurfaceScalars
