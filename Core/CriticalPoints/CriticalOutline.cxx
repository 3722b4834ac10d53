#include "CriticalOutline.h"

#include "CriticalTurns.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// In radii of the fits.
constexpr std::array<double, 6> Margins{ 0.25, 0.35, 0.5, 0.7, 1.0, 1.4 }; // of ellipses
constexpr double LargestHalfAxis = 4.0; // a row may go round the whole surface

// In radii of the ellipse.
constexpr double Inside = 0.85;
constexpr double Outside = 1.15;

/// A box around places, seen along the normal of the surface.
struct Box
{
  Vector3d center;
  Vector3d normal;
  Eigen::Matrix<double, 3, 2> axes; ///< unit; the first one is that of the row
  Vector2d halfWidths;
  double reach; ///< of the fits

  Vector2d flatten(const RefinedPoint& point) const
  {
    return this->axes.transpose() * (point.place - this->center);
  }
};

Box boxAround(const PlaceList& group)
{
  Box box{ Vector3d::Zero(), Vector3d::Zero(), {}, Vector2d::Zero(), 0.0 };
  for (const RefinedPoint* point : group)
  {
    box.center += point->place / static_cast<double>(group.size());
    box.normal += box.normal.dot(point->normal) < 0.0 ? Vector3d(-point->normal) : point->normal;
    box.reach = std::max(box.reach, point->reach);
  }
  box.normal.normalize();
  box.axes.col(0) = box.normal.unitOrthogonal();
  box.axes.col(1) = box.normal.cross(box.axes.col(0));
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const RefinedPoint* point : group)
  {
    spread += box.flatten(*point) * box.flatten(*point).transpose();
  }
  box.axes.col(0) =
    (box.axes * Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(1))
      .eval();
  box.axes.col(1) = box.normal.cross(box.axes.col(0));
  Vector2d low = Vector2d::Zero();
  Vector2d high = Vector2d::Zero();
  for (const RefinedPoint* point : group)
  {
    low = low.cwiseMin(box.flatten(*point));
    high = high.cwiseMax(box.flatten(*point));
  }
  box.center += 0.5 * box.axes * (low + high);
  box.halfWidths = 0.5 * (high - low);
  return box;
}

/// In radii of an ellipse with these half axes.
double distance(const Box& box, const Vector2d& halfAxes, const RefinedPoint& point)
{
  return box.flatten(point).cwiseQuotient(halfAxes).norm();
}

/// Of an ellipse with all places well inside.
Vector2d halfAxesAround(const Box& box, const PlaceList& group, double margin)
{
  const Vector2d halfAxes = box.halfWidths + Vector2d::Constant(margin * box.reach);
  double farthest = Inside;
  for (const RefinedPoint* point : group)
  {
    farthest = std::max(farthest, distance(box, halfAxes, *point));
  }
  return halfAxes * (farthest / Inside);
}

} // namespace

std::optional<int> indexAround(
  CriticalModel& model, const PlaceList& group, const PlaceList& others)
{
  const Box box = boxAround(group);
  std::optional<int> result;
  double clearness = 0.0;
  for (const double margin : Margins)
  {
    const Vector2d halfAxes = halfAxesAround(box, group, margin);
    const auto isIn = [&](const RefinedPoint* point)
    {
      // What is farther away in space is on another sheet.
      return (point->place - box.center).norm() <= Outside * halfAxes.maxCoeff() &&
        distance(box, halfAxes, *point) <= Outside;
    };
    if (halfAxes.maxCoeff() > LargestHalfAxis * box.reach ||
      std::any_of(others.begin(), others.end(), isIn))
    {
      break;
    }
    const std::optional<ClearIndex> index =
      indexWithin(model, Ellipse{ box.center, box.normal, box.axes * halfAxes.asDiagonal() });
    if (index && index->clearness > clearness)
    {
      result = index->index;
      clearness = index->clearness;
    }
  }
  return result;
}

} // namespace SurfaceScalars
