#include "PatchStars.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace SurfaceScalars
{
namespace
{

constexpr double SnapFraction = 1e-9; // of a triangle: a place that close to a side lies on it

/// Barycentric coordinates of the place's projection.
Vector3d weightsAt(const ContourPatch& patch, const PatchPiece& piece, const Vector3d& place)
{
  const auto& [a, b, c] = piece.corners;
  const Vector3d& origin = patch.vertices[a].place;
  Eigen::Matrix<double, 3, 2> sides;
  sides << patch.vertices[b].place - origin, patch.vertices[c].place - origin;
  const Vector2d weights = sides.colPivHouseholderQr().solve(place - origin);
  return { 1.0 - weights.sum(), weights[0], weights[1] };
}

} // namespace

std::optional<Index> insertVertex(ContourPatch& patch, const PatchPlace& at)
{
  std::size_t index = 0;
  Vector3d weights = Vector3d::Constant(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < patch.pieces.size(); ++i)
  {
    if (patch.pieces[i].triangle == at.triangle)
    {
      const Vector3d here = weightsAt(patch, patch.pieces[i], at.place);
      if (here.minCoeff() > weights.minCoeff())
      {
        index = i;
        weights = here;
      }
    }
  }
  if (!(weights.minCoeff() >= -SnapFraction))
  {
    return {};
  }
  const PatchPiece piece = patch.pieces[index];
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (weights[static_cast<Eigen::Index>(i)] >= 1.0 - 2.0 * SnapFraction)
    {
      return piece.corners[i];
    }
  }
  const Index added = patch.addVertex(at.place);
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (weights[static_cast<Eigen::Index>((i + 2) % 3)] <= SnapFraction)
    {
      patch.edges[ContourPatch::sideOf(piece, i)].midpoint = added;
      patch.cut();
      return added;
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    PatchPiece part = piece;
    part.corners = { piece.corners[i], piece.corners[(i + 1) % 3], added };
    patch.pieces.push_back(part);
  }
  patch.pieces.erase(patch.pieces.begin() + static_cast<std::ptrdiff_t>(index));
  return added;
}

std::vector<PatchStar> starsOf(const ContourPatch& patch, const std::vector<Index>& centers)
{
  std::unordered_map<Index, std::size_t> positions;
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    positions.emplace(centers[i], i);
  }
  std::vector<PatchStar> stars(centers.size());
  for (std::size_t i = 0; i < patch.pieces.size(); ++i)
  {
    for (const Index corner : patch.pieces[i].corners)
    {
      const auto found = positions.find(corner);
      if (found != positions.end())
      {
        stars[found->second].push_back(i);
      }
    }
  }
  return stars;
}

std::vector<Index> linkOf(const ContourPatch& patch, Index vertex, const PatchStar& star)
{
  std::vector<std::array<Index, 2>> sides; // opposite to the vertex
  for (const std::size_t i : star)
  {
    const std::array<Index, 3>& corners = patch.pieces[i].corners;
    const auto at =
      static_cast<std::size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
    sides.push_back({ corners[(at + 1) % 3], corners[(at + 2) % 3] });
  }
  std::vector<Index> path;
  while (!sides.empty())
  {
    const auto next = path.empty()
      ? sides.begin()
      : std::find_if(sides.begin(), sides.end(),
          [&](const auto& side) { return side[0] == path.back() || side[1] == path.back(); });
    if (next == sides.end())
    {
      return {};
    }
    path.push_back(path.empty() || (*next)[0] == path.back() ? (*next)[1] : (*next)[0]);
    if (path.size() == 1)
    {
      path.insert(path.begin(), (*next)[0]);
    }
    sides.erase(next);
  }
  if (path.size() < 4 || path.front() != path.back())
  {
    return {};
  }
  path.pop_back();
  return path;
}

} // namespace SurfaceScalars
