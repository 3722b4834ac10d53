#include "SurfaceNewton.h"

#include "SurfaceRestriction.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double GoodPrediction = 0.25; // errors of the gradient, in its predicted change
constexpr double BadPrediction = 0.75;
constexpr double SmallestTrust = 1e-10; // in radii: rounding

/// -sign_i g_i / (|l_i| + mu) in the axes of the Hessian.
Vector2d shiftedStep(const Vector2d& gradient, const Vector2d& sizes, double shift)
{
  return -gradient.cwiseQuotient((sizes.array() + shift).matrix());
}

/// The step within a trust region, in the axes of the Hessian.
Vector2d stepWithin(const Vector2d& gradient, const Vector2d& sizes, double trust)
{
  const double scale = gradient.norm() / trust; // as a shift, short enough
  Vector2d step = shiftedStep(gradient, sizes, 0.0);
  if (step.allFinite() && step.norm() <= trust)
  {
    return step;
  }
  double low = 0.0;
  double high = scale;
  constexpr int halvings = 30;
  for (int i = 0; i < halvings; ++i)
  {
    const double middle = 0.5 * (low + high);
    (shiftedStep(gradient, sizes, middle).norm() <= trust ? high : low) = middle;
  }
  return shiftedStep(gradient, sizes, high);
}

/// The direction of the gradient to follow, up or down, along the axes of eigenvalues that ascend.
Vector2d signsFor(CriticalType type, const Vector2d& eigenvalues)
{
  switch (type)
  {
    case CriticalType::Minimum:
      return { 1.0, 1.0 };
    case CriticalType::Maximum:
      return { -1.0, -1.0 };
    case CriticalType::Saddle:
      return { -1.0, 1.0 };
    default:
      return { eigenvalues[0] < 0.0 ? -1.0 : 1.0, eigenvalues[1] < 0.0 ? -1.0 : 1.0 };
  }
}

} // namespace

SurfaceNewton::SurfaceNewton(const PointsRef& vertices, const MeshTopology& mesh,
  const Field& field, const SearchLimits& limits)
  : chart_(vertices, mesh)
  , field_(field)
  , vertices_(vertices)
  , limits_(limits)
  , approximation_(field.approximation())
{
}

SurfaceSearch SurfaceNewton::search(
  const Vector3d& place, Index vertex, CriticalType type, ChartChoice charts, const Poll& poll)
{
  SurfaceSearch result;
  result.place = place;
  result.vertex = vertex;
  this->entered_.clear();
  this->evaluations_ = 0;
  Point point;
  if (!this->enter(vertex) || !this->evaluate(this->chart_.fit().flatten(place), point))
  {
    return result;
  }
  this->trust_ = this->chart_.spacing();
  result.residuals.push_back(point.residual);
  bool isThere = false;
  while ((isThere = this->follow(point, charts)) && point.residual > this->limits_.tolerance &&
    result.stepCount() < this->limits_.mostSteps)
  {
    if (poll)
    {
      poll();
    }
    if (!this->step(point, type))
    {
      break;
    }
    result.residuals.push_back(point.residual);
  }
  result.evaluations = this->evaluations_;
  if (!isThere)
  {
    return result;
  }
  result.residuals.back() = point.residual; // in the last chart
  result.place = this->chart_.fit().lift(point.st);
  result.vertex = this->chart_.nearestVertex(result.place);
  result.restricted = point.g;
  result.spacing = this->chart_.spacing();
  result.isCritical = point.residual <= this->limits_.tolerance;
  result.isOnMesh = point.st.norm() <= this->chart_.radius() && this->chart_.covers(result.place);
  return result;
}

double SurfaceNewton::residualAt(Index vertex)
{
  this->entered_.clear();
  Point point;
  const bool isKnown = this->enter(vertex) &&
    this->evaluate(this->chart_.fit().flatten(this->vertices_.col(vertex)), point);
  return isKnown ? point.residual : -1.0;
}

bool SurfaceNewton::enter(Index vertex)
{
  this->entered_.push_back(vertex);
  return this->chart_.center(vertex) &&
    this->approximation_->center(this->vertices_.col(vertex) - this->field_.cloud().origin());
}

bool SurfaceNewton::evaluate(const Vector2d& st, Point& point)
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

/// Enters the chart of the vertex next to the point. @returns whether the search can go on
bool SurfaceNewton::follow(Point& point, ChartChoice charts)
{
  if (charts == ChartChoice::First)
  {
    return point.st.norm() <= this->chart_.radius();
  }
  const Vector3d place = this->chart_.fit().lift(point.st);
  const Index nearest = this->chart_.nearestVertex(place);
  if (nearest == this->chart_.vertex() ||
    std::find(this->entered_.begin(), this->entered_.end(), nearest) != this->entered_.end())
  {
    return true;
  }
  return this->enter(nearest) && this->evaluate(this->chart_.fit().flatten(place), point);
}

bool SurfaceNewton::step(Point& point, CriticalType type)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(point.g.hessian);
  const Vector2d followed = axes.eigenvectors().transpose() * point.g.gradient;
  const Vector2d gradient = followed.cwiseProduct(signsFor(type, axes.eigenvalues()));
  const Vector2d sizes = axes.eigenvalues().cwiseAbs();
  this->trust_ = std::min(this->trust_, this->chart_.radius());
  while (this->trust_ > SmallestTrust * this->chart_.radius())
  {
    const Vector2d step = axes.eigenvectors() * stepWithin(gradient, sizes, this->trust_);
    Point next;
    if (this->evaluate(point.st + step, next) && this->isBetter(point, next, step, type))
    {
      point = next;
      return true;
    }
    this->trust_ = 0.25 * step.norm();
  }
  return false;
}

bool SurfaceNewton::isBetter(
  const Point& before, const Point& after, const Vector2d& step, CriticalType type)
{
  const Vector2d predicted = before.g.hessian * step;
  const double error = (after.g.gradient - before.g.gradient - predicted).norm() / predicted.norm();
  if (error <= GoodPrediction && step.norm() > 0.5 * this->trust_)
  {
    this->trust_ *= 2.0;
  }
  const bool isCloser = after.residual < before.residual;
  return type == CriticalType::Uncertain ? isCloser : isCloser || error <= BadPrediction;
}

} // namespace SurfaceScalars
