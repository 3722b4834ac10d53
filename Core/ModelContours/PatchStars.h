#pragma once

#include "ContourPatch.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// A place on a triangle of the mesh.
struct PatchPlace
{
  Index triangle;
  Vector3d place;
};

/// Cuts the piece in which a place lies into three, or where it lies on a side, the pieces beside
/// that into two. @returns the vertex there; none if the place is not on the triangle
std::optional<Index> insertVertex(ContourPatch& patch, const PatchPlace& at);

/// Indices of the pieces around a vertex.
using PatchStar = std::vector<std::size_t>;

/// The stars of these vertices, in their order.
std::vector<PatchStar> starsOf(const ContourPatch& patch, const std::vector<Index>& centers);

/// The vertices around an inner one, in cyclic order; empty if it is not an inner one with one fan
/// of pieces.
std::vector<Index> linkOf(const ContourPatch& patch, Index vertex, const PatchStar& star);

} // namespace SurfaceScalars
