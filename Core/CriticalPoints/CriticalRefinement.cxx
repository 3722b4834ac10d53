#include "CriticalRefinement.h"

#include "Places.h"
#include "PointTree.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int MostCenters = 40;
constexpr double Tolerance = 1e-7;      // of the place, in radii
constexpr double LooseTolerance = 0.05; // where fits to noise jump
constexpr double Damping = 0.5;         // of steps that do not come to rest
constexpr double LargestStep = 0.6;     // in radii
constexpr double LargestWay = 1.2;      // from the candidate, in radii
constexpr double SameWay = 0.25;        // of candidates next to each other, in radii
constexpr double SamePlace = 0.2;       // a way within a cell of the gradient's turns, in radii
constexpr double BendRadius = 0.35;     // in radii
constexpr double LargestMargin = 0.4;   // in radii
constexpr double SmallestMargin = 0.5;  // from the edge of the surface, in sampling steps

struct Arrival
{
  Vector3d place;
  bool isSettled; ///< else there is no critical point of fits close to where one of them sees it
};

/// Steps to the critical point of the fit and centers there.
Arrival iterate(CriticalModel& model, const CriticalCandidate& candidate)
{
  Arrival nowhere{ candidate.place, false };
  Vector3d place = candidate.place;
  for (int i = 0; i < MostCenters; ++i)
  {
    if (!model.center(place))
    {
      return nowhere;
    }
    const std::optional<Vector2d> uv = model.criticalPoint(1.0);
    if (!uv)
    {
      return nowhere;
    }
    const double length = uv->norm() / model.radius();
    const double most = i < MostCenters / 2 ? 1.0 : Damping;
    const Vector3d next = model.fit().lift(*uv * std::min(most, LargestStep / length));
    const double moved = (next - place).norm() / model.radius();
    if (moved <= Tolerance || (i + 1 == MostCenters && moved <= LooseTolerance))
    {
      return { next, true };
    }
    place = next;
    if ((place - candidate.place).norm() > LargestWay * candidate.reach)
    {
      return nowhere;
    }
  }
  return nowhere;
}

/// Errors of the eigenvalues of a Hessian, to first order: those of its elements in its axes.
Vector2d eigenvalueErrors(const Eigen::Matrix2d& axes, const Eigen::Matrix3d& covariance)
{
  Vector2d errors;
  for (int i = 0; i < 2; ++i)
  {
    const Vector2d axis = axes.col(i);
    const Vector3d share(axis.x() * axis.x(), 2.0 * axis.x() * axis.y(), axis.y() * axis.y());
    errors[i] = std::sqrt(share.dot(covariance * share));
  }
  return errors;
}

/// The candidate that is refined for all those next to it.
struct Nominee
{
  std::size_t candidate;
  int votes;
};

/// Those that their fits see closest to their centers; in the order of the candidates.
std::vector<Nominee> nominate(const std::vector<CriticalCandidate>& candidates)
{
  const Points places =
    placesOf(candidates, [](const CriticalCandidate& candidate) { return candidate.place; });
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      return candidates[a].offset != candidates[b].offset
        ? candidates[a].offset < candidates[b].offset
        : a < b;
    });
  const PointTree tree(places);
  std::vector<char> isTaken(candidates.size(), 0);
  std::vector<Nominee> nominees;
  Neighborhood near;
  for (const std::size_t i : order)
  {
    if (isTaken[i] == 0)
    {
      nominees.push_back({ i, 0 });
      tree.within(candidates[i].place, SameWay * candidates[i].reach, near);
      for (const Index other : near.indices)
      {
        nominees.back().votes += isTaken[other] == 0 ? 1 : 0;
        isTaken[other] = 1;
      }
    }
  }
  std::sort(nominees.begin(), nominees.end(),
    [](const Nominee& a, const Nominee& b) { return a.candidate < b.candidate; });
  return nominees;
}

std::optional<RefinedPoint> refine(CriticalModel& model, const CriticalCandidate& candidate)
{
  const Arrival arrival = iterate(model, candidate);
  std::optional<RefinedPoint> point = describePlace(model, arrival.place);
  if (!point || model.isOnPlateau())
  {
    return {};
  }
  point->isSettled = arrival.isSettled;
  const double margin = SmallestMargin * model.samplingStep() +
    std::min(point->uncertainty, LargestMargin * point->reach);
  return model.isSupported(margin) ? point : std::nullopt;
}

} // namespace

std::optional<RefinedPoint> describePlace(CriticalModel& model, const Vector3d& place)
{
  if (!model.center(place))
  {
    return {};
  }
  const LocalFit::Jet f = model.jet(Vector2d::Zero());
  const FitCovariance* covariance = model.covariance();
  if (!covariance)
  {
    return {};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(f.hessian);
  RefinedPoint point;
  point.place = model.fit().lift(Vector2d::Zero());
  point.normal = model.fit().normal(Vector2d::Zero());
  point.value = f.value;
  point.reach = model.radius();
  const Vector2d slope = model.fit().heightSlope(Vector2d::Zero()).gradient;
  point.residual = model.fit().tangentialGradient(f.gradient, slope).norm();
  point.curvature = axes.eigenvalues();
  const Vector2d errors = eigenvalueErrors(axes.eigenvectors(), covariance->ofHessianAtCenter());
  const double rounding = 1e-13 / (point.reach * point.reach);
  point.significance = point.curvature.cwiseAbs().array() / (errors.array() + rounding);
  if (point.significance[0] > point.significance[1])
  {
    std::swap(point.significance[0], point.significance[1]);
  }
  point.bend = 0.0;
  for (const Vector2d& axis : { Vector2d(1, 0), Vector2d(-1, 0), Vector2d(0, 1), Vector2d(0, -1) })
  {
    const Eigen::Matrix2d there = model.jet(BendRadius * point.reach * axis).hessian;
    point.bend = std::max(point.bend, (there - f.hessian).norm());
  }
  const Eigen::Matrix2d inverse = f.hessian.inverse();
  const double spread =
    (inverse * covariance->ofGradient(Vector2d::Zero()) * inverse.transpose()).trace();
  point.uncertainty = std::isfinite(spread) ? std::sqrt(spread) : point.reach;
  return point;
}

std::optional<RefinedPoint> refinePlace(CriticalModel& model, const Vector3d& place, double reach)
{
  const Arrival arrival = iterate(model, { place, reach, 0.0 });
  const bool isNext = (arrival.place - place).norm() <= SamePlace * reach;
  if (!arrival.isSettled || !isNext)
  {
    return {};
  }
  const std::optional<RefinedPoint> point = describePlace(model, arrival.place);
  return model.isOnPlateau() ? std::nullopt : point;
}

std::vector<RefinedPoint> refineCandidates(const std::vector<CriticalCandidate>& candidates,
  const CriticalScale& scale, const Execution& execution)
{
  const std::vector<Nominee> nominees = nominate(candidates);
  std::vector<std::optional<RefinedPoint>> refined(nominees.size());
  parallelForEach(nominees.size(), execution,
    [&](std::size_t i, const Poll&)
    {
      CriticalModel model(scale);
      refined[i] = refine(model, candidates[nominees[i].candidate]);
      if (refined[i])
      {
        refined[i]->votes = nominees[i].votes;
      }
    });
  std::vector<RefinedPoint> points;
  for (const std::optional<RefinedPoint>& point : refined)
  {
    if (point)
    {
      points.push_back(*point);
    }
  }
  return points;
}

} // namespace SurfaceScalars
