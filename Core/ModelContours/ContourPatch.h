#pragma once

#include "LevelBound.h"
#include "Triangles.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace SurfaceScalars
{

/// The part of a mesh in which a level set is looked for, its triangles cut into pieces.
struct PatchVertex
{
  static constexpr Index None = std::numeric_limits<Index>::max();

  Vector3d place;
  Index meshVertex = None; ///< the vertex of the mesh it is
  Index node = None;       ///< of the curves: set for saddles of the level, where branches meet
  double height = 0.0;     ///< u - level
  Vector3d gradient = Vector3d::Zero(); ///< of u
};

struct PatchPiece
{
  std::array<Index, 3> corners{}; ///< patch vertices, round as those of the triangle
  Index triangle = 0;             ///< of the mesh
  int halvings = 0;               ///< of its area, two for each time it was cut in four
  double deviation = 0.0;         ///< of the segment in it from the level set, length
  bool isExamined = false;
  bool isClear = false;       ///< of the level set but for what crosses its edges
  bool isSettled = false;     ///< need not be cut
  bool mayBeCritical = false; ///< of the level
};

struct PatchEdge
{
  Index midpoint = PatchVertex::None; ///< the vertex in its middle, if it was cut
  Index node = PatchVertex::None;     ///< where the level set crosses it
};

/// A piece of the level set between two nodes: larger values to its left, seen against the normal.
struct PatchSegment
{
  Index from;
  Index to;
};

/**
 * Pieces of triangles that meet edge to edge, and where a level set crosses their edges. An edge is
 * crossed if u < level at one end and u >= level at the other; at a saddle of the level, which is a
 * vertex, curves pass through the vertex and its edges are not crossed.
 */
class ContourPatch
{
public:
  using EdgeKey = std::uint64_t;

  /// @param triangles which of the mesh
  ContourPatch(
    const Points& meshVertices, const Triangles& mesh, const std::vector<Index>& triangles);

  static EdgeKey keyOf(Index a, Index b)
  {
    return a < b ? EdgeKey{ a } << 32 | b : EdgeKey{ b } << 32 | a;
  }
  static std::array<Index, 2> endsOf(EdgeKey key)
  {
    return { static_cast<Index>(key >> 32), static_cast<Index>(key) };
  }
  static EdgeKey sideOf(const PatchPiece& piece, std::size_t i)
  {
    return keyOf(piece.corners[i], piece.corners[(i + 1) % 3]);
  }

  Index addVertex(const Vector3d& place);
  Index addNode(const Vector3d& place);
  /// Makes a vertex a saddle of the level: its height is 0.
  void pin(Index vertex);

  bool hasSaddles() const;
  bool isCrossed(EdgeKey key) const;
  std::optional<PatchSegment> segment(const PatchPiece& piece) const;
  Ball ballAround(const PatchPiece& piece) const;
  Vector3d normal(const PatchPiece& piece) const; ///< unit; 0 for a piece without area

  /// Cuts all pieces at the edges that have midpoints, into two to four, edge to edge.
  void cut();
  /// Takes away the pieces of which u is not defined at a corner. @returns how many
  std::size_t dropUndefined();

  std::vector<PatchVertex> vertices;
  std::vector<PatchPiece> pieces;
  std::vector<Vector3d> nodes;
  std::unordered_map<EdgeKey, PatchEdge> edges; ///< those that have a midpoint or were crossed

private:
  void cut(const PatchPiece& piece, std::vector<PatchPiece>& result) const;
};

} // namespace SurfaceScalars
