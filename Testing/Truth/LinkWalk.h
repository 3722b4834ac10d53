#pragma once

#include "CriticalPoint.h"
#include "TriangleMesh.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/// The neighbors of a vertex in the order in which they lie around it.
struct OrderedLink
{
  std::vector<int> vertices;
  bool isClosed; ///< the last is next to the first
};

/// Of every vertex, by walking from neighbor to neighbor. @throws std::runtime_error unless there
/// is one way around
std::vector<OrderedLink> orderedLinks(const TriangleMesh& mesh);

struct VertexType
{
  CriticalType type;
  int multiplicity; ///< of saddles, 1 of extrema, 0 of regular vertices

  bool operator==(const VertexType& other) const
  {
    return this->type == other.type && this->multiplicity == other.multiplicity;
  }
};

/// What the vertices are to f, by the changes of sign of f(neighbor) - f(vertex), ties by index,
/// around their links; at the boundary there and back.
std::vector<VertexType> typesByWalking(
  const std::vector<OrderedLink>& links, const ValuesRef& values);

} // namespace SurfaceScalars::Truth
