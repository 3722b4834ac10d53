#include "MeshFront.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr char MostTurns = 2;
constexpr std::size_t MostPasses = 1 << 16; // between two polls

} // namespace

MeshFront::MeshFront(const PointsRef& vertices, const MeshTopology& mesh)
  : vertices_(vertices)
  , mesh_(mesh)
  , front_(mesh.vertexCount())
  , turns_(mesh.vertexCount(), 0)
{
}

void MeshFront::clear()
{
  for (const Index vertex : this->front_.reached())
  {
    this->turns_[vertex] = 0;
  }
  this->front_.clear();
}

double MeshFront::across(const Vector3d& place, Index a, Index b) const
{
  const double first = this->distance(a);
  const double second = this->distance(b);
  const Vector3d origin = this->vertices_.col(a);
  const Vector3d edge = this->vertices_.col(b) - origin;
  const double length = edge.norm();
  const double nearest =
    std::min(first + (place - origin).norm(), second + (place - this->vertices_.col(b)).norm());
  // The sine of the angle at which the front comes; not a number where none has come.
  const double slope = (second - first) / length;
  if (!(std::abs(slope) < 1.0))
  {
    return nearest;
  }
  const double along = (place - origin).dot(edge) / length;
  const double height = std::sqrt(std::max(0.0, (place - origin).squaredNorm() - along * along));
  const double cosine = std::sqrt(1.0 - slope * slope);
  const double crossing = along - height * slope / cosine;
  const bool isBetween = crossing > 0.0 && crossing < length;
  return isBetween ? std::min(nearest, first + slope * along + cosine * height) : nearest;
}

void MeshFront::pass(Index vertex)
{
  if (this->turns_[vertex] == MostTurns)
  {
    return;
  }
  ++this->turns_[vertex];
  const VertexRange path = this->mesh_.linkPath(vertex);
  for (const Index* next = path.first + 1; next != path.last; ++next)
  {
    this->offer(next[-1], this->across(this->vertices_.col(next[-1]), vertex, *next));
    this->offer(*next, this->across(this->vertices_.col(*next), vertex, next[-1]));
  }
}

void MeshFront::reach(const std::vector<Index>& targets, const Poll& poll)
{
  const std::size_t passes = std::min(targets.size() + 1, MostPasses);
  while (true)
  {
    poll();
    double farthest = 0.0;
    for (const Index target : targets)
    {
      farthest = std::max(farthest, this->distance(target));
    }
    for (std::size_t i = 0; i < passes; ++i)
    {
      Index vertex = 0;
      if (!this->front_.pass(vertex) || this->distance(vertex) > farthest)
      {
        return;
      }
      this->pass(vertex);
    }
  }
}

} // namespace SurfaceScalars
