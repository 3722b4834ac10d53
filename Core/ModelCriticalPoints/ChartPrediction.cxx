#include "ChartPrediction.h"

#include "SurfaceRestriction.h"
#include "TrustRegion.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr int MostSteps = 20;
constexpr double Smaller = 1e-6;   // of the first gradient: as sharp as a start needs to be
constexpr double SamePlace = 0.1;  // of two places, in spacings of the mesh
constexpr double FirstTrust = 0.5; // in spacings of the mesh

/// Goes to a critical point of the polynomial. @returns whether there is one of that type
bool descend(const LocalFit& fit, CriticalType type, double trust, Vector2d& st)
{
  const auto polynomial = [&fit](const Vector2d& place, PlanarPoint& point)
  {
    point.st = place;
    point.g = fit.value(place);
    point.residual = point.g.gradient.norm();
    return true;
  };
  PlanarPoint point;
  polynomial(st, point);
  const double sharp = Smaller * point.residual;
  TrustRegion region(type, trust);
  for (int i = 0; i < MostSteps && point.residual > sharp; ++i)
  {
    if (!region.step(point, fit.scale(), polynomial) || point.st.norm() > fit.scale())
    {
      return false;
    }
  }
  st = point.st;
  return point.residual <= sharp && typeOf(point.g.hessian) == type;
}

} // namespace

std::vector<Vector3d> predictedPlaces(const PointsRef& vertices, const MeshTopology& mesh,
  const MeshChart& chart, CriticalType type, const Vector3d& place)
{
  std::vector<Vector3d> places;
  const auto addFrom = [&](Index vertex)
  {
    Vector2d st = chart.fit().flatten(vertices.col(vertex));
    if (descend(chart.fit(), type, FirstTrust * chart.spacing(), st))
    {
      const Vector3d found = chart.fit().lift(st);
      const auto isSame = [&](const Vector3d& other)
      { return (other - found).norm() <= SamePlace * chart.spacing(); };
      if (std::none_of(places.begin(), places.end(), isSame))
      {
        places.push_back(found);
      }
    }
  };
  addFrom(chart.vertex());
  for (const Index neighbor : mesh.link(chart.vertex()))
  {
    addFrom(neighbor);
  }
  std::stable_sort(places.begin(), places.end(),
    [&](const Vector3d& a, const Vector3d& b)
    { return (a - place).squaredNorm() < (b - place).squaredNorm(); });
  return places;
}

} // namespace SurfaceScalars
