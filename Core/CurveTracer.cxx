#include "CurveTracer.h"

#include "CurveJoining.h"
#include "Polyline.h"
#include "SeedCover.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// Step control. Lengths are in widened sampling steps.
constexpr double FirstStep = 0.5;
constexpr double LongestStep = 2.0;
constexpr double ShortestStep = 0.01;
constexpr double WantedTurn =
  0.15; // angle per step: a chord is then within step * turn / 8 of the curve
constexpr double LargestTurn = 0.7;
constexpr double LargestResidual = 0.2; // of a point that did not converge: noise moves the model
constexpr double LargestJump = 0.1;     // of the model from one place to the next
constexpr double ClosingDistance = 0.5;
constexpr double ShortestLoop = 4.0;
constexpr std::size_t WindingCheck =
  64; // stations between checks whether a curve runs along itself
constexpr double OnCurveDistance = 0.75;
constexpr double Overhang =
  0.5; // of a curve beyond the outermost samples, in sampling steps not widened
constexpr double OutlierFraction = 0.02;
constexpr double EndPrecision = 0.1;
constexpr double DoubledLength =
  1.5; // along another curve, closer than OnCurveDistance: it is that curve
constexpr double ShortestCurve = 1.0;
constexpr double SaddleDistance = 2.5; // more than a step: it must not be stepped over
constexpr double CriticalFraction =
  1e-6; // of f's range: a level this close to a saddle's value is critical

/// A point being traced: `direction` is the tangent turned the way the tracing goes.
struct Station
{
  LevelSetPoint point;
  Vector3d direction;
  double step;          ///< widened sampling step of the place
  double nearest = 0.0; ///< distance to the nearest sample
  bool isSaddle = false;
  bool supported = true; ///< samples around it: it lies on the sampled surface
};

class Tracer
{
public:
  Tracer(LevelSetModel& model, const SampledFunction& function, double level,
    const TracingLimits& limits, std::size_t seeds, SeedCover& cover, const Poll& poll)
    : model_(model)
    , function_(function)
    , level_(level)
    , limits_(limits)
    , mostStations_(200 + 20 * seeds)
    , cover_(cover)
    , poll_(poll)
  {
  }

  std::optional<Station> start(const LevelSetPoint& seed);
  /// The curve through a start that the model is centred at.
  TracedCurve trace(const Station& start);

private:
  enum class End
  {
    Open,
    Closed
  };

  /// Widened sampling step where the model is.
  double stepAround() const;
  double samplingStep(const Station& station) const
  {
    return station.step / this->limits_.widening;
  }
  End extend(std::vector<Station>& path, bool mayClose);
  std::optional<Station> advance(const Station& from, double& step);
  std::optional<Station> tryStep(const Station& from, double step);
  void measureSupport(Station& station);
  bool closes(const std::vector<Station>& path, const Station& next, double length) const;
  std::optional<Station> saddleAhead(const Station& station);
  std::optional<std::size_t> woundOnto(const std::vector<Station>& path, std::size_t station) const;
  bool closeWinding(std::vector<Station>& path) const;
  TracedCurve loop(const std::vector<Station>& path) const;
  TracedCurve join(const std::vector<Station>& forward, const std::vector<Station>& backward) const;

  LevelSetModel& model_;
  const SampledFunction& function_;
  double level_;
  TracingLimits limits_;
  std::size_t mostStations_;
  SeedCover& cover_; ///< the curves that are there already
  const Poll& poll_;
  std::vector<double> across_; // scratch
};

double Tracer::stepAround() const
{
  const Neighborhood& around = this->model_.neighborhood();
  double sum = 0.0;
  for (const Index i : around.indices)
  {
    sum += this->function_.graph.samplingStep(i);
  }
  return sum / static_cast<double>(around.indices.size()) * this->limits_.widening;
}

/// Whether a station is among samples: not deep in a void and not beyond the last samples of the
/// surface.
void Tracer::measureSupport(Station& station)
{
  const Neighborhood& around = this->model_.neighborhood();
  const auto offsetOf = [&](Index i) -> Vector3d
  { return this->function_.graph.points().col(i) - station.point.position; };
  Vector3d mean = Vector3d::Zero();
  double nearest = INFINITY;
  for (const Index i : around.indices)
  {
    const Vector3d offset = offsetOf(i);
    mean += offset;
    nearest = std::min(nearest, offset.squaredNorm());
  }
  station.nearest = std::sqrt(nearest);
  // How far all samples, but for outliers, lie to the one side: the distance across to the edge of
  // the surface.
  const Vector3d& normal = station.point.normal;
  const Vector3d inwards = (mean - normal * normal.dot(mean)).normalized();
  this->across_.clear();
  for (const Index i : around.indices)
  {
    this->across_.push_back(inwards.dot(offsetOf(i)));
  }
  const auto edge = this->across_.begin() +
    static_cast<std::ptrdiff_t>(OutlierFraction * static_cast<double>(this->across_.size()));
  std::nth_element(this->across_.begin(), edge, this->across_.end());
  const double step = this->samplingStep(station);
  station.supported =
    station.nearest <= this->limits_.voidRadius * step && *edge <= Overhang * step;
}

std::optional<Station> Tracer::tryStep(const Station& from, double step)
{
  const Vector3d guess = from.point.position + step * from.direction;
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
  if (next.direction.dot(from.direction) < 0.0)
  {
    next.direction = -next.direction;
    next.point.normal = -next.point.normal;
  }
  const Vector3d chord = next.point.position - from.point.position;
  const double along = chord.dot(from.direction);
  const double across = (chord - along * from.direction).norm();
  const bool good = next.point.residual <= LargestResidual * next.step &&
    next.direction.dot(from.direction) > std::cos(LargestTurn) && along > 0.4 * step &&
    along < 1.6 * step && across < std::max(along, LargestJump * from.step);
  return good ? std::optional<Station>(next) : std::nullopt;
}

/// One step, shortened until it is good; the model must be centred at `from`. Sets the length to
/// try next.
std::optional<Station> Tracer::advance(const Station& from, double& step)
{
  step = std::min(step, LongestStep * from.step);
  for (; step >= ShortestStep * from.step; step *= 0.5)
  {
    if (std::optional<Station> next = this->tryStep(from, step))
    {
      const double turn = std::acos(std::clamp(next->direction.dot(from.direction), -1.0, 1.0));
      step *= std::clamp(WantedTurn / std::max(turn, 1e-6), 0.5, 1.5);
      this->measureSupport(*next);
      return next;
    }
    if (!this->model_.centre(from.point.position))
    {
      return {};
    }
  }
  return {};
}

bool Tracer::closes(const std::vector<Station>& path, const Station& next, double length) const
{
  const Station& start = path.front();
  return length > 2.5 * next.step && next.direction.dot(start.direction) > 0.5 &&
    distanceToSegment(start.point.position, path.back().point.position, next.point.position) <
    ClosingDistance * next.step;
}

/// A saddle of this level's value within reach in front of a station: the end of the curve.
std::optional<Station> Tracer::saddleAhead(const Station& station)
{
  const auto within = [&](const Saddle& saddle, double reach)
  { return (saddle.position - station.point.position).norm() <= reach * station.step; };

  std::optional<Saddle> saddle = this->model_.nearbySaddle();
  if (!saddle || !within(*saddle, SaddleDistance) ||
    std::abs(saddle->value - this->level_) > 1e3 * CriticalFraction)
  {
    return {};
  }
  // The model's saddle moves as the model is centred at it.
  for (int i = 0; i < this->limits_.maximumIterations; ++i)
  {
    const Vector3d last = saddle->position;
    if (!this->model_.centre(last) || !(saddle = this->model_.nearbySaddle()) ||
      !within(*saddle, SaddleDistance))
    {
      return {};
    }
    if ((saddle->position - last).norm() <= this->limits_.tolerance)
    {
      break;
    }
  }
  const Vector3d way = saddle->position - station.point.position;
  if (std::abs(saddle->value - this->level_) > CriticalFraction ||
    way.dot(station.direction) < 0.5 * way.norm())
  {
    return {};
  }
  Station end = station;
  end.point.position = saddle->position;
  end.point.residual =
    std::abs(this->model_.distance); // F is critical: only g has a first-order distance
  end.point.converged = true;
  end.isSaddle = true;
  const Vector3d normal = this->model_.normal();
  end.point.normal = normal.dot(station.point.normal) < 0.0 ? Vector3d(-normal) : normal;
  return end;
}

/// Follows the direction of the last station. @returns whether the curve came back to the first
Tracer::End Tracer::extend(std::vector<Station>& path, bool mayClose)
{
  double step = FirstStep * path.back().step;
  double length = 0.0;
  double gap = 0.0;     // from the last sample passed
  double doubled = 0.0; // length along another curve
  std::size_t lastSupported = path.size();
  std::size_t lastAlone = path.size();
  for (std::size_t i = 0; i < this->mostStations_; ++i)
  {
    this->poll_();
    if (const std::optional<Station> saddle = this->saddleAhead(path.back()))
    {
      path.push_back(*saddle);
      return End::Open;
    }
    // The search for saddles moves the model.
    const std::optional<Station> next = this->model_.centre(path.back().point.position)
      ? this->advance(path.back(), step)
      : std::nullopt;
    if (!next)
    {
      break;
    }
    const double chord = (next->point.position - path.back().point.position).norm();
    if (!next->supported && path.back().supported && chord > EndPrecision * next->step)
    {
      step = 0.5 * chord; // find the place where the surface ends
      continue;
    }
    gap = (path.back().supported ? path.back().nearest : gap) + chord;
    if ((!next->supported || !path.back().supported) &&
      gap + next->nearest > this->limits_.linkDistance * this->samplingStep(*next))
    {
      break;
    }
    length += chord;
    if (mayClose && this->closes(path, *next, length))
    {
      return End::Closed;
    }
    path.push_back(*next);
    if (path.size() % WindingCheck == 0 && this->closeWinding(path))
    {
      return End::Closed;
    }
    lastSupported = next->supported ? path.size() : lastSupported;
    const bool onCurve =
      this->cover_.isOnCurve(next->point.position, OnCurveDistance * next->step, next->direction);
    doubled = onCurve && lastAlone + 1 < path.size() ? doubled + chord : 0.0;
    lastAlone = onCurve ? lastAlone : path.size();
    if (doubled > DoubledLength * next->step)
    {
      lastSupported = std::min(lastSupported, lastAlone);
      break;
    }
  }
  path.resize(lastSupported, path.front());
  return End::Open;
}

/// Index of the first segment that a station runs along the same way, among those that end a while
/// before it; or none.
std::optional<std::size_t> Tracer::woundOnto(
  const std::vector<Station>& path, std::size_t station) const
{
  const Station& here = path[station];
  double length = 0.0;
  std::size_t last = station;
  for (; last > 0 && length < ShortestLoop * here.step; --last)
  {
    length += (path[last].point.position - path[last - 1].point.position).norm();
  }
  for (std::size_t i = 0; i < last; ++i)
  {
    if (here.direction.dot(path[i].direction) > 0.8 &&
      distanceToSegment(here.point.position, path[i].point.position, path[i + 1].point.position) <
        ClosingDistance * here.step)
    {
      return i + 1;
    }
  }
  return {};
}

/// A trace that noise led past its start runs round and round: if it does, keeps one round.
bool Tracer::closeWinding(std::vector<Station>& path) const
{
  if (!this->woundOnto(path, path.size() - 1))
  {
    return false;
  }
  std::size_t end = path.size() - 1;
  std::optional<std::size_t> begin = this->woundOnto(path, end);
  // Back to where the second round began.
  while (end > 0)
  {
    const std::optional<std::size_t> before = this->woundOnto(path, end - 1);
    if (!before)
    {
      break;
    }
    begin = before;
    --end;
  }
  path.assign(path.begin() + static_cast<std::ptrdiff_t>(*begin),
    path.begin() + static_cast<std::ptrdiff_t>(end));
  return path.size() >= 3;
}

TracedCurve Tracer::join(
  const std::vector<Station>& forward, const std::vector<Station>& backward) const
{
  TracedCurve curve;
  curve.startsAtSaddle = backward.back().isSaddle;
  curve.endsAtSaddle = forward.back().isSaddle;
  for (auto station = backward.rbegin(); station + 1 < backward.rend(); ++station)
  {
    curve.points.push_back(station->point);
    curve.points.back().normal =
      -station->point.normal; // it was kept on the other side of the direction
    curve.tangents.push_back(-station->direction);
    curve.steps.push_back(station->step);
  }
  for (const Station& station : forward)
  {
    curve.points.push_back(station.point);
    curve.tangents.push_back(station.direction);
    curve.steps.push_back(station.step);
  }
  return curve;
}

/// Puts a seed on the level set; none if that fails or leads off the samples.
std::optional<Station> Tracer::start(const LevelSetPoint& seed)
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
  this->measureSupport(station);
  return station.supported ? std::optional<Station>(station) : std::nullopt;
}

TracedCurve Tracer::loop(const std::vector<Station>& path) const
{
  TracedCurve curve = this->join(path, { path.front() });
  curve.startsAtSaddle = curve.endsAtSaddle = false;
  curve.closed = true;
  return curve;
}

TracedCurve Tracer::trace(const Station& start)
{
  std::vector<Station> forward{ start };
  if (this->extend(forward, true) == End::Closed)
  {
    return this->loop(forward);
  }
  if (!this->model_.centre(start.point.position))
  {
    return {};
  }
  std::vector<Station> backward{ start };
  backward.front().direction = -start.direction;
  if (this->extend(backward, false) == End::Closed)
  {
    return this->loop(backward);
  }
  TracedCurve curve = this->join(forward, backward);
  // Both ends at one saddle: a loop through it.
  curve.closed = curve.points.size() > 3 &&
    (curve.points.front().position - curve.points.back().position).norm() <=
      10.0 * this->limits_.tolerance;
  if (curve.closed)
  {
    curve.points.pop_back();
    curve.tangents.pop_back();
    curve.steps.pop_back();
  }
  return curve;
}

} // namespace

std::vector<TracedCurve> traceCurves(LevelSetModel& model, const SampledFunction& function,
  double level, const std::vector<LevelSetPoint>& seeds, const TracingLimits& limits,
  const Poll& poll)
{
  std::vector<TracedCurve> curves;
  SeedCover cover(seeds);
  Tracer tracer(model, function, level, limits, seeds.size(), cover, poll);
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    poll();
    if (cover.isPassed(i))
    {
      continue;
    }
    const std::optional<Station> start = tracer.start(seeds[i]);
    if (!start ||
      cover.isOnCurve(start->point.position, OnCurveDistance * start->step, Vector3d::Zero()))
    {
      continue; // a seed that fails is not tried again
    }
    TracedCurve curve = tracer.trace(*start);
    if (curve.points.size() >= (curve.closed ? 3 : 2) &&
      polylineLength(curve.points, curve.closed) >= ShortestCurve * start->step)
    {
      cover.pass(curve);
      curves.push_back(std::move(curve));
    }
  }
  return joinEnds(std::move(curves));
}

} // namespace SurfaceScalars
