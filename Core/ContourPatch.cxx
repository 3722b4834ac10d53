#include "ContourPatch.h"

#include "TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double SnapFraction = 1e-9; // of a triangle: a place that close to a side lies on it

} // namespace

ContourPatch::ContourPatch(
  const Points& meshVertices, const Triangles& mesh, const std::vector<Index>& triangles)
{
  std::unordered_map<Index, Index> known;
  this->pieces.reserve(triangles.size());
  for (const Index triangle : triangles)
  {
    PatchPiece piece;
    piece.triangle = triangle;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Index meshVertex = mesh(static_cast<Eigen::Index>(i), triangle);
      const auto [found, isNew] =
        known.emplace(meshVertex, static_cast<Index>(this->vertices.size()));
      if (isNew)
      {
        this->vertices[this->addVertex(meshVertices.col(meshVertex))].meshVertex = meshVertex;
      }
      piece.corners[i] = found->second;
    }
    this->pieces.push_back(piece);
  }
}

Index ContourPatch::addVertex(const Vector3d& place)
{
  PatchVertex vertex;
  vertex.place = place;
  this->vertices.push_back(vertex);
  return static_cast<Index>(this->vertices.size() - 1);
}

Index ContourPatch::addNode(const Vector3d& place)
{
  this->nodes.push_back(place);
  return static_cast<Index>(this->nodes.size() - 1);
}

void ContourPatch::pin(Index vertex)
{
  PatchVertex& saddle = this->vertices[vertex];
  saddle.height = 0.0;
  saddle.node = this->addNode(saddle.place);
}

/// Barycentric coordinates of the place's projection.
Vector3d ContourPatch::weightsAt(const PatchPiece& piece, const Vector3d& place) const
{
  const auto& [a, b, c] = piece.corners;
  const Vector3d& origin = this->vertices[a].place;
  Eigen::Matrix<double, 3, 2> sides;
  sides << this->vertices[b].place - origin, this->vertices[c].place - origin;
  const Vector2d weights = sides.colPivHouseholderQr().solve(place - origin);
  return { 1.0 - weights.sum(), weights[0], weights[1] };
}

Index ContourPatch::insert(const PatchPlace& at)
{
  std::size_t index = 0;
  Vector3d weights = Vector3d::Constant(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < this->pieces.size(); ++i)
  {
    if (this->pieces[i].triangle == at.triangle)
    {
      const Vector3d here = this->weightsAt(this->pieces[i], at.place);
      if (here.minCoeff() > weights.minCoeff())
      {
        index = i;
        weights = here;
      }
    }
  }
  const PatchPiece piece = this->pieces[index];
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (weights[static_cast<Eigen::Index>(i)] >= 1.0 - 2.0 * SnapFraction)
    {
      return piece.corners[i];
    }
  }
  const Index added = this->addVertex(at.place);
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (weights[static_cast<Eigen::Index>((i + 2) % 3)] <= SnapFraction)
    {
      this->edges[sideOf(piece, i)].midpoint = added;
      this->cut();
      return added;
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    PatchPiece part = piece;
    part.corners = { piece.corners[i], piece.corners[(i + 1) % 3], added };
    this->pieces.push_back(part);
  }
  this->pieces.erase(this->pieces.begin() + static_cast<std::ptrdiff_t>(index));
  return added;
}

std::vector<std::vector<std::size_t>> ContourPatch::starsOf(const std::vector<Index>& centers) const
{
  std::unordered_map<Index, std::size_t> positions;
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    positions.emplace(centers[i], i);
  }
  std::vector<std::vector<std::size_t>> stars(centers.size());
  for (std::size_t i = 0; i < this->pieces.size(); ++i)
  {
    for (const Index corner : this->pieces[i].corners)
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

std::vector<Index> ContourPatch::link(Index vertex, const std::vector<std::size_t>& star) const
{
  std::vector<std::array<Index, 2>> sides; // opposite to the vertex
  for (const std::size_t i : star)
  {
    const std::array<Index, 3>& corners = this->pieces[i].corners;
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

bool ContourPatch::isCrossed(EdgeKey key) const
{
  const auto [a, b] = endsOf(key);
  const PatchVertex& from = this->vertices[a];
  const PatchVertex& to = this->vertices[b];
  return from.node == PatchVertex::None && to.node == PatchVertex::None &&
    (from.height < 0.0) != (to.height < 0.0);
}

std::optional<PatchSegment> ContourPatch::segment(const PatchPiece& piece) const
{
  const auto isAbove = [&](std::size_t i)
  { return !(this->vertices[piece.corners[i % 3]].height < 0.0); };
  const auto nodeOn = [&](std::size_t side)
  { return this->edges.at(sideOf(piece, side % 3)).node; };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Index saddle = this->vertices[piece.corners[i]].node;
    if (saddle != PatchVertex::None)
    {
      if (!this->isCrossed(sideOf(piece, (i + 1) % 3)))
      {
        return {};
      }
      const Index opposite = nodeOn(i + 1);
      return isAbove(i + 2) ? PatchSegment{ saddle, opposite } : PatchSegment{ opposite, saddle };
    }
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (isAbove(i) != isAbove(i + 1) && isAbove(i) != isAbove(i + 2))
    {
      const Index right = nodeOn(i);
      const Index left = nodeOn(i + 2);
      return isAbove(i) ? PatchSegment{ right, left } : PatchSegment{ left, right };
    }
  }
  return {};
}

Ball ContourPatch::ballAround(const PatchPiece& piece) const
{
  const auto& [a, b, c] = piece.corners;
  return SurfaceScalars::ballAround(
    this->vertices[a].place, this->vertices[b].place, this->vertices[c].place);
}

void ContourPatch::cut()
{
  std::vector<PatchPiece> result;
  result.reserve(this->pieces.size());
  for (const PatchPiece& piece : this->pieces)
  {
    this->cut(piece, result);
  }
  this->pieces = std::move(result);
}

void ContourPatch::cut(const PatchPiece& piece, std::vector<PatchPiece>& result) const
{
  std::array<Index, 3> middles{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto found = this->edges.find(sideOf(piece, i));
    middles[i] = found == this->edges.end() ? PatchVertex::None : found->second.midpoint;
    count += middles[i] != PatchVertex::None;
  }
  if (count == 0)
  {
    result.push_back(piece);
    return;
  }
  const auto add = [&](Index a, Index b, Index c)
  {
    PatchPiece part = piece;
    part.corners = { a, b, c };
    part.isExamined = part.isSettled = part.mayBeCritical = false; // isClear remains
    part.depth += count == 3;
    result.push_back(part);
  };
  // Turned so that the first side is cut, and with two the third is not.
  std::size_t first = 0;
  while (middles[first] == PatchVertex::None ||
    (count == 2 && middles[(first + 1) % 3] == PatchVertex::None))
  {
    ++first;
  }
  const auto [a, b, c] = std::array<Index, 3>{ piece.corners[first], piece.corners[(first + 1) % 3],
    piece.corners[(first + 2) % 3] };
  const Index ab = middles[first];
  const Index bc = middles[(first + 1) % 3];
  const Index ca = middles[(first + 2) % 3];
  if (count == 3)
  {
    add(a, ab, ca);
    add(ab, b, bc);
    add(ca, bc, c);
    add(ab, bc, ca);
    return;
  }
  if (count == 1)
  {
    add(a, ab, c);
    add(ab, b, c);
    return;
  }
  const auto distance = [&](Index p, Index q)
  { return (this->vertices[p].place - this->vertices[q].place).squaredNorm(); };
  add(ab, b, bc);
  if (distance(a, bc) <= distance(ab, c))
  {
    add(a, ab, bc);
    add(a, bc, c);
  }
  else
  {
    add(a, ab, c);
    add(ab, bc, c);
  }
}

std::size_t ContourPatch::dropUndefined()
{
  const auto isUndefined = [&](const PatchPiece& piece)
  {
    return std::any_of(piece.corners.begin(), piece.corners.end(),
      [&](Index corner) { return !std::isfinite(this->vertices[corner].height); });
  };
  const std::size_t before = this->pieces.size();
  this->pieces.erase(
    std::remove_if(this->pieces.begin(), this->pieces.end(), isUndefined), this->pieces.end());
  return before - this->pieces.size();
}

} // namespace SurfaceScalars
