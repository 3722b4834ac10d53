#pragma once

#include "GhostMarks.h"
#include "MeshCriticalPoints.h"
#include "ModelCriticalPoints.h"
#include "SurfaceVertices.h"

#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <vector>

/// Which critical points, and pairs of them, a piece of a mesh lists.
namespace SurfaceScalars
{

inline std::size_t vertexOf(const CriticalPoint& point)
{
  return point.input;
}

inline std::size_t vertexOf(const ModelCriticalPoint& point)
{
  return point.origin;
}

/// The pairs both of whose points are left. @param all by vertex, as are the points left
template <class Point>
std::vector<CriticalPair> pairsAmong(
  const std::vector<Point>& left, const MeshCriticalPoints& all, double threshold)
{
  const auto positionOf = [&](std::size_t index)
  {
    const std::size_t vertex = all.points[index].input;
    const auto found = std::lower_bound(left.begin(), left.end(), vertex,
      [](const Point& point, std::size_t wanted) { return vertexOf(point) < wanted; });
    const bool isThere = found != left.end() && vertexOf(*found) == vertex;
    return isThere ? static_cast<std::size_t>(found - left.begin()) : left.size();
  };
  std::vector<CriticalPair> pairs;
  for (const CriticalPair& pair : all.pairs)
  {
    const CriticalPair renamed{ positionOf(pair.extremum), positionOf(pair.saddle),
      pair.persistence };
    if (pair.persistence >= threshold && renamed.extremum < left.size() &&
      renamed.saddle < left.size())
    {
      pairs.push_back(renamed);
    }
  }
  return pairs;
}

/// Which vertices another piece of the mesh lists.
class OtherVertices
{
public:
  OtherVertices(vtkPolyData* input, const VertexMap& map)
    : marks_(GhostMarks::ofPoints(input))
    , map_(map)
  {
  }

  template <class Point>
  bool have(const Point& point) const
  {
    return this->marks_.have(
      this->map_.pointOfVertex[vertexOf(point)], vtkDataSetAttributes::DUPLICATEPOINT);
  }

  template <class Point>
  void removeFrom(std::vector<Point>& points) const
  {
    points.erase(std::remove_if(points.begin(), points.end(),
                   [this](const Point& point) { return this->have(point); }),
      points.end());
  }

  /// Lets them count nothing.
  MeshCriticalPoints without(MeshCriticalPoints all) const
  {
    all.pairs.erase(
      std::remove_if(all.pairs.begin(), all.pairs.end(),
        [&](const CriticalPair& pair) { return this->have(all.points[pair.saddle]); }),
      all.pairs.end());
    for (CriticalPoint& point : all.points)
    {
      point.multiplicity = this->have(point) ? 0 : point.multiplicity;
    }
    return all;
  }

private:
  GhostMarks marks_;
  const VertexMap& map_;
};

} // namespace SurfaceScalars
