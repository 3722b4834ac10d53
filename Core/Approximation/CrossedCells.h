#pragma once

#include "Execution.h"
#include "Simplices.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// For each value how many of the ascending levels are not above it. A cell crosses the levels from
/// the least rank of its corners to before the greatest: f < level is below, f >= level is above.
std::vector<Index> ranksAmong(
  const ValuesRef& levels, const ValuesRef& values, const Execution& execution);

/// The ranks of the corners of a cell.
struct RankRange
{
  Index first;
  Index last;

  bool crosses(Index level) const { return this->first <= level && level < this->last; }
};

template <class Corners>
RankRange rankRange(const std::vector<Index>& ranks, const Corners& corners)
{
  RankRange range{ ranks[corners[0]], ranks[corners[0]] };
  for (decltype(corners.size()) i = 1; i < corners.size(); ++i)
  {
    const Index rank = ranks[corners[i]];
    range.first = rank < range.first ? rank : range.first;
    range.last = rank > range.last ? rank : range.last;
  }
  return range;
}

/// How many of the cells cross each of the levels.
std::vector<std::size_t> crossingCounts(
  const SimplicesRef& cells, const std::vector<Index>& ranks, Index levelCount);

/// Which cells (edges, triangles) cross each of some consecutive levels.
class CrossedCells
{
public:
  /// @param begin the first level @param end one past the last
  CrossedCells(const SimplicesRef& cells, const std::vector<Index>& ranks, Index begin, Index end);

  /// Indices of cells.
  struct Range
  {
    const Index* first;
    const Index* last;

    const Index* begin() const { return this->first; }
    const Index* end() const { return this->last; }
    std::size_t size() const { return static_cast<std::size_t>(this->last - this->first); }
  };
  Range of(Index level) const
  {
    const std::size_t* start = this->starts_.data() + (level - this->begin_);
    return { this->cells_.data() + start[0], this->cells_.data() + start[1] };
  }

private:
  Index begin_;
  std::vector<std::size_t> starts_; ///< of each level in cells_, and the end
  std::vector<Index> cells_;
};

/// The place between two vertices at which f, linear, has a value that lies between theirs.
inline Vector3d crossingOf(
  const PointsRef& vertices, const ValuesRef& values, Index from, Index to, double value)
{
  const double parameter = (value - values[from]) / (values[to] - values[from]);
  return (1.0 - parameter) * vertices.col(from) + parameter * vertices.col(to);
}

} // namespace SurfaceScalars
