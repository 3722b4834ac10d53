#pragma once

#include "CurveTracer.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// A point being traced: `direction` is the tangent turned the way the tracing goes.
struct Station
{
  LevelSetPoint point;
  Vector3d direction;
  double step = 0.0;     ///< widened sampling step of the place
  double nearest = 0.0;  ///< distance to the nearest sample
  bool supported = true; ///< samples around it: it lies on the sampled surface
};

/// Of f's range: an iso-value closer to a saddle's value is critical.
constexpr double CriticalFraction = 1e-6;

/// Walks along a level set: from a seed onto it, from station to station, into a saddle.
class LevelSetWalker
{
public:
  LevelSetWalker(LevelSetModel& model, const SampledFunction& function, double level,
    const TracingLimits& limits);

  /// Puts a seed on the level set; none if that fails or leads off the samples.
  std::optional<Station> start(const LevelSetPoint& seed);

  /// The next station about `step` (a length) onwards, less where the curve turns. Sets the length
  /// to try next.
  std::optional<Station> advance(const Station& from, double& step);

  /// The end of a curve that leaves the samples at a station: the surface goes on a little beyond
  /// its last samples.
  std::optional<Station> extension(const Station& end);

  /// A saddle of the model close to a station, its value near the level's. The model is left
  /// centered there, or next to it where Newton's method does not converge: the saddle is then
  /// degenerate.
  std::optional<Saddle> saddleNear(const Station& station);

  /// The end at a saddle of a curve that comes from a station.
  Station endAt(const Vector3d& saddle, const Station& station);

  /// The sampling step of a place, not widened.
  double samplingStep(const Station& station) const
  {
    return station.step / this->limits_.widening;
  }

private:
  double stepAround();
  std::optional<Station> tryStep(const Station& from, double step, double angle = 0.0);
  void judgeSupport(Station& station);

  LevelSetModel& model_;
  const SampledFunction& function_;
  double level_;
  TracingLimits limits_;
  std::vector<double> scratch_;
};

} // namespace SurfaceScalars
