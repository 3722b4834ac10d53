#include "SurfaceNewton.h"

#include "SurfaceRestriction.h"

#include <cmath>

namespace SurfaceScalars
{

SurfaceNewton::SurfaceNewton(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const Field& field, double tolerance)
  : chart_(vertices, mesh, values)
  , field_(field)
  , vertices_(vertices)
  , tolerance_(tolerance)
  , approximation_(field.approximation())
{
}

bool SurfaceNewton::enter(Index vertex)
{
  return this->chart_.center(vertex);
}

SurfaceSearch SurfaceNewton::search(
  const Vector3d& place, CriticalType type, const SearchEffort& effort, const Poll& poll)
{
  SurfaceSearch result;
  result.place = place;
  result.vertex = this->chart_.vertex();
  this->evaluations_ = 0;
  PlanarPoint point;
  if (!this->begin(place, point))
  {
    return result;
  }
  TrustRegion region(type, this->chart_.spacing());
  const auto u = [this](const Vector2d& st, PlanarPoint& there)
  { return this->evaluate(st, there); };
  result.residuals.push_back(point.residual);
  const auto isOnChart = [&] { return point.st.norm() <= this->chart_.radius(); };
  bool goesOn = true;
  while (goesOn && isOnChart() && point.residual > this->tolerance_ &&
    result.stepCount() < effort.mostSteps)
  {
    if (poll)
    {
      poll();
    }
    goesOn = region.step(point, this->chart_.radius(), u);
    if (goesOn)
    {
      goesOn = effort.isPatient || point.residual <= 0.5 * result.residuals.back();
      result.residuals.push_back(point.residual);
    }
  }
  result.evaluations = this->evaluations_;
  result.place = this->chart_.fit().lift(point.st);
  result.vertex = this->chart_.nearestVertex(result.place);
  result.restricted = point.g;
  result.spacing = this->chart_.spacing();
  result.isOnChart = isOnChart();
  result.isOnMesh = this->chart_.covers(result.place);
  result.isCritical = result.isOnChart && point.residual <= this->tolerance_;
  return result;
}

double SurfaceNewton::residualAt(Index vertex)
{
  PlanarPoint point;
  const bool isKnown = this->enter(vertex) && this->begin(this->vertices_.col(vertex), point);
  return isKnown ? point.residual : -1.0;
}

bool SurfaceNewton::begin(const Vector3d& place, PlanarPoint& point)
{
  const Vector3d origin = this->field_.cloud().origin();
  return this->approximation_->center(this->vertices_.col(this->chart_.vertex()) - origin) &&
    this->evaluate(this->chart_.fit().flatten(place), point);
}

bool SurfaceNewton::evaluate(const Vector2d& st, PlanarPoint& point)
{
  const LocalFit& surface = this->chart_.fit();
  const FieldJet u = this->approximation_->jet(
    surface.lift(st) - this->field_.cloud().origin(), Derivatives::Hessian);
  point.st = st;
  point.g = restrictedTo(surface, st, u);
  point.residual =
    surface.tangentialGradient(point.g.gradient, surface.heightSlope(st).gradient).norm();
  ++this->evaluations_;
  return std::isfinite(point.residual) && point.g.hessian.allFinite();
}

} // namespace SurfaceScalars
