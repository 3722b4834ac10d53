#include "DistortionIntervals.h"

#include "Require.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t MostCrossings = 1 << 19; // of a block of level sets

bool containsOne(const ValuesRef& ascending, double lower, double upper)
{
  const auto first = std::lower_bound(ascending.begin(), ascending.end(), lower);
  return first != ascending.end() && *first <= upper;
}

/// Those without critical value both ends of which have a level set, ascending.
std::vector<Index> regularIntervals(const ValuesRef& isoValues, const ValuesRef& criticalValues,
  const std::vector<std::size_t>& counts)
{
  std::vector<Index> intervals;
  for (Index i = 0; i + 1 < isoValues.size(); ++i)
  {
    const bool hasEnds = counts[i] > 0 && counts[i + 1] > 0;
    if (hasEnds && !containsOne(criticalValues, isoValues[i], isoValues[i + 1]))
    {
      intervals.push_back(i);
    }
  }
  return intervals;
}

/// The end of the block of intervals that begins here: at least one, more if their level sets have
/// few crossings.
std::size_t endOfBlock(
  const std::vector<Index>& intervals, std::size_t begin, const std::vector<std::size_t>& counts)
{
  std::size_t end = begin;
  std::size_t sum = 0;
  for (Index level = intervals[begin]; end < intervals.size(); ++end)
  {
    for (; level <= intervals[end] + 1; ++level)
    {
      sum += counts[level];
    }
    if (sum > MostCrossings && end > begin)
    {
      break;
    }
  }
  return end;
}

/// Drops those between which no way leads.
LevelSetDistortion finiteOnes(
  const std::vector<Index>& intervals, const Values& distances, const ValuesRef& isoValues)
{
  LevelSetDistortion result{ distances, distances, distances, 0 };
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < distances.size(); ++i)
  {
    if (std::isfinite(distances[i]))
    {
      const Index level = intervals[static_cast<std::size_t>(i)];
      result.isoValues[count] = isoValues[level];
      result.nextIsoValues[count] = isoValues[level + 1];
      result.distances[count++] = distances[i];
    }
  }
  for (Values* column : { &result.isoValues, &result.nextIsoValues, &result.distances })
  {
    column->conservativeResize(count);
  }
  result.leftOut =
    static_cast<std::size_t>(std::max<Eigen::Index>(0, isoValues.size() - 1) - count);
  return result;
}

void checkAscending(const ValuesRef& isoValues, const ValuesRef& criticalValues)
{
  const bool rises = std::adjacent_find(isoValues.begin(), isoValues.end(),
                       [](double a, double b) { return !(a < b); }) == isoValues.end();
  require(rises && std::is_sorted(criticalValues.begin(), criticalValues.end()),
    "ascending iso-values, all different, and ascending critical values",
    rises ? "critical values that fall" : "iso-values that do not rise", "Sort them.");
}

} // namespace

LevelSetDistortion measureIntervals(const SimplicesRef& cells, const std::vector<Index>& ranks,
  const ValuesRef& isoValues, const ValuesRef& criticalValues, const Execution& execution,
  const MeasureIntervals& measure)
{
  checkAscending(isoValues, criticalValues);
  const std::vector<std::size_t> counts =
    crossingCounts(cells, ranks, static_cast<Index>(isoValues.size()));
  const std::vector<Index> intervals = regularIntervals(isoValues, criticalValues, counts);
  Values distances(static_cast<Eigen::Index>(intervals.size()));
  for (std::size_t begin = 0, end = 0; begin < intervals.size(); begin = end)
  {
    end = endOfBlock(intervals, begin, counts);
    const std::vector<Index> block(intervals.begin() + static_cast<std::ptrdiff_t>(begin),
      intervals.begin() + static_cast<std::ptrdiff_t>(end));
    const auto share = [&](std::size_t done)
    { return static_cast<double>(done) / static_cast<double>(intervals.size()); };
    measure(CrossedCells(cells, ranks, block.front(), block.back() + 2), block,
      distances.data() + begin, execution.part(share(begin), share(end)));
  }
  execution.report(1.0);
  return finiteOnes(intervals, distances, isoValues);
}

int affordableHalvings(
  const SimplicesRef& edges, const ValuesRef& values, int most, double crossings)
{
  const double range = values.maxCoeff() - values.minCoeff();
  double perPart = 0.0; // crossings, by an even division of the range
  for (Eigen::Index edge = 0; edge < edges.cols(); ++edge)
  {
    perPart += std::abs(values[edges(1, edge)] - values[edges(0, edge)]) / range;
  }
  int halvings = 1;
  while (halvings < most && std::ldexp(perPart, halvings + 1) <= crossings)
  {
    ++halvings;
  }
  return halvings;
}

} // namespace SurfaceScalars
