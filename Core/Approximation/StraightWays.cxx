#include "StraightWays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

// Shares of the distance and of an edge by which the front may be too large: with less, ways on
// stretched triangles are lost.
constexpr double Doubt = 0.05;
constexpr double EdgeDoubt = 0.25;

double cross(const Vector2d& a, const Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Where a direction meets an edge, 0 to 1.
double parameterOf(const Vector2d& direction, const Vector2d& from, const Vector2d& edge)
{
  const double parameter = -cross(direction, from) / cross(direction, edge);
  return parameter > 0.0 ? std::min(parameter, 1.0) : 0.0; // 0 if they are parallel
}

} // namespace

StraightWays::StraightWays(
  const MeshTopology& mesh, const LevelCurve& curve, const MeshFront& front, std::size_t mostViews)
  : mesh_(mesh)
  , curve_(curve)
  , front_(front)
  , viewsLeft_(mostViews)
{
}

template <class Visit>
void StraightWays::forEachOpposite(Index a, Index b, const Visit& visit) const
{
  const VertexRange path = this->mesh_.linkPath(a);
  for (const Index* next = path.first + 1; next != path.last; ++next)
  {
    if (next[-1] == b)
    {
      visit(*next);
    }
    else if (*next == b)
    {
      visit(next[-1]);
    }
  }
}

Vector2d StraightWays::placeBeyond(const View& view, Index corner) const
{
  const Vector3d origin = this->curve_.vertices.col(view.left);
  const Vector3d edge = this->curve_.vertices.col(view.right) - origin;
  const Vector3d way = this->curve_.vertices.col(corner) - origin;
  const double scale = 1.0 / edge.squaredNorm();
  const double along = scale * way.dot(edge);
  const double height = std::sqrt(scale * (way - along * edge).squaredNorm());
  const Vector2d flat = view.rightPlace - view.leftPlace;
  return view.leftPlace + along * flat + height * Vector2d(-flat.y(), flat.x());
}

/// A lower bound of |q| and the distance of the front from q over what is seen of the edge.
double StraightWays::boundOf(const View& view) const
{
  const Vector2d edge = view.rightPlace - view.leftPlace;
  const double length = edge.norm();
  double left = this->front_.distance(view.left);
  double right = this->front_.distance(view.right);
  const bool isCrossed = this->curve_.isAbove(view.left) != this->curve_.isAbove(view.right);
  left = isCrossed ? 0.0 : std::isfinite(left) ? left : right;
  right = isCrossed ? 0.0 : std::isfinite(right) ? right : left;
  const double slope = std::clamp((1.0 - Doubt) * (right - left) / length, -1.0, 1.0);
  const double along = -view.leftPlace.dot(edge) / length;
  const double height = std::abs(cross(view.leftPlace, edge)) / length;
  const double best = along - height * slope / std::sqrt(1.0 - slope * slope);
  const double first = parameterOf(view.leftmost, view.leftPlace, edge) * length;
  const double last = parameterOf(view.rightmost, view.leftPlace, edge) * length;
  const double at = best > first ? std::min(best, last) : first;
  const double beyond = (1.0 - Doubt) * left + slope * at - EdgeDoubt * length;
  return std::sqrt((at - along) * (at - along) + height * height) + std::max(0.0, beyond);
}

void StraightWays::push(const View& view)
{
  if (view.bound < this->shortest_)
  {
    this->views_.push_back(view);
  }
}

/// The way to what is seen of the curve in the triangle beyond the edge.
void StraightWays::meet(const View& view, Index corner, const Vector2d& place)
{
  const std::array<Index, 3> corners{ view.left, view.right, corner };
  const auto placeOf = [&](Index vertex) -> const Vector2d& {
    return vertex == view.left ? view.leftPlace : vertex == view.right ? view.rightPlace : place;
  };
  const auto ends = this->curve_.aloneFirst(corners);
  const auto end = [&](Index other) -> Vector2d
  {
    const Vector2d& from = placeOf(ends[0]);
    const double value = this->curve_.values[ends[0]];
    const double parameter = (this->curve_.isoValue - value) / (this->curve_.values[other] - value);
    return from + parameter * (placeOf(other) - from);
  };
  const Vector2d from = end(ends[1]);
  const Vector2d way = end(ends[2]) - from;
  double first = 0.0;
  double last = 1.0;
  // Left of the rightmost and right of the leftmost direction.
  for (const Vector2d& normal : { Vector2d(-view.rightmost.y(), view.rightmost.x()),
         Vector2d(view.leftmost.y(), -view.leftmost.x()) })
  {
    const double at = normal.dot(from);
    const double change = normal.dot(way);
    if (change > 0.0)
    {
      first = std::max(first, -at / change);
    }
    else if (change < 0.0)
    {
      last = std::min(last, -at / change);
    }
    else if (at < 0.0)
    {
      return;
    }
  }
  if (first <= last)
  {
    const double squared = way.squaredNorm();
    const double nearest =
      squared > 0.0 ? std::clamp(-from.dot(way) / squared, first, last) : first;
    const double length = (from + nearest * way).norm();
    if (length < this->shortest_)
    {
      this->shortest_ = length;
      this->isFound_ = true;
    }
  }
}

/// From the triangle beyond the edge, to the edges of its corner.
void StraightWays::passInto(const View& view, Index corner)
{
  const Vector2d place = this->placeBeyond(view, corner);
  if (this->curve_.meets(std::array<Index, 3>{ view.left, view.right, corner }))
  {
    this->meet(view, corner, place);
  }
  View left = view;
  left.behind = view.right;
  left.right = corner;
  left.rightPlace = place;
  View right = view;
  right.behind = view.left;
  right.left = corner;
  right.leftPlace = place;
  const bool isLeftSeen = cross(view.rightmost, place) > 0.0;
  const bool isRightSeen = cross(place, view.leftmost) > 0.0;
  if (isLeftSeen && isRightSeen)
  {
    left.rightmost = place;
    right.leftmost = place;
  }
  left.bound = isRightSeen ? this->boundOf(left) : this->shortest_;
  right.bound = isLeftSeen ? this->boundOf(right) : this->shortest_;
  const bool isLeftBetter = left.bound < right.bound;
  this->push(isLeftBetter ? right : left);
  this->push(isLeftBetter ? left : right); // followed first
}

void StraightWays::pass(const View& view)
{
  this->forEachOpposite(view.left, view.right,
    [&](Index corner)
    {
      if (corner != view.behind)
      {
        this->passInto(view, corner);
      }
    });
}

double StraightWays::shortest(const Vector3d& place, Index a, Index b, double bound)
{
  this->shortest_ = bound;
  this->isFound_ = false;
  const Vector2d toA(-(this->curve_.vertices.col(a) - place).norm(), 0.0);
  const Vector2d toB((this->curve_.vertices.col(b) - place).norm(), 0.0);
  const View ahead{ a, b, a, toA, toB, Vector2d(-1.0, 0.0), Vector2d(1.0, 0.0), 0.0 };
  this->forEachOpposite(a, b, [&](Index corner) { this->passInto(ahead, corner); });
  for (; !this->views_.empty() && this->viewsLeft_ > 0; --this->viewsLeft_)
  {
    const View view = this->views_.back();
    this->views_.pop_back();
    if (view.bound < this->shortest_)
    {
      this->pass(view);
    }
  }
  this->views_.clear();
  return this->isFound_ ? this->shortest_ : std::numeric_limits<double>::infinity();
}

} // namespace SurfaceScalars
