#include "LevelBound.h"

#include "LevelSetWalker.h"
#include "PointTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t MostCenters = 3;     // in a ball in which u is smooth
constexpr double RoundingFraction = 1e-13; // of the largest value
constexpr double TermRounding = 1e-15;     // of the sum of all terms' sizes

/// The radius of balls in which a term is as smooth as its Hessian says.
double smoothRadiusOf(const FieldParameters& parameters)
{
  const double always = std::numeric_limits<double>::infinity();
  if (parameters.scheme != Scheme::GlobalRBF)
  {
    return always;
  }
  switch (parameters.kernel)
  {
    case KernelType::Exponential:
    case KernelType::Linear:
    case KernelType::ThinPlate:
      return 0.0;
    default:
      return RadialKernel(parameters.kernel, 1.0).dependsOnWidth() ? 0.5 * parameters.kernelWidth
                                                                   : always;
  }
}

/// What the values of a sum of terms that cancel each other may be off by.
double roundingOf(const Field& field, const RadialKernel& kernel)
{
  const FieldModel& model = field.model();
  double rounding = RoundingFraction * std::max(std::abs(model.lowest), std::abs(model.highest));
  for (Index i = 0; model.parameters.scheme == Scheme::GlobalRBF && i < field.cloud().pointCount();
       ++i)
  {
    const double distance = field.cloud().points().col(i).norm();
    rounding += TermRounding * std::abs(model.coefficients[i] * kernel.value(distance));
  }
  return rounding;
}

} // namespace

LevelBound::LevelBound(const Field& field)
  : field_(field)
  , kernel_(field.model().parameters.kernel,
      field.model().parameters.kernelWidth > 0.0 ? field.model().parameters.kernelWidth : 1.0)
  , isJumping_(field.model().parameters.scheme != Scheme::GlobalRBF)
  , smoothRadius_(smoothRadiusOf(field.model().parameters))
{
  const FieldModel& model = field.model();
  this->margin_ = CriticalFraction * (model.highest - model.lowest);
  this->rounding_ = roundingOf(field, this->kernel_);
}

bool LevelBound::isSmall(const Ball& ball) const
{
  std::vector<Index> found;
  return this->field_.cloud().tree().gather(ball.center, ball.radius, MostCenters, found);
}

/// How much the terms of centers within twice the radius vary in the ball.
double LevelBound::variationNearby(const Ball& ball) const
{
  Neighborhood near;
  this->field_.cloud().within(ball.center, 2.0 * ball.radius, near);
  double sum = 0.0;
  for (std::size_t i = 0; i < near.indices.size(); ++i)
  {
    const double distance = std::sqrt(near.squaredDistances[i]);
    const double least = this->kernel_.value(std::max(0.0, distance - ball.radius));
    const double most = this->kernel_.value(distance + ball.radius);
    sum += std::abs(this->field_.model().coefficients[near.indices[i]] * (most - least));
  }
  return sum;
}

BallVerdict LevelBound::judge(const Ball& ball, double value, double slope, double curvature) const
{
  BallVerdict verdict;
  if (!this->isSmall(ball))
  {
    return verdict;
  }
  const double turn = Safety * curvature * ball.radius;
  double variation = (slope + 0.5 * turn) * ball.radius;
  verdict.isSteep = slope > turn;
  if (ball.radius > this->smoothRadius_)
  {
    const double nearby = this->variationNearby(ball);
    variation += nearby;
    verdict.isSteep = verdict.isSteep && nearby == 0.0;
  }
  verdict.isClear = std::abs(value) > variation;
  verdict.isFlat = variation <= this->rounding_;
  verdict.mayBeCritical =
    !verdict.isSteep && !verdict.isFlat && std::abs(value) <= variation + this->margin_;
  return verdict;
}

} // namespace SurfaceScalars
