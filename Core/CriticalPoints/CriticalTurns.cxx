#include "CriticalTurns.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr int Places = 16;                // on a ring, at first
constexpr int RingParts = 32;             // of the steps between them, at most
constexpr int EllipseParts = 1024;        // along a ridge the gradient turns within few of them
constexpr double LargestTurn = 0.35 * Pi; // of the gradient between places
constexpr double LeastCosine = 0.2;       // of normals: what is steeper is not seen from the ring

/// The direction of the gradient at the surface next to a place, seen along a normal.
std::optional<double> gradientAngle(
  CriticalModel& model, const Vector3d& normal, const Vector3d& place)
{
  if (!centerOnSurface(model, place) ||
    std::abs(model.fit().normal(Vector2d::Zero()).dot(normal)) < LeastCosine)
  {
    return {};
  }
  const Vector3d gradient = model.fit().tangentialGradient(
    model.jet(Vector2d::Zero()).gradient, model.fit().heightSlope(Vector2d::Zero()).gradient);
  const Vector3d u = normal.unitOrthogonal();
  return std::atan2(gradient.dot(normal.cross(u)), gradient.dot(u));
}

/// The smaller way from one direction to another.
double turnBetween(double from, double to)
{
  return std::remainder(to - from, 2.0 * Pi);
}

int wholeTurns(double turn)
{
  return static_cast<int>(std::lround(turn / (2.0 * Pi)));
}

/// The square grid of cells over a disc.
class Cells
{
public:
  Cells(const Ring& disc, double width)
    : disc_(disc)
    , count_(static_cast<int>(std::ceil(2.0 * disc.radius / width)))
    , width_(2.0 * disc.radius / this->count_)
    , u_(disc.normal.unitOrthogonal())
    , v_(disc.normal.cross(this->u_))
  {
  }

  int count() const { return this->count_; } ///< in a row
  Vector3d placeAt(double i, double j) const
  {
    return this->disc_.center + (i * this->width_ - this->disc_.radius) * this->u_ +
      (j * this->width_ - this->disc_.radius) * this->v_;
  }
  /// Of the gradients at the corners; none outside of the disc.
  std::vector<std::optional<double>> anglesAtCorners(CriticalModel& model) const
  {
    std::vector<std::optional<double>> angles;
    for (int j = 0; j <= this->count_; ++j)
    {
      for (int i = 0; i <= this->count_; ++i)
      {
        const Vector3d place = this->placeAt(i, j);
        const bool isWithin = (place - this->disc_.center).norm() <= this->disc_.radius;
        angles.push_back(isWithin ? gradientAngle(model, this->disc_.normal, place) : std::nullopt);
      }
    }
    return angles;
  }
  /// 0 if the gradient is not known at all corners.
  int indexOf(int i, int j, const std::vector<std::optional<double>>& angles) const
  {
    const auto row = static_cast<std::size_t>(this->count_) + 1;
    const auto first = static_cast<std::size_t>(j) * row + static_cast<std::size_t>(i);
    const std::array<std::size_t, 5> around{ first, first + 1, first + row + 1, first + row,
      first };
    double turn = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
    {
      const std::optional<double>& from = angles[around[k]];
      const std::optional<double>& to = angles[around[k + 1]];
      if (!from || !to)
      {
        return 0;
      }
      turn += turnBetween(*from, *to);
    }
    return wholeTurns(turn);
  }

private:
  const Ring& disc_;
  int count_;
  double width_;
  Vector3d u_;
  Vector3d v_;
};

/// In steps that are small where the gradient turns fast.
/// @param angleAt the direction of the gradient at an angle of a curve, counterclockwise
/// @param mostParts power of 2
template <class AngleAt>
std::optional<int> turnsAlong(const AngleAt& angleAt, int mostParts)
{
  const int ticks = Places * mostParts;
  double turn = 0.0;
  int tick = 0;
  int step = mostParts;
  std::optional<double> last = angleAt(0.0);
  while (last && tick < ticks)
  {
    const std::optional<double> next = angleAt(2.0 * Pi * (tick + step) / ticks);
    const double change = next ? turnBetween(*last, *next) : 0.0;
    if (std::abs(change) > LargestTurn)
    {
      if (step == 1)
      {
        return {};
      }
      step /= 2;
      continue;
    }
    turn += change;
    tick += step;
    last = next;
    step *= step < mostParts && tick % (2 * step) == 0 ? 2 : 1;
  }
  return last ? std::optional<int>(wholeTurns(turn)) : std::nullopt;
}

/// Of the gradient at the center, to its standard error.
double clearnessOf(CriticalModel& model)
{
  const FitCovariance* covariance = model.covariance();
  if (!covariance)
  {
    return 0.0;
  }
  const double variance = covariance->ofGradient(Vector2d::Zero()).trace();
  return model.jet(Vector2d::Zero()).gradient.norm() / std::sqrt(variance);
}

} // namespace

std::optional<int> indexWithin(CriticalModel& model, const Ring& ring)
{
  return turnsAlong([&](double angle)
    { return gradientAngle(model, ring.normal, placeOn(ring, angle)); },
    RingParts);
}

std::optional<ClearIndex> indexWithin(CriticalModel& model, const Ellipse& ellipse)
{
  double clearness = std::numeric_limits<double>::infinity();
  const std::optional<int> index = turnsAlong(
    [&](double angle)
    {
      const std::optional<double> direction = gradientAngle(model, ellipse.normal,
        ellipse.center + ellipse.halfAxes * Vector2d(std::cos(angle), std::sin(angle)));
      clearness = direction ? std::min(clearness, clearnessOf(model)) : 0.0;
      return direction;
    },
    EllipseParts);
  return index ? std::optional<ClearIndex>({ *index, clearness }) : std::nullopt;
}

std::vector<Turn> turnsWithin(CriticalModel& model, const Ring& disc, double cellWidth)
{
  const Cells cells(disc, cellWidth);
  const std::vector<std::optional<double>> angles = cells.anglesAtCorners(model);
  std::vector<Turn> turns;
  for (int j = 0; j < cells.count(); ++j)
  {
    for (int i = 0; i < cells.count(); ++i)
    {
      const int index = cells.indexOf(i, j, angles);
      if (index != 0 && centerOnSurface(model, cells.placeAt(i + 0.5, j + 0.5)))
      {
        turns.push_back({ model.fit().lift(Vector2d::Zero()), index });
      }
    }
  }
  return turns;
}

} // namespace SurfaceScalars
