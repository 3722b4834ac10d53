#include "NearestVertices.h"

#include "NumberText.h"
#include "PointTree.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace SurfaceScalars
{
namespace
{

/// Of the bounding box's diagonal, if no distance is given.
constexpr double DiagonalShare = 0.05;
constexpr double Smallest = 1e-150; // length whose square is no zero

double diagonalOf(const Points& vertices)
{
  return (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).norm();
}

double longestEdge(const Points& vertices, const MeshTopology& mesh, Index vertex)
{
  double longest = 0.0;
  for (const Index neighbor : mesh.link(vertex))
  {
    longest = std::max(longest, (vertices.col(neighbor) - vertices.col(vertex)).norm());
  }
  return longest;
}

/// The first of the vertices that are nearest.
Index nearestVertex(const PointTree& tree, const Points& vertices, const Vector3d& place)
{
  const auto squaredDistance = [&](Index vertex)
  { return (vertices.col(vertex) - place).squaredNorm(); };
  if (!std::isfinite(squaredDistance(0)))
  {
    return 0; // so far away that none is nearer
  }
  Neighborhood found;
  tree.nearest(place, 1, found);
  const double least = squaredDistance(found.indices.front());
  tree.within(place, std::sqrt(least) * (1.0 + 1e-9) + Smallest, found); // it rounds otherwise
  Index nearest = std::numeric_limits<Index>::max();
  for (const Index vertex : found.indices)
  {
    nearest = squaredDistance(vertex) <= least ? std::min(nearest, vertex) : nearest;
  }
  return nearest;
}

} // namespace

std::vector<Index> nearestVertices(const Points& vertices, const MeshTopology& mesh,
  const PointsRef& places, double maximumDistance, const PlaceName& nameOf,
  const VertexName& nameOfVertices)
{
  require(std::isfinite(maximumDistance) && maximumDistance >= 0.0,
    "a maximum distance of at least 0", textOf(maximumDistance), "Choose 0 for an automatic one.");
  const PointTree tree(vertices);
  const double share = DiagonalShare * diagonalOf(vertices);
  std::vector<Index> result;
  std::unordered_map<Index, std::size_t> takenBy;
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    const auto place = static_cast<std::size_t>(i);
    const std::string name = nameOfPlace(place, nameOf);
    require(places.col(i).allFinite(), "critical points with finite coordinates",
      "a NaN or infinite one of " + name, "Correct or remove it.");
    const Index vertex = nearestVertex(tree, vertices, places.col(i));
    const double distance = (vertices.col(vertex) - places.col(i)).stableNorm();
    const double most = maximumDistance > 0.0
      ? maximumDistance
      : std::max(share, longestEdge(vertices, mesh, vertex));
    require(distance <= most, "critical points at most " + textOf(most) + " from a vertex",
      name + " at a distance of " + textOf(distance), "Move it, or raise the maximum distance.");
    const auto [taken, isFree] = takenBy.emplace(vertex, place);
    require(isFree, "critical points at different vertices",
      nameOfPlace(taken->second, nameOf) + " and " + name + " both next to vertex " +
        std::to_string(nameOfVertex(vertex, nameOfVertices)),
      "Move or remove one of them.");
    result.push_back(vertex);
  }
  return result;
}

} // namespace SurfaceScalars
