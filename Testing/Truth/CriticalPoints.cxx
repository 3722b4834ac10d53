#include "CriticalPoints.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace SurfaceScalars::Truth
{
namespace
{

Vector2d angularGradient(const SpaceFunction& function, const Vector2d& angles)
{
  return torusTangents(angles).transpose() * function.gradient(torusPoint(angles));
}

// Central differences of the exact gradient: Newton's limit does not depend on their error.
Eigen::Matrix2d angularHessian(const SpaceFunction& function, const Vector2d& angles)
{
  const double step = 1e-5;
  Eigen::Matrix2d hessian;
  for (int i = 0; i < 2; ++i)
  {
    const Vector2d shift = step * Vector2d::Unit(i);
    hessian.col(i) =
      (angularGradient(function, angles + shift) - angularGradient(function, angles - shift)) /
      (2.0 * step);
  }
  return 0.5 * (hessian + hessian.transpose());
}

bool newton(const SpaceFunction& function, Vector2d& angles)
{
  for (int i = 0; i < 100; ++i)
  {
    Vector2d step =
      angularHessian(function, angles).fullPivLu().solve(-angularGradient(function, angles));
    if (!step.allFinite())
    {
      return false;
    }
    const double length = step.norm();
    angles += length > 0.2 ? Vector2d(step * (0.2 / length)) : step;
    if (length < 1e-12)
    {
      return true;
    }
  }
  return false;
}

bool isKnown(const std::vector<CriticalPoint>& found, const Vector2d& angles)
{
  return std::any_of(found.begin(), found.end(),
    [&](const CriticalPoint& point)
    { return (torusPoint(point.angles) - torusPoint(angles)).norm() < 1e-7; });
}

// Values that symmetry makes equal differ by rounding.
std::vector<double> distinct(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const double tolerance = 1e-10 * (values.back() - values.front());
  const auto equal = [=](double a, double b) { return b - a <= tolerance; };
  values.erase(std::unique(values.begin(), values.end(), equal), values.end());
  return values;
}

} // namespace

std::vector<CriticalPoint> criticalPoints(const SpaceFunction& function)
{
  const int starts = 40;
  std::vector<CriticalPoint> found;
  for (int i = 0; i < starts * starts; ++i)
  {
    // Off the axes of symmetry, on which Newton's method would stay.
    Vector2d angles = 2.0 * Pi / starts * Vector2d(i % starts + 0.37, i / starts + 0.41);
    if (newton(function, angles) && !isKnown(found, angles))
    {
      const int index = angularHessian(function, angles).determinant() > 0.0 ? 1 : -1;
      found.push_back({ angles, function.value(torusPoint(angles)), index });
    }
  }
  return found;
}

std::vector<double> boundaryCriticalValues(const SpaceFunction& function)
{
  const int intervals = 2000;
  const AngleRange axial = axialAngles(Torus::Cut);
  std::vector<double> values;
  for (const double u : { axial.begin, axial.end })
  {
    const auto slope = [&](double v) { return angularGradient(function, Vector2d(u, v)).y(); };
    for (int i = 0; i < intervals; ++i)
    {
      double low = 2.0 * Pi * (i + 0.3) / intervals;
      double high = 2.0 * Pi * (i + 1.3) / intervals;
      const bool risesAtLow = slope(low) > 0.0;
      if (risesAtLow == (slope(high) > 0.0))
      {
        continue;
      }
      for (int halving = 0; halving < 60; ++halving)
      {
        const double middle = 0.5 * (low + high);
        ((slope(middle) > 0.0) == risesAtLow ? low : high) = middle;
      }
      values.push_back(function.value(torusPoint({ u, low })));
    }
  }
  return values;
}

std::vector<double> criticalValues(const SpaceFunction& function, Torus torus)
{
  std::vector<double> values;
  for (const CriticalPoint& point : criticalPoints(function))
  {
    if (torus == Torus::Closed || distanceFromCut(torusPoint(point.angles)) > 0.0)
    {
      values.push_back(point.value);
    }
  }
  if (torus == Torus::Cut)
  {
    const std::vector<double> boundary = boundaryCriticalValues(function);
    values.insert(values.end(), boundary.begin(), boundary.end());
  }
  return distinct(values);
}

std::vector<double> regularIsoValues(
  const std::vector<double>& criticalValues, int count, double margin)
{
  const double range = criticalValues.back() - criticalValues.front();
  const double distance = margin * range;
  std::vector<double> isoValues;
  for (int i = 0; i < count; ++i)
  {
    const double wanted = criticalValues.front() + (i + 0.5) / count * range;
    // The allowed places nearest to `wanted`: itself, or just outside the margin of some critical
    // value.
    std::vector<double> places{ wanted };
    for (const double critical : criticalValues)
    {
      places.push_back(critical - distance * (1.0 + 1e-9));
      places.push_back(critical + distance * (1.0 + 1e-9));
    }
    const auto isAllowed = [&](double place)
    {
      const bool inside = place > criticalValues.front() && place < criticalValues.back();
      return inside &&
        std::all_of(criticalValues.begin(), criticalValues.end(),
          [&](double critical) { return std::abs(place - critical) >= distance; }) &&
        std::find(isoValues.begin(), isoValues.end(), place) == isoValues.end();
    };
    places.erase(
      std::remove_if(places.begin(), places.end(), [&](double place) { return !isAllowed(place); }),
      places.end());
    if (places.empty())
    {
      throw std::logic_error("the margins around the critical values cover the whole range");
    }
    isoValues.push_back(*std::min_element(places.begin(), places.end(),
      [=](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); }));
  }
  std::sort(isoValues.begin(), isoValues.end());
  return isoValues;
}

} // namespace SurfaceScalars::Truth
