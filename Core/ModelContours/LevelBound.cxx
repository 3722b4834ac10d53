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

/// The radius of balls in which a term is as smooth as its Hessian says. With those of compact
/// support, a ball of this radius at the end is where their slope is monotone.
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
    case KernelType::Wendland:
    case KernelType::Wu:
      return parameters.kernelWidth / 3.0;
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

LevelBound::LevelBound(const LevelFunction& function)
  : field_(function.field())
  , plateau_(function.plateau())
  , kernel_(field_.model().parameters.kernel,
      field_.model().parameters.kernelWidth > 0.0 ? field_.model().parameters.kernelWidth : 1.0)
  , isJumping_(field_.model().parameters.scheme != Scheme::GlobalRBF)
  , support_(this->isJumping_ ? std::numeric_limits<double>::infinity() : this->kernel_.support())
  , smoothRadius_(smoothRadiusOf(field_.model().parameters))
{
  const FieldModel& model = this->field_.model();
  this->margin_ = CriticalFraction * (model.highest - model.lowest);
  this->rounding_ = roundingOf(this->field_, this->kernel_);
}

bool LevelBound::isSmall(const Ball& ball) const
{
  std::vector<Index> found;
  return this->field_.cloud().tree().gather(ball.center, ball.radius, MostCenters, found) &&
    (!this->plateau_ || this->plateau_->isSum(ball) || this->plateau_->isRim(ball));
}

bool LevelBound::isClear(const Ball& ball) const
{
  return this->plateau_ && this->plateau_->isClear(ball);
}

UnseenTerms LevelBound::unseen(const Ball& ball) const
{
  const bool isRough = ball.radius > this->smoothRadius_;
  const bool isCompact = std::isfinite(this->support_);
  UnseenTerms result;
  if ((!isRough && !isCompact) || (this->plateau_ && !this->plateau_->isSum(ball)))
  {
    return result;
  }
  Neighborhood near;
  this->field_.cloud().within(
    ball.center, ball.radius + (isCompact ? this->support_ : ball.radius), near);
  for (std::size_t i = 0; i < near.indices.size(); ++i)
  {
    const double distance = std::sqrt(near.squaredDistances[i]);
    if (!isRough && distance + ball.radius <= this->support_)
    {
      continue;
    }
    const double least = std::max(0.0, distance - ball.radius);
    const double size = std::abs(this->field_.model().coefficients[near.indices[i]]);
    result.value +=
      size * std::abs(this->kernel_.value(distance + ball.radius) - this->kernel_.value(least));
    result.slope += isRough ? std::numeric_limits<double>::infinity()
                            : size * std::abs(this->kernel_.jet(least).slopeOverRadius * least);
  }
  return result;
}

BallVerdict LevelBound::judge(const Ball& ball, double value, double slope, double curvature) const
{
  BallVerdict verdict;
  verdict.isClear = this->isClear(ball);
  if (verdict.isClear || !this->isSmall(ball))
  {
    return verdict;
  }
  const double turn = Safety * curvature * ball.radius;
  const UnseenTerms unseen = this->unseen(ball);
  const double variation = (slope + 0.5 * turn) * ball.radius + unseen.value;
  verdict.isSteep = slope > turn + unseen.slope;
  verdict.isClear = std::abs(value) > variation;
  verdict.isFlat = variation <= this->rounding_;
  verdict.mayBeCritical =
    !verdict.isSteep && !verdict.isFlat && std::abs(value) <= variation + this->margin_;
  return verdict;
}

} // namespace SurfaceScalars
