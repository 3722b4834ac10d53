#include "LevelSetWalker.h"

#include "Quantile.h"
#include "SampleSupport.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// Lengths are in widened sampling steps.
constexpr double LongestStep = 2.0;
constexpr double ShortestStep = 0.01;
constexpr double WantedTurn =
  0.15; // angle per step: a chord is within step * turn / 8 of the curve
constexpr double LargestTurn = 0.7;
constexpr double LargestResidual = 0.2; // of a point that did not converge: noise moves the model
constexpr double LargestJump = 0.1;     // of the model from one place to the next
constexpr double EdgeStep = 0.05;       // steps that may cross an edge of a given function
constexpr double Overhang = 0.3;        // beyond the outermost samples, in steps not widened
constexpr double Extension = 0.8;   // from there to the end: the surface goes on about half a step
constexpr double CarefulStep = 0.5; // where samples are far: a hole must not be stepped over
constexpr double QuantileToMean = 1.08; // of the steps of random samples with 16 neighbors
constexpr double SaddleDistance = 2.5;  // more than a step: it must not be stepped over
constexpr double NearlyCriticalFraction =
  1e-3; // of f's range, between a level and a saddle's value

} // namespace

LevelSetWalker::LevelSetWalker(
  LevelSetModel& model, const SampledFunction& function, double level, const TracingLimits& limits)
  : model_(model)
  , function_(function)
  , level_(level)
  , limits_(limits)
{
}

/// Widened sampling step where the model is: a low quantile, because at the edge of a surface
/// samples have fewer neighbors, and seem farther apart, than they are.
double LevelSetWalker::stepAround()
{
  this->scratch_.clear();
  for (const Index i : this->model_.samples())
  {
    this->scratch_.push_back(this->function_.graph.samplingStep(i));
  }
  return QuantileToMean * quantile(this->scratch_, 0.25) * this->limits_.widening;
}

/// Whether a station is among samples: not deep in a void and not beyond the last samples of the
/// surface.
void LevelSetWalker::judgeSupport(Station& station)
{
  const SampleSupport support = measureSupport(this->function_.graph.points(),
    this->model_.samples(), station.point.position, station.point.normal);
  station.nearest = support.nearest;
  const double step = this->samplingStep(station);
  station.supported =
    station.nearest <= this->limits_.voidRadius * step && support.beyond <= Overhang * step;
}

std::optional<Station> LevelSetWalker::tryStep(const Station& from, double step, double angle)
{
  const Vector3d aside = from.point.normal.cross(from.direction);
  const Vector3d heading = std::cos(angle) * from.direction + std::sin(angle) * aside;
  const Vector3d guess = from.point.position + step * heading;
  const std::optional<Vector3d> predicted = this->model_.solve(this->level_, guess);
  const ProjectionLimits limits{ this->limits_.tolerance,
    std::max(0.5 * step, LargestJump * from.step), this->limits_.maximumIterations };
  const std::optional<LevelSetPoint> point =
    project(this->model_, this->level_, predicted.value_or(guess), limits);
  if (!point)
  {
    return {};
  }
  Station next{ *point, this->model_.tangent(), this->stepAround() };
  // A given function may have edges, at which its curves turn as much as they like, but not the
  // surface.
  const bool isGiven = static_cast<bool>(this->function_.volumeFunction);
  const bool isReversed = isGiven ? next.point.normal.dot(from.point.normal) < 0.0
                                  : next.direction.dot(from.direction) < 0.0;
  if (isReversed)
  {
    next.direction = -next.direction;
    next.point.normal = -next.point.normal;
  }
  const Vector3d chord = next.point.position - from.point.position;
  const double turn = std::acos(std::clamp(next.direction.dot(from.direction), -1.0, 1.0));
  const bool isExact = next.point.residual <= LargestResidual * next.step;
  if (isGiven && step <= EdgeStep * from.step)
  {
    // From the corner itself the way lies along the new direction; over the corner it is between
    // the two. Never back.
    const double onwards = angle != 0.0 ? 0.5 : -0.7;
    const bool good = isExact && chord.norm() > 0.2 * step &&
      chord.norm() < LargestJump * from.step &&
      chord.dot(next.direction) > onwards * chord.norm() &&
      chord.dot(from.direction) > -0.95 * chord.norm();
    return good ? std::optional<Station>(next) : std::nullopt;
  }
  const double along = chord.dot(from.direction);
  const double across = (chord - along * from.direction).norm();
  const bool good = isExact && turn < LargestTurn && along > 0.4 * step && along < 1.6 * step &&
    across < std::max(along, LargestJump * from.step);
  return good ? std::optional<Station>(next) : std::nullopt;
}

std::optional<Station> LevelSetWalker::advance(const Station& from, double& step)
{
  const auto arrive = [&](Station next)
  {
    const double turn = std::acos(std::clamp(next.direction.dot(from.direction), -1.0, 1.0));
    step *= std::clamp(WantedTurn / std::max(turn, 1e-6), 0.5, 1.5);
    this->judgeSupport(next);
    return next;
  };
  const bool careful = from.nearest > 0.5 * this->limits_.voidRadius * this->samplingStep(from);
  step = std::min(step, (careful ? CarefulStep : LongestStep) * from.step);
  // Shortened until it is good; each failure has moved the model.
  for (; step >= ShortestStep * from.step && this->model_.center(from.point.position); step *= 0.5)
  {
    if (const std::optional<Station> next = this->tryStep(from, step))
    {
      return arrive(*next);
    }
  }
  if (this->function_.volumeFunction)
  {
    // At the corner of a given function itself: look round it.
    step = EdgeStep * from.step;
    for (const double angle : { 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.6, -1.6, 2.0, -2.0, 2.4, -2.4 })
    {
      const std::optional<Station> next =
        this->model_.center(from.point.position) ? this->tryStep(from, step, angle) : std::nullopt;
      if (next)
      {
        return arrive(*next);
      }
    }
  }
  return {};
}

std::optional<Saddle> LevelSetWalker::saddleNear(const Station& station)
{
  const auto isNear = [&](const std::optional<Saddle>& saddle)
  {
    return saddle &&
      (saddle->position - station.point.position).norm() <= SaddleDistance * station.step &&
      std::abs(saddle->value - this->level_) <= NearlyCriticalFraction;
  };
  std::optional<Saddle> saddle = this->model_.nearbySaddle();
  if (!isNear(saddle))
  {
    return {};
  }
  // The model's saddle moves as the model is centered at it.
  for (int i = 0; i < this->limits_.maximumIterations; ++i)
  {
    if (!this->model_.center(saddle->position))
    {
      return {};
    }
    const std::optional<Saddle> next = this->model_.nearbySaddle();
    if (!isNear(next))
    {
      break;
    }
    const double moved = (next->position - saddle->position).norm();
    saddle = next;
    if (moved <= this->limits_.tolerance)
    {
      break;
    }
  }
  return saddle;
}

Station LevelSetWalker::endAt(const Vector3d& saddle, const Station& station)
{
  Station end = station;
  end.point.position = saddle;
  if (!this->model_.center(saddle))
  {
    return end;
  }
  end.point.residual =
    std::abs(this->model_.distance); // F is critical: only g has a first-order distance
  end.point.converged = true;
  const Vector3d normal = this->model_.normal();
  end.point.normal = normal.dot(station.point.normal) < 0.0 ? Vector3d(-normal) : normal;
  return end;
}

std::optional<Station> LevelSetWalker::start(const LevelSetPoint& seed)
{
  const ProjectionLimits limits{ this->limits_.tolerance, INFINITY,
    this->limits_.maximumIterations };
  const std::optional<LevelSetPoint> point =
    project(this->model_, this->level_, seed.position, limits);
  if (!point || this->model_.tangent().isZero())
  {
    return {};
  }
  Station station{ *point, this->model_.tangent(), this->stepAround() };
  this->judgeSupport(station);
  return station.supported ? std::optional<Station>(station) : std::nullopt;
}

std::optional<Station> LevelSetWalker::extension(const Station& end)
{
  std::optional<Station> last;
  if (this->model_.center(end.point.position))
  {
    last = this->tryStep(end, Extension * this->samplingStep(end));
  }
  return last;
}

} // namespace SurfaceScalars
