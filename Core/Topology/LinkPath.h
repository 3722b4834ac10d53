#pragma once

#include "Basics.h"

#include <cstdint>
#include <vector>

namespace SurfaceScalars
{

/// An edge of the link of a vertex, opposite to it in a triangle.
struct LinkEdge
{
  Index from;
  Index to;
};

enum class LinkShape
{
  Path,  ///< of a vertex on the boundary
  Cycle, ///< of an interior vertex
  Branching,
  Separate ///< several paths or cycles
};

/// Puts the edges of a link in order. Keeps its arrays from one link to the next.
class LinkPath
{
public:
  /// @param edges at least one. @returns Path or Cycle if vertices() is the link
  LinkShape follow(const std::vector<LinkEdge>& edges);

  /// Along the edges, in the direction of the first of them; a cycle comes back to where it begins.
  const std::vector<Index>& vertices() const { return this->vertices_; }

  /// Where the link branches.
  Index branching() const { return this->branching_; }

private:
  LinkShape joinEnds(const std::vector<LinkEdge>& edges);

  std::vector<std::uint64_t> ends_; ///< vertex and end, sorted by vertex
  std::vector<Index> partners_;     ///< of the ends 2e and 2e + 1 of edge e: another end there
  std::vector<Index> vertices_;
  Index branching_ = 0;
  Index loose_ = 0; ///< an end without partner
};

} // namespace SurfaceScalars
