#include "CurveShaper.h"

#include "Polyline.h"
#include "Spline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace SurfaceScalars
{
namespace
{

constexpr int Subdivision = 8;      // of segments, to measure the length of a smooth curve
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

/// A smooth curve through or near a polyline, as a function of the polyline's arc length.
class SmoothCurve
{
public:
  SmoothCurve(const TracedCurve& curve, CurveFit fit)
    : curve_(curve)
    , lengths_(arcLengths(curve))
  {
    if (fit == CurveFit::LeastSquares)
    {
      this->spline_ = fitSpline(curve, this->lengths_);
    }
  }

  Vector3d operator()(double place) const
  {
    return this->spline_ ? (*this->spline_)(place) : this->hermite(place);
  }

  /// The point of the polyline closest to a place.
  std::size_t nearest(double place) const
  {
    const std::size_t segment = this->segmentAt(place);
    const double middle = 0.5 * (this->lengths_[segment] + this->lengths_[segment + 1]);
    return place < middle ? segment : (segment + 1) % this->curve_.points.size();
  }

  /// Places that divide the curve into pieces of equal length, as close to `spacing` as a whole
  /// number of them can be; the polyline's own points if spacing is 0. A closed curve's first point
  /// is not repeated.
  std::vector<double> places(double spacing) const;

private:
  std::size_t segmentAt(double place) const
  {
    const auto after = std::upper_bound(this->lengths_.begin(), this->lengths_.end(), place);
    const auto segment = std::max<std::ptrdiff_t>(after - this->lengths_.begin() - 1, 0);
    return std::min(static_cast<std::size_t>(segment), this->lengths_.size() - 2);
  }

  /// The cubic with the ends and tangents of a segment of the polyline.
  Vector3d hermite(double place) const;

  const TracedCurve& curve_;
  std::vector<double> lengths_;
  std::optional<CubicSpline> spline_;
};

Vector3d SmoothCurve::hermite(double place) const
{
  const std::size_t segment = this->segmentAt(place);
  const std::size_t next = (segment + 1) % this->curve_.points.size();
  const double length = this->lengths_[segment + 1] - this->lengths_[segment];
  const double t = (place - this->lengths_[segment]) / length;
  const double s = 1.0 - t;
  return (1.0 + 2.0 * t) * s * s * this->curve_.points[segment].position +
    (1.0 + 2.0 * s) * t * t * this->curve_.points[next].position +
    length * t * s * (s * this->curve_.tangents[segment] - t * this->curve_.tangents[next]);
}

std::vector<double> SmoothCurve::places(double spacing) const
{
  const bool closed = this->curve_.closed;
  if (!(spacing > 0.0))
  {
    return { this->lengths_.begin(), this->lengths_.end() - (closed ? 1 : 0) };
  }
  // The length of the smooth curve up to places between the polyline's points.
  std::vector<double> fine{ 0.0 };
  std::vector<double> along{ 0.0 };
  Vector3d last = (*this)(0.0);
  for (std::size_t segment = 0; segment + 1 < this->lengths_.size(); ++segment)
  {
    for (int i = 1; i <= Subdivision; ++i)
    {
      const double t = static_cast<double>(i) / Subdivision;
      fine.push_back((1.0 - t) * this->lengths_[segment] + t * this->lengths_[segment + 1]);
      const Vector3d place = (*this)(fine.back());
      along.push_back(along.back() + (place - last).norm());
      last = place;
    }
  }
  // Between saddles it may be a loop, or half of one.
  const bool mayClose =
    closed || (this->curve_.start == CurveEnd::Saddle && this->curve_.end == CurveEnd::Saddle);
  const auto pieces =
    static_cast<std::size_t>(std::max(mayClose ? 3.0 : 1.0, std::round(along.back() / spacing)));
  std::vector<double> places(closed ? pieces : pieces + 1);
  std::size_t k = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double wanted = along.back() * static_cast<double>(i) / static_cast<double>(pieces);
    for (; k + 2 < along.size() && along[k + 1] < wanted; ++k)
    {
    }
    const double t = std::clamp((wanted - along[k]) / (along[k + 1] - along[k]), 0.0, 1.0);
    places[i] = (1.0 - t) * fine[k] + t * fine[k + 1];
  }
  return places;
}

} // namespace

CurveShaper::CurveShaper(LevelSetModel& model, double level, const TracingLimits& limits,
  const CurveShape& shape, const Poll& poll)
  : model_(model)
  , level_(level)
  , limits_(limits)
  , shape_(shape)
  , poll_(poll)
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
      this->model_.center(place) ? this->model_.firstOrderStep(this->level_).norm() : INFINITY;
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

TracedCurve CurveShaper::shapeSmooth(const TracedCurve& curve) const
{
  const SmoothCurve smooth(curve, this->shape_.fit);
  TracedCurve shaped;
  shaped.closed = curve.closed;
  const std::vector<double> places = smooth.places(this->shape_.spacing);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    this->poll_();
    const std::size_t nearest = smooth.nearest(places[i]);
    // The ends stay what they are if the curve goes through them, and at saddles.
    const bool isFirst = i == 0;
    const bool isLast = !curve.closed && i + 1 == places.size();
    const bool kept = (isFirst || isLast) && this->shape_.fit == CurveFit::Interpolate;
    const bool atSaddle = !curve.closed &&
      ((isFirst && curve.start == CurveEnd::Saddle) || (isLast && curve.end == CurveEnd::Saddle));
    shaped.points.push_back(kept || atSaddle
        ? curve.points[nearest]
        : this->measure(smooth(places[i]), curve.points[nearest], curve.steps[nearest]));
    shaped.tangents.push_back(curve.tangents[nearest]);
    shaped.steps.push_back(curve.steps[nearest]);
  }
  return shaped;
}

/// A loop with corners, from corner to corner.
TracedCurve CurveShaper::shapeLoop(const TracedCurve& loop) const
{
  TracedCurve shaped;
  shaped.closed = true;
  const std::size_t count = loop.points.size();
  for (std::size_t i = 0; i < loop.corners.size(); ++i)
  {
    const std::size_t begin = loop.corners[i];
    const std::size_t end = i + 1 < loop.corners.size() ? loop.corners[i + 1] : count;
    TracedCurve piece;
    piece.start = piece.end = CurveEnd::Saddle;
    for (std::size_t k = begin; k <= end; ++k)
    {
      piece.points.push_back(loop.points[k % count]);
      piece.tangents.push_back(loop.tangents[k % count]);
      piece.steps.push_back(loop.steps[k % count]);
    }
    piece.tangents.back() =
      (piece.points.back().position - loop.points[end - 1].position).normalized();
    piece = this->shapeSmooth(piece);
    shaped.corners.push_back(shaped.points.size());
    shaped.points.insert(shaped.points.end(), piece.points.begin(), piece.points.end() - 1);
    shaped.tangents.insert(shaped.tangents.end(), piece.tangents.begin(), piece.tangents.end() - 1);
    shaped.steps.insert(shaped.steps.end(), piece.steps.begin(), piece.steps.end() - 1);
  }
  return shaped;
}

TracedCurve CurveShaper::operator()(const TracedCurve& curve) const
{
  if (this->shape_.fit == CurveFit::Interpolate && !(this->shape_.spacing > 0.0))
  {
    return curve;
  }
  return curve.corners.empty() ? this->shapeSmooth(curve) : this->shapeLoop(curve);
}

} // namespace SurfaceScalars
