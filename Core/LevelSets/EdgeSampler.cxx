#include "EdgeSampler.h"

#include "SchemeModels.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double LargestCorrection = 0.25; // of a linear solution, in widened sampling steps

} // namespace

EdgeSampler::EdgeSampler(const SampledFunction& function, const FitSize& size,
  const ContourParameters& parameters, const TracingLimits& limits)
  : function_(function)
  , scheme_(parameters.scheme)
  , surface_(parameters.surface)
  , limits_(limits)
  , model_(makeModel(function, size, parameters))
{
}

/// F(q(t)) = level on the edge by Newton's method from the linear solution.
std::optional<Vector3d> EdgeSampler::solveAlongEdge(
  const Vector3d& from, const Vector3d& along, double parameter, double level)
{
  double t = parameter;
  for (int i = 0; i < this->limits_.maximumIterations && this->model_->center(from + t * along);
       ++i)
  {
    const double slope = this->model_->valueGradient.dot(along);
    const double next = std::clamp(t + (level - this->model_->value) / slope, 0.0, 1.0);
    const double moved = std::abs(next - t) * along.norm();
    if (!std::isfinite(moved))
    {
      return {};
    }
    t = next;
    if (moved <= this->limits_.tolerance)
    {
      return from + t * along;
    }
  }
  return {};
}

/// Along the normal onto g = 0.
std::optional<Vector3d> EdgeSampler::projectOnSurface(Vector3d place)
{
  for (int i = 0; i < this->limits_.maximumIterations && this->model_->center(place); ++i)
  {
    const Vector3d& gradient = this->model_->distanceGradient;
    const Vector3d step = -this->model_->distance / gradient.squaredNorm() * gradient;
    place += step;
    if (!(step.norm() <= this->model_->reach))
    {
      return {};
    }
    if (step.norm() <= this->limits_.tolerance)
    {
      return place;
    }
  }
  return {};
}

/// Where a projection begins: the linear solution, put right by the model of the last sample if
/// that is close.
Vector3d EdgeSampler::startOf(const Vector3d& linear, double level, double farthest) const
{
  if (!this->last_ || !((linear - *this->last_).norm() < this->model_->reach))
  {
    return linear;
  }
  const Vector3d better = this->model_->solve(level, linear).value_or(linear);
  // From another sheet of the surface it would be farther.
  return (better - linear).norm() < farthest ? better : linear;
}

std::optional<LevelSetPoint> EdgeSampler::sample(const EdgeCrossing& crossing, double level)
{
  const Vector3d from = this->function_.graph.points().col(crossing.from);
  const Vector3d along = this->function_.graph.points().col(crossing.to) - from;
  const Vector3d linear = from + crossing.parameter * along;

  std::optional<Vector3d> place;
  if (this->surface_ == SurfaceModel::Unprojected)
  {
    place = this->scheme_ == Scheme::Linear
      ? linear
      : this->solveAlongEdge(from, along, crossing.parameter, level);
  }
  else if (this->scheme_ == Scheme::Linear)
  {
    place = this->projectOnSurface(linear);
  }
  else
  {
    const double step = this->function_.graph.samplingStep(crossing.from) * this->limits_.widening;
    std::optional<LevelSetPoint> point =
      project(*this->model_, level, this->startOf(linear, level, LargestCorrection * step),
        { this->limits_.tolerance, 3.0 * step, this->limits_.maximumIterations });
    this->last_.reset();
    if (point)
    {
      this->last_ = point->position;
      return point;
    }
  }

  LevelSetPoint point;
  point.position = place.value_or(linear);
  point.converged = place.has_value();
  if (!this->model_->center(point.position))
  {
    return {};
  }
  point.residual = this->model_->firstOrderStep(level).norm();
  point.normal = this->model_->normal();
  return std::isfinite(point.residual) ? std::optional<LevelSetPoint>(point) : std::nullopt;
}

} // namespace SurfaceScalars
