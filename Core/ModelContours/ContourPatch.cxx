#include "ContourPatch.h"

#include "TriangleSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
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

bool ContourPatch::hasSaddles() const
{
  return std::any_of(this->vertices.begin(), this->vertices.end(),
    [](const PatchVertex& vertex) { return vertex.node != PatchVertex::None; });
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

Vector3d ContourPatch::normal(const PatchPiece& piece) const
{
  const auto& [a, b, c] = piece.corners;
  const Vector3d side = this->vertices[b].place - this->vertices[a].place;
  const Vector3d other = this->vertices[c].place - this->vertices[a].place;
  const Vector3d across = side.cross(other);
  const double norm = across.norm();
  return norm > 1e-12 * side.norm() * other.norm() ? Vector3d(across / norm) : Vector3d::Zero();
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
    part.halvings += count == 3 ? 2 : 1;
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
