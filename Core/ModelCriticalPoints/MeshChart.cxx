#include "MeshChart.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace SurfaceScalars
{
namespace
{

double cross(const Vector2d& a, const Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace

MeshChart::MeshChart(const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values)
  : vertices_(vertices)
  , mesh_(mesh)
  , values_(values)
{
}

/// At least `count` vertices, if the component has them, and the ring around these.
void MeshChart::gather(Index vertex, std::size_t count)
{
  this->gathered_.assign(1, vertex);
  std::unordered_set<Index> known{ vertex };
  std::size_t ringBegin = 0;
  for (bool isLast = false; ringBegin < this->gathered_.size();)
  {
    const std::size_t ringEnd = this->gathered_.size();
    for (; ringBegin < ringEnd; ++ringBegin)
    {
      for (const Index neighbor : this->mesh_.link(this->gathered_[ringBegin]))
      {
        if (known.insert(neighbor).second)
        {
          this->gathered_.push_back(neighbor);
        }
      }
    }
    if (isLast)
    {
      return;
    }
    isLast = this->gathered_.size() >= count;
  }
}

bool MeshChart::fitTo(Index vertex, std::size_t count, int degree, LocalFit& fit)
{
  this->gather(vertex, count);
  this->samples_.points = this->vertices_(Eigen::all, this->gathered_);
  this->samples_.values = this->values_(this->gathered_);
  this->samples_.weights =
    (this->samples_.points.colwise() - this->vertices_.col(vertex)).colwise().squaredNorm();
  std::vector<double> squares(this->samples_.weights.begin(), this->samples_.weights.end());
  const std::size_t last = std::min(count, squares.size() - 1);
  std::nth_element(
    squares.begin(), squares.begin() + static_cast<std::ptrdiff_t>(last), squares.end());
  const double radius = std::sqrt(squares[last]);
  this->samples_.weights =
    (1.0 - this->samples_.weights.array() / (radius * radius)).max(0.0).square();
  return fit.compute(this->vertices_.col(vertex), this->samples_, radius, degree);
}

bool MeshChart::center(Index vertex)
{
  this->order_.clear();
  this->rank_ = 0;
  std::size_t next = 0;
  for (int degree = LocalFit::MaximumDegree; degree >= LowestDegree; --degree)
  {
    for (const double share : VerticesPerTerm)
    {
      const double count = share * LocalFit::termCount(degree);
      LocalFit& fit = this->fits_[next];
      if (this->fitTo(vertex, static_cast<std::size_t>(count), degree, fit))
      {
        const double error = fit.heightDeviation(this->samples_) / (fit.scale() * std::sqrt(count));
        if (std::isfinite(error))
        {
          this->order_.emplace_back(error, next);
        }
      }
      ++next;
    }
  }
  std::sort(this->order_.begin(), this->order_.end());
  if (this->order_.empty())
  {
    if (!this->fitTo(vertex, LocalFit::termCount(LowestDegree), 1, this->fits_[0]))
    {
      return false;
    }
    this->order_.emplace_back(0.0, 0);
  }
  this->vertex_ = vertex;
  const VertexRange link = this->mesh_.link(vertex);
  this->spacing_ = 0.0;
  for (const Index neighbor : link)
  {
    this->spacing_ +=
      (this->vertices_.col(neighbor) - this->vertices_.col(vertex)).norm() / link.size();
  }
  return true;
}

Index MeshChart::nearestVertex(const Vector3d& place) const
{
  Index nearest = this->vertex_;
  double least = (this->vertices_.col(nearest) - place).squaredNorm();
  for (Index before = nearest;; before = nearest)
  {
    for (const Index neighbor : this->mesh_.link(before))
    {
      const double square = (this->vertices_.col(neighbor) - place).squaredNorm();
      if (square < least)
      {
        least = square;
        nearest = neighbor;
      }
    }
    if (nearest == before)
    {
      return nearest;
    }
  }
}

bool MeshChart::covers(const Vector3d& place) const
{
  const Index nearest = this->nearestVertex(place);
  if (!this->mesh_.isBoundary(nearest))
  {
    return true;
  }
  // Whether the direction to the place is between those of two neighbors in a row.
  const auto directionTo = [&](const Vector3d& p) -> Vector2d
  { return this->fit().flatten(p) - this->fit().flatten(this->vertices_.col(nearest)); };
  const Vector2d direction = directionTo(place);
  const VertexRange path = this->mesh_.linkPath(nearest);
  for (const Index* corner = path.begin(); corner + 1 != path.end(); ++corner)
  {
    const Vector2d one = directionTo(this->vertices_.col(corner[0]));
    const Vector2d other = directionTo(this->vertices_.col(corner[1]));
    const double turn = cross(one, other);
    if (cross(one, direction) * turn >= 0.0 && cross(direction, other) * turn >= 0.0)
    {
      return true;
    }
  }
  return false;
}

} // namespace SurfaceScalars
