#include "TrustRegion.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr double GoodPrediction = 0.25; // errors of the gradient, in its predicted change
constexpr double BadPrediction = 0.75;
constexpr double SmallestTrust = 1e-10; // in longest steps: rounding

/// -sign_i g_i / (|l_i| + mu) in the axes of the Hessian.
Vector2d shiftedStep(const Vector2d& gradient, const Vector2d& sizes, double shift)
{
  return -gradient.cwiseQuotient((sizes.array() + shift).matrix());
}

/// The step within a trust region, in the axes of the Hessian.
Vector2d stepWithin(const Vector2d& gradient, const Vector2d& sizes, double trust)
{
  const double scale = gradient.norm() / trust; // as a shift, short enough
  Vector2d step = shiftedStep(gradient, sizes, 0.0);
  if (step.allFinite() && step.norm() <= trust)
  {
    return step;
  }
  double low = 0.0;
  double high = scale;
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (low + high);
    (shiftedStep(gradient, sizes, middle).norm() <= trust ? high : low) = middle;
  }
  return shiftedStep(gradient, sizes, high);
}

/// The direction of the gradient to follow, up or down, along the axes of eigenvalues that ascend.
Vector2d signsFor(CriticalType type, const Vector2d& eigenvalues)
{
  switch (type)
  {
    case CriticalType::Minimum:
      return { 1.0, 1.0 };
    case CriticalType::Maximum:
      return { -1.0, -1.0 };
    case CriticalType::Saddle:
      return { -1.0, 1.0 };
    default:
      return { eigenvalues[0] < 0.0 ? -1.0 : 1.0, eigenvalues[1] < 0.0 ? -1.0 : 1.0 };
  }
}

} // namespace

bool TrustRegion::step(PlanarPoint& point, double longest, const PlanarFunction& evaluate)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(point.g.hessian);
  const Vector2d followed = axes.eigenvectors().transpose() * point.g.gradient;
  const Vector2d gradient = followed.cwiseProduct(signsFor(this->type_, axes.eigenvalues()));
  const Vector2d sizes = axes.eigenvalues().cwiseAbs();
  this->length_ = std::min(this->length_, longest);
  while (this->length_ > SmallestTrust * longest)
  {
    const Vector2d step = axes.eigenvectors() * stepWithin(gradient, sizes, this->length_);
    PlanarPoint next;
    if (evaluate(point.st + step, next) && this->isBetter(point, next, step))
    {
      point = next;
      return true;
    }
    this->length_ = 0.25 * step.norm();
  }
  return false;
}

bool TrustRegion::isBetter(
  const PlanarPoint& before, const PlanarPoint& after, const Vector2d& step)
{
  const Vector2d predicted = before.g.hessian * step;
  const double error = (after.g.gradient - before.g.gradient - predicted).norm() / predicted.norm();
  if (error <= GoodPrediction && step.norm() > 0.5 * this->length_)
  {
    this->length_ *= 2.0;
  }
  const bool isCloser = after.residual < before.residual;
  return this->type_ == CriticalType::Uncertain ? isCloser : isCloser || error <= BadPrediction;
}

} // namespace SurfaceScalars
