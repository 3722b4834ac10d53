#include "PositionFunctions.h"

#include "Error.h"

#include "vtkPointSetScalarFunction.h"

#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1 << 14; // points per block of a parallel loop

using PositionFunction = std::function<double(const Vector3d& place)>;

std::string textOf(const Vector3d& vector)
{
  std::ostringstream text;
  text << "(" << vector.x() << ", " << vector.y() << ", " << vector.z() << ")";
  return text.str();
}

Vector3d unitVector(const std::string& property, const double* numbers)
{
  const Vector3d vector(numbers);
  Vector3d unit = vector.stableNormalized(); // tiny and huge ones too
  if (!unit.allFinite() || std::abs(unit.squaredNorm() - 1.0) > 1e-6)
  {
    throw InvalidInput("a finite " + property + " other than the zero vector", textOf(vector),
      "(0, 0, 1) is the z axis.");
  }
  return unit;
}

PositionFunction functionOf(vtkPointSetScalarFunction& filter)
{
  switch (filter.GetFunction())
  {
    case vtkPointSetScalarFunction::HEIGHT:
      return [direction = unitVector("Direction", filter.GetDirection())](const Vector3d& p)
      { return p.dot(direction); };
    case vtkPointSetScalarFunction::DISTANCE_TO_POINT:
      return [center = finitePlace("Center", filter.GetCenter())](const Vector3d& p)
      { return (p - center).norm(); };
    default:
      return [origin = finitePlace("Origin", filter.GetOrigin()),
               normal = unitVector("Normal", filter.GetNormal())](const Vector3d& p)
      { return std::abs((p - origin).dot(normal)); };
  }
}

} // namespace

Vector3d finitePlace(const std::string& property, const double* numbers)
{
  Vector3d place(numbers);
  if (!place.allFinite())
  {
    throw InvalidInput("a finite " + property, textOf(place), "Correct it.");
  }
  return place;
}

Values positionFunction(
  vtkPointSetScalarFunction& filter, const Points& points, const Execution& execution)
{
  const PositionFunction function = functionOf(filter);
  Values values(points.cols());
  parallelFor(static_cast<std::size_t>(points.cols()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
      {
        const Vector3d p = points.col(i);
        values(i) = p.allFinite() ? function(p) : std::numeric_limits<double>::quiet_NaN();
      }
    });
  return values;
}

} // namespace SurfaceScalars
