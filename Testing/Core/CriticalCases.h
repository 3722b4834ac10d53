#pragma once

#include "FuzzyCriticalPoints.h"
#include "Sampling.h"
#include "Torus.h"

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{

struct ExactPoint
{
  Vector3d position;
  CriticalType type;
  double value;
};

/// A function on a closed surface with its critical points.
struct CriticalCase
{
  std::string name;
  std::function<Points(int count, unsigned seed)> sample;
  std::function<double(const Vector3d&)> value;
  std::vector<ExactPoint> exact;
  int eulerCharacteristic;
};

inline const Vector3d TiltedDirection = Vector3d(0.5, 0.2, 0.84).normalized();

inline Points closedTorusSamples(int count, unsigned seed)
{
  return randomTorus(count, Torus::Closed, seed);
}

inline CriticalCase tiltedTorus()
{
  const double u = std::atan2(TiltedDirection.y(), TiltedDirection.x());
  const double v = std::asin(TiltedDirection.z());
  const auto height = [](const Vector3d& place) { return TiltedDirection.dot(place); };
  const auto point = [&](double axial, double around, CriticalType type) -> ExactPoint
  {
    const Vector3d place = torusPoint({ axial, around });
    return { place, type, height(place) };
  };
  return { "tilted height on a torus", closedTorusSamples, height,
    { point(u, v, CriticalType::Maximum), point(u + Pi, Pi - v, CriticalType::Saddle),
      point(u, v + Pi, CriticalType::Saddle), point(u + Pi, -v, CriticalType::Minimum) },
    0 };
}

inline CriticalCase wavyTorus()
{
  CriticalCase result{ "cos 3u cos 2v on a torus", closedTorusSamples,
    [](const Vector3d& place)
    {
      const Vector2d angles = torusAngles(place);
      return std::cos(3.0 * angles.x()) * std::cos(2.0 * angles.y());
    },
    {}, 0 };
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      const bool isLow = (i + j) % 2 == 1;
      result.exact.push_back({ torusPoint({ i * Pi / 3.0, j * Pi / 2.0 }),
        isLow ? CriticalType::Minimum : CriticalType::Maximum, isLow ? -1.0 : 1.0 });
      result.exact.push_back(
        { torusPoint({ (i + 0.5) * Pi / 3.0, (j + 0.5) * Pi / 2.0 }), CriticalType::Saddle, 0.0 });
    }
  }
  return result;
}

inline CriticalCase heightOfSphere()
{
  return { "height on a sphere", randomSphere,
    [](const Vector3d& place) { return TiltedDirection.dot(place); },
    { { TiltedDirection, CriticalType::Maximum, 1.0 },
      { -TiltedDirection, CriticalType::Minimum, -1.0 } },
    2 };
}

/// Samples and what is found on them.
struct FoundPoints
{
  NeighborGraph graph;
  FuzzyCriticalPoints critical;
};

inline FoundPoints findAmong(const PointsRef& points, const ValuesRef& values,
  const CriticalPointParameters& parameters = {}, const Execution& execution = {})
{
  NeighborGraph graph(points, NeighborQuery(), execution);
  FuzzyCriticalPoints critical =
    findCriticalPoints(graph, graph.average(values), parameters, execution);
  return { std::move(graph), std::move(critical) };
}

inline Values valuesAt(const PointsRef& points, const std::function<double(const Vector3d&)>& value)
{
  Values values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    values[i] = value(points.col(i));
  }
  return values;
}

/// @param noise on points, of 3 lengths, and on f, of its range
inline FoundPoints findOn(const CriticalCase& truth, int count, unsigned seed, double noise = 0.0,
  const CriticalPointParameters& parameters = {})
{
  Points points = truth.sample(count, seed);
  Values values = valuesAt(points, truth.value);
  if (noise > 0.0)
  {
    const double range = values.maxCoeff() - values.minCoeff();
    addNoise(points, 3.0 * noise, seed + 100);
    addNoise(values, range * noise, seed + 200);
  }
  return findAmong(points, values, parameters);
}

/// None if there is none of this type.
inline const CriticalPoint* nearestOfType(
  const std::vector<CriticalPoint>& points, const ExactPoint& exact)
{
  const CriticalPoint* nearest = nullptr;
  for (const CriticalPoint& point : points)
  {
    const bool isCloser = !nearest ||
      (point.position - exact.position).norm() < (nearest->position - exact.position).norm();
    nearest = point.type == exact.type && isCloser ? &point : nearest;
  }
  return nearest;
}

} // namespace SurfaceScalars::Truth
