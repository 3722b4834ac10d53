#include "CriticalPoints.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace SurfaceScalars::Truth
{
namespace
{

// Central differences of the exact gradient: Newton's limit does not depend on their error.
Eigen::Matrix3d hessianOf(const SpaceFunction& function, const Vector3d& place)
{
  const double step = 1e-5;
  Eigen::Matrix3d hessian;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3d shift = step * Vector3d::Unit(i);
    hessian.col(i) =
      (function.gradient(place + shift) - function.gradient(place - shift)) / (2.0 * step);
  }
  return 0.5 * (hessian + hessian.transpose());
}

/// f on {g = 0}: the place p and the multiplier l at which grad f = l grad g.
struct Lagrange
{
  const SpaceFunction& f;
  const SpaceFunction& g;
  Vector3d place;
  double multiplier;

  Lagrange(const SpaceFunction& function, const SpaceFunction& implicit, const Vector3d& start)
    : f(function)
    , g(implicit)
    , place(start)
    , multiplier(f.gradient(start).dot(g.gradient(start)) / g.gradient(start).squaredNorm())
  {
  }

  Eigen::Matrix3d hessian() const
  {
    return hessianOf(this->f, this->place) - this->multiplier * hessianOf(this->g, this->place);
  }

  Eigen::Vector4d newtonStep() const
  {
    const Vector3d normal = this->g.gradient(this->place);
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix.topLeftCorner<3, 3>() = this->hessian();
    matrix.topRightCorner<3, 1>() = -normal;
    matrix.bottomLeftCorner<1, 3>() = normal.transpose();
    Eigen::Vector4d residual;
    residual << this->f.gradient(this->place) - this->multiplier * normal,
      this->g.value(this->place);
    return matrix.fullPivLu().solve(-residual);
  }

  bool converges()
  {
    for (int i = 0; i < 100; ++i)
    {
      Eigen::Vector4d step = this->newtonStep();
      if (!step.allFinite())
      {
        return false;
      }
      const double length = step.head<3>().norm();
      step *= std::min(1.0, 0.05 / length);
      this->place += step.head<3>();
      this->multiplier += step[3];
      if (length < 1e-11)
      {
        return true;
      }
    }
    return false;
  }

  CriticalType type() const
  {
    const Vector3d normal = this->g.gradient(this->place).normalized();
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = normal.unitOrthogonal();
    tangents.col(1) = normal.cross(tangents.col(0));
    const Eigen::Matrix2d restricted = tangents.transpose() * this->hessian() * tangents;
    if (restricted.determinant() < 0.0)
    {
      return CriticalType::Saddle;
    }
    return restricted.trace() < 0.0 ? CriticalType::Maximum : CriticalType::Minimum;
  }
};

bool isKnown(const std::vector<CriticalPoint>& found, const Vector3d& place)
{
  return std::any_of(found.begin(), found.end(),
    [&](const CriticalPoint& point) { return (point.position - place).norm() < 1e-6; });
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

std::vector<CriticalPoint> criticalPoints(
  const ClosedSurface& surface, const SpaceFunction& function)
{
  const Points starts = surface.sample(2000, 1);
  std::vector<CriticalPoint> found;
  for (Eigen::Index i = 0; i < starts.cols(); ++i)
  {
    Lagrange solution(function, surface.implicit, starts.col(i));
    if (solution.converges() && !isKnown(found, solution.place))
    {
      CriticalPoint point;
      point.position = solution.place;
      point.type = solution.type();
      point.value = function.value(solution.place);
      found.push_back(point);
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
    const auto slope = [&](double v)
    {
      const Vector2d angles(u, v);
      return torusTangents(angles).col(1).dot(function.gradient(torusPoint(angles)));
    };
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
  for (const CriticalPoint& point : criticalPoints(closedTorus(), function))
  {
    if (torus == Torus::Closed || distanceFromCut(point.position) > 0.0)
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
