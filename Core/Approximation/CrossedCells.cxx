#include "CrossedCells.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 16384; // values in a block of a parallel loop

/// Calls visit(level, cell) for all levels from begin to before end that a cell crosses.
template <class Visit>
void forEachCrossing(const SimplicesRef& cells, const std::vector<Index>& ranks, Index begin,
  Index end, const Visit& visit)
{
  for (Eigen::Index cell = 0; cell < cells.cols(); ++cell)
  {
    const RankRange range = rankRange(ranks, cells.col(cell));
    const Index last = std::min(end, range.last);
    for (Index level = std::max(begin, range.first); level < last; ++level)
    {
      visit(level, static_cast<Index>(cell));
    }
  }
}

} // namespace

std::vector<Index> ranksAmong(
  const ValuesRef& levels, const ValuesRef& values, const Execution& execution)
{
  std::vector<Index> ranks(static_cast<std::size_t>(values.size()));
  parallelFor(ranks.size(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const double value = values[static_cast<Eigen::Index>(i)];
        ranks[i] = static_cast<Index>(
          std::upper_bound(levels.begin(), levels.end(), value) - levels.begin());
      }
    });
  return ranks;
}

std::vector<std::size_t> crossingCounts(
  const SimplicesRef& cells, const std::vector<Index>& ranks, Index levelCount)
{
  std::vector<std::size_t> counts(levelCount + 1, 0); // changes; below zero they wrap around
  for (Eigen::Index cell = 0; cell < cells.cols(); ++cell)
  {
    const RankRange range = rankRange(ranks, cells.col(cell));
    ++counts[range.first];
    --counts[range.last];
  }
  for (std::size_t level = 1; level < counts.size(); ++level)
  {
    counts[level] += counts[level - 1];
  }
  counts.pop_back();
  return counts;
}

CrossedCells::CrossedCells(
  const SimplicesRef& cells, const std::vector<Index>& ranks, Index begin, Index end)
  : begin_(begin)
  , starts_(end - begin + 1, 0)
{
  forEachCrossing(
    cells, ranks, begin, end, [&](Index level, Index) { ++this->starts_[level - begin]; });
  std::size_t sum = 0;
  for (std::size_t& start : this->starts_)
  {
    sum += start;
    start = sum; // one past the last, until the cells are filled in
  }
  this->cells_.resize(sum);
  forEachCrossing(cells, ranks, begin, end,
    [&](Index level, Index cell) { this->cells_[--this->starts_[level - begin]] = cell; });
}

} // namespace SurfaceScalars
