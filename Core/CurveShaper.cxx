#include "CurveShaper.h"

#include "Polyline.h"
#include "Spline.h"

#include <cmath>
#include <numeric>

namespace SurfaceScalars
{
namespace
{

constexpr double KnotSpacing = 5.0; // of the fitted spline, in widened sampling steps

/// The polyline's arc length at each point, and once more at the end (which is the first point if
/// closed).
std::vector<double> arcLengths(const TracedCurve& curve)
{
  std::vector<double> lengths{ 0.0 };
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i + 1 < count + (curve.closed ? 1 : 0); ++i)
  {
    const Vector3d chord = curve.points[(i + 1) % count].position - curve.points[i].position;
    lengths.push_back(lengths.back() + chord.norm());
  }
  return lengths;
}

/// Where the new points are to lie, as arc lengths: from the first point to the last, which a
/// closed curve does not repeat.
std::vector<double> placesAlong(const std::vector<double>& lengths, double spacing, bool closed)
{
  if (!(spacing > 0.0))
  {
    return { lengths.begin(), lengths.end() - (closed ? 1 : 0) };
  }
  const double whole = lengths.back();
  const auto pieces =
    static_cast<std::size_t>(std::max(closed ? 3.0 : 1.0, std::round(whole / spacing)));
  std::vector<double> places(closed ? pieces : pieces + 1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    places[i] = whole * static_cast<double>(i) / static_cast<double>(pieces);
  }
  return places;
}

/// The cubic with the ends and tangents of a segment of the polyline, t in [0, 1].
Vector3d hermite(const TracedCurve& curve, std::size_t segment, double t)
{
  const std::size_t next = (segment + 1) % curve.points.size();
  const Vector3d& a = curve.points[segment].position;
  const Vector3d& b = curve.points[next].position;
  const double length = (b - a).norm();
  const double s = 1.0 - t;
  return (1.0 + 2.0 * t) * s * s * a + (1.0 + 2.0 * s) * t * t * b +
    length * t * s * (s * curve.tangents[segment] - t * curve.tangents[next]);
}

CubicSpline fitSpline(const TracedCurve& curve, const std::vector<double>& lengths)
{
  const std::size_t count = curve.points.size();
  std::vector<double> weights(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    // Each point stands for the piece of curve around it.
    const double before = i > 0 ? lengths[i] - lengths[i - 1] : 0.0;
    const double after = i + 1 < lengths.size() ? lengths[i + 1] - lengths[i] : 0.0;
    weights[i] = before + after;
  }
  const double step =
    std::accumulate(curve.steps.begin(), curve.steps.end(), 0.0) / static_cast<double>(count);
  const std::vector<double> parameters(
    lengths.begin(), lengths.begin() + static_cast<std::ptrdiff_t>(count));
  return CubicSpline(positionsOf(curve.points), parameters, weights, lengths.back(),
    KnotSpacing * step, curve.closed);
}

} // namespace

CurveShaper::CurveShaper(
  LevelSetModel& model, double level, const TracingLimits& limits, const CurveShape& shape)
  : model_(model)
  , level_(level)
  , limits_(limits)
  , shape_(shape)
{
}

/// A point of the new curve with what the model says of it.
LevelSetPoint CurveShaper::measure(
  const Vector3d& place, const LevelSetPoint& nearby, double step) const
{
  const bool project = this->shape_.fit == CurveFit::Interpolate && this->shape_.onLevelSet;
  std::optional<LevelSetPoint> point;
  if (project)
  {
    point = SurfaceScalars::project(this->model_, this->level_, place,
      { this->limits_.tolerance, step, this->limits_.maximumIterations });
  }
  if (!point)
  {
    point = nearby;
    point->position = place;
    point->converged = !project;
    const double residual =
      this->model_.centre(place) ? this->model_.firstOrderStep(this->level_).norm() : INFINITY;
    if (std::isfinite(residual))
    {
      point->residual = residual;
      point->normal = this->model_.normal();
    }
  }
  if (point->normal.dot(nearby.normal) < 0.0)
  {
    point->normal = -point->normal;
  }
  return *point;
}

TracedCurve CurveShaper::operator()(const TracedCurve& curve) const
{
  if (this->shape_.fit == CurveFit::Interpolate && !(this->shape_.spacing > 0.0))
  {
    return curve;
  }
  const std::vector<double> lengths = arcLengths(curve);
  std::optional<CubicSpline> spline;
  if (this->shape_.fit == CurveFit::LeastSquares)
  {
    spline = fitSpline(curve, lengths);
  }
  TracedCurve shaped;
  shaped.closed = curve.closed;
  std::size_t segment = 0;
  for (const double place : placesAlong(lengths, this->shape_.spacing, curve.closed))
  {
    while (segment + 2 < lengths.size() && lengths[segment + 1] <= place)
    {
      ++segment;
    }
    const double t = (place - lengths[segment]) / (lengths[segment + 1] - lengths[segment]);
    const std::size_t end = (segment + 1) % curve.points.size();
    const std::size_t nearest = t < 0.5 ? segment : end;
    // Points of the curve itself, its ends above all, stay what they are: one may be a saddle.
    const bool kept = !spline && (t == 0.0 || t == 1.0);
    shaped.points.push_back(kept
        ? curve.points[nearest]
        : this->measure(spline ? (*spline)(place) : hermite(curve, segment, t),
            curve.points[nearest], curve.steps[nearest]));
    shaped.tangents.push_back(curve.tangents[nearest]);
    shaped.steps.push_back(curve.steps[nearest]);
  }
  return shaped;
}

} // namespace SurfaceScalars
