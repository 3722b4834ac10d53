#include "CriticalRing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr int Places = 48; // on a ring: four in a sector of a fivefold saddle
constexpr int CenteringPlaces = 16;
constexpr int Centerings = 12;
constexpr double LargestMove = 0.5; // of a ring, in its radii
constexpr double LargestWay = 1.5;  // of a ring from where it was, in its radii
constexpr double Tolerance = 0.01;  // of its place, in its radii
constexpr double Growth = 2.5; // of gradients: about this power of the distance from 1st to 4th
constexpr double Significant = 3.0; // difference to its standard error
constexpr double Visible = 0.05;    // difference to the largest: less may be the run of a ridge
constexpr int LongestDoubt = 2;     // places in a row that noise hides between equal signs
constexpr int LongestChange = Places / 6; // and between different ones

/// f~ less a value, and the standard error of that.
struct Difference
{
  double size;
  double error;
};

/// -1, 0 or 1: 0 where noise hides it.
std::vector<int> signsOf(const std::vector<Difference>& differences)
{
  double largest = 0.0;
  for (const Difference& difference : differences)
  {
    largest = std::max(largest, std::abs(difference.size));
  }
  std::vector<int> signs;
  for (const Difference& difference : differences)
  {
    const bool isHidden =
      std::abs(difference.size) <= std::max(Significant * difference.error, Visible * largest);
    signs.push_back(isHidden ? 0 : difference.size > 0.0 ? 1 : -1);
  }
  return signs;
}

std::optional<RingCount> countChanges(const std::vector<int>& signs)
{
  const auto known = std::find_if(signs.begin(), signs.end(), [](int sign) { return sign != 0; });
  if (known == signs.end())
  {
    return {};
  }
  RingCount count{ 0, *known };
  int last = *known;
  int doubt = 0;
  const auto first = static_cast<std::size_t>(known - signs.begin());
  for (std::size_t i = 1; i <= signs.size(); ++i)
  {
    const int sign = signs[(first + i) % signs.size()];
    if (sign == 0)
    {
      ++doubt;
      continue;
    }
    if (doubt > (sign == last ? LongestDoubt : LongestChange))
    {
      return {};
    }
    count.changes += sign == last ? 0 : 1;
    last = sign;
    doubt = 0;
  }
  return count;
}

} // namespace

bool centerOnSurface(CriticalModel& model, const Vector3d& place)
{
  // Twice: the first center is off the surface where that is curved.
  return model.center(place) && model.center(model.fit().lift(Vector2d::Zero())) &&
    model.isSupported(0.0);
}

Vector3d placeOn(const Ring& ring, double angle)
{
  const Vector3d u = ring.normal.unitOrthogonal();
  const Vector3d v = ring.normal.cross(u);
  return ring.center + ring.radius * (std::cos(angle) * u + std::sin(angle) * v);
}

bool centerRing(CriticalModel& model, Ring& ring)
{
  const Vector3d start = ring.center;
  for (int i = 0; i < Centerings; ++i)
  {
    double mean = 0.0;
    Vector3d first = Vector3d::Zero(); // harmonic
    for (int k = 0; k < CenteringPlaces; ++k)
    {
      const Vector3d place = placeOn(ring, 2.0 * Pi * k / CenteringPlaces);
      if (!centerOnSurface(model, place))
      {
        return false;
      }
      const double length = model.jet(Vector2d::Zero()).gradient.norm();
      mean += length / CenteringPlaces;
      first += (2.0 / CenteringPlaces) * length * (place - ring.center) / ring.radius;
    }
    const Vector3d move = -ring.radius / (Growth * mean) * first;
    const double length = move.norm() / ring.radius;
    if (!std::isfinite(length))
    {
      return false;
    }
    const Vector3d next = ring.center + std::min(1.0, LargestMove / length) * move;
    if (!centerOnSurface(model, next))
    {
      return false;
    }
    ring.center = model.fit().lift(Vector2d::Zero());
    ring.normal = model.fit().normal(Vector2d::Zero());
    if (length <= Tolerance)
    {
      return true;
    }
    if ((ring.center - start).norm() > LargestWay * ring.radius)
    {
      return false;
    }
  }
  return false;
}

std::optional<RingCount> countAround(CriticalModel& model, const Ring& ring)
{
  const FitCovariance* covariance =
    centerOnSurface(model, ring.center) ? model.covariance() : nullptr;
  if (!covariance)
  {
    return {};
  }
  const double value = model.jet(Vector2d::Zero()).value;
  const double variance = covariance->ofValue(Vector2d::Zero());
  std::vector<Difference> differences;
  for (int i = 0; i < Places; ++i)
  {
    covariance =
      centerOnSurface(model, placeOn(ring, 2.0 * Pi * i / Places)) ? model.covariance() : nullptr;
    if (!covariance)
    {
      return {};
    }
    differences.push_back({ model.jet(Vector2d::Zero()).value - value,
      std::sqrt(covariance->ofValue(Vector2d::Zero()) + variance) });
  }
  return countChanges(signsOf(differences));
}

} // namespace SurfaceScalars
