#include "Surfaces.h"

#include "Sampling.h"
#include "Torus.h"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

/// A line through a ball, uniform in direction and in the disk that it crosses.
struct RandomLine
{
  Vector3d direction;
  Vector3d foot; ///< its point closest to the origin

  RandomLine(double radius, Random& random)
  {
    const double x = random.normal();
    const double y = random.normal();
    this->direction = Vector3d(x, y, random.normal()).normalized();
    const Vector3d across = this->direction.unitOrthogonal();
    const double distance = radius * std::sqrt(random.uniform());
    const double angle = random.uniform(0.0, 2.0 * Pi);
    this->foot =
      distance * (std::cos(angle) * across + std::sin(angle) * this->direction.cross(across));
  }
  Vector3d at(double t) const { return this->foot + t * this->direction; }
};

double bisect(const std::function<double(double)>& function, double low, double high)
{
  const bool risesAtLow = function(low) > 0.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    ((function(middle) > 0.0) == risesAtLow ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double figureEight(const Vector3d& p)
{
  const double square = p.x() * p.x();
  return square * (square - 1.0) + p.y() * p.y();
}

SpaceFunction tubeAroundEight()
{
  const auto value = [](const Vector3d& p)
  { return figureEight(p) * figureEight(p) + p.z() * p.z() - 0.15 * 0.15; };
  const auto gradient = [](const Vector3d& p) -> Vector3d
  {
    const Vector3d ofEight(p.x() * (4.0 * p.x() * p.x() - 2.0), 2.0 * p.y(), 0.0);
    return 2.0 * (figureEight(p) * ofEight + p.z() * Vector3d::UnitZ());
  };
  return { "tube around a figure eight", value, gradient };
}

/// y^2 = 4 (1 - s) (s - 1/4)^2 with s = x^2 / 2.5 runs around three loops.
SpaceFunction tubeAroundThreeLoops()
{
  const auto planar = [](const Vector3d& p)
  {
    const double square = p.x() * p.x() / 2.5;
    return p.y() * p.y() - 4.0 * (1.0 - square) * (square - 0.25) * (square - 0.25);
  };
  const auto value = [=](const Vector3d& p)
  { return planar(p) * planar(p) + p.z() * p.z() - 0.16 * 0.16; };
  const auto gradient = [=](const Vector3d& p) -> Vector3d
  {
    const double square = p.x() * p.x() / 2.5;
    const double alongX = -3.2 * p.x() * (square - 0.25) * (2.0 * (1.0 - square) - (square - 0.25));
    return 2.0 * (planar(p) * Vector3d(alongX, 2.0 * p.y(), 0.0) + p.z() * Vector3d::UnitZ());
  };
  return { "tube around three loops", value, gradient };
}

} // namespace

ClosedSurface unitSphere()
{
  return { "sphere",
    { "sphere", [](const Vector3d& p) { return p.squaredNorm() - 1.0; },
      [](const Vector3d& p) -> Vector3d { return 2.0 * p; } },
    randomSphere, 2 };
}

ClosedSurface closedTorus()
{
  return { "torus",
    { "torus", torusDistance, [](const Vector3d& p) { return torusNormal(torusAngles(p)); } },
    [](int count, unsigned seed) { return randomTorus(count, Torus::Closed, seed); }, 0 };
}

ClosedSurface doubleTorus()
{
  return { "double torus", tubeAroundEight(),
    [](int count, unsigned seed) { return randomCrossings(tubeAroundEight(), 1.3, count, seed); },
    -2 };
}

ClosedSurface tripleTorus()
{
  return { "triple torus", tubeAroundThreeLoops(),
    [](int count, unsigned seed)
    { return randomCrossings(tubeAroundThreeLoops(), 1.8, count, seed); },
    -4 };
}

Points randomCrossings(const SpaceFunction& implicit, double radius, int count, unsigned seed)
{
  Random random(seed);
  const double step = 0.01 * radius;
  Points points(3, count);
  for (int found = 0; found < count;)
  {
    const RandomLine line(radius, random);
    const auto along = [&](double t) { return implicit.value(line.at(t)); };
    double before = along(-radius);
    for (int i = 1; i <= 200 && found < count; ++i)
    {
      const double t = -radius + i * step;
      const double here = along(t);
      if ((before > 0.0) != (here > 0.0))
      {
        points.col(found++) = line.at(bisect(along, t - step, t));
      }
      before = here;
    }
  }
  return points;
}

} // namespace SurfaceScalars::Truth
