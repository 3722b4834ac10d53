#include "FeatureMatching.h"

#include "MergeTree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// Follows the components of one sweep and lets the extrema that end choose among the matches in
/// theirs.
template <class Order>
class ComponentMatching
{
public:
  ComponentMatching(const MergeTree& tree, const ValuesRef& values, const Order& isBefore,
    std::vector<Index> matches)
    : tree_(tree)
    , values_(values)
    , isBefore_(isBefore)
    , matches_(std::move(matches))
    , sets_(static_cast<Index>(values.size()))
    , free_(tree.basins.size(), 0)
  {
    std::sort(this->matches_.begin(), this->matches_.end(), isBefore);
    this->next_ = this->matches_.begin();
  }

  std::vector<Index> unmatched(double persistence)
  {
    std::vector<Index> result;
    const auto choose = [&](Index extremum, double ofExtremum)
    {
      if (ofExtremum > persistence && this->free_[extremum]-- == 0)
      {
        this->free_[extremum] = 0;
        result.push_back(extremum);
      }
    };
    for (const Merge& merge : this->tree_.merges)
    {
      this->meetMatches([&](Index match) { return this->isBefore_(match, merge.vertex); });
      choose(merge.younger, this->difference(merge.younger, merge.vertex));
      this->sets_.attach(merge.younger, merge.elder);
      this->free_[merge.elder] += this->free_[merge.younger];
    }
    this->meetMatches([](Index) { return true; });
    for (const auto& [extremum, range] : this->rangesOfComponents())
    {
      choose(extremum, range);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  double difference(Index a, Index b) const
  {
    return std::abs(this->values_[a] - this->values_[b]);
  }

  template <class Condition>
  void meetMatches(const Condition& isMet)
  {
    for (; this->next_ != this->matches_.end() && isMet(*this->next_); ++this->next_)
    {
      ++this->free_[this->sets_.find(this->tree_.basins[*this->next_])];
    }
  }

  /// By the first extremum of each, which never ends.
  std::map<Index, double> rangesOfComponents()
  {
    std::map<Index, double> ranges;
    for (Index vertex = 0; vertex < this->tree_.basins.size(); ++vertex)
    {
      const Index first = this->sets_.find(this->tree_.basins[vertex]);
      double& range = ranges[first];
      range = std::max(range, this->difference(first, vertex));
    }
    return ranges;
  }

  const MergeTree& tree_;
  const ValuesRef& values_;
  const Order& isBefore_;
  std::vector<Index> matches_; ///< in the order of the sweep
  std::vector<Index>::const_iterator next_;
  DisjointSets sets_;
  std::vector<int> free_; ///< matches met in the component of an extremum and not taken
};

template <class Order>
std::vector<Index> unmatched(const MeshTopology& mesh, const ValuesRef& values,
  const std::vector<Index>& matches, const Order& isBefore, double persistence, const Poll& poll)
{
  const auto neighborsOf = [&](Index vertex) { return mesh.link(vertex); };
  const MergeTree tree = MergeTreeBuilder(mesh.vertexCount(), neighborsOf, isBefore, poll).build();
  return ComponentMatching(tree, values, isBefore, matches).unmatched(persistence);
}

} // namespace

std::vector<Index> unmatchedExtrema(const MeshTopology& mesh, const ValuesRef& values,
  const ExtremalVertices& matches, double persistence, const Execution& execution)
{
  const auto isBelow = [&](Index a, Index b)
  { return values[a] < values[b] || (values[a] == values[b] && a < b); };
  const auto isAbove = [&](Index a, Index b) { return isBelow(b, a); };
  std::vector<Index> minima;
  std::vector<Index> maxima;
  parallelForEach(2, execution,
    [&](std::size_t which, const Poll& poll)
    {
      if (which == 0)
      {
        minima = unmatched(mesh, values, matches.minima, isBelow, persistence, poll);
      }
      else
      {
        maxima = unmatched(mesh, values, matches.maxima, isAbove, persistence, poll);
      }
    });
  minima.insert(minima.end(), maxima.begin(), maxima.end());
  return minima;
}

} // namespace SurfaceScalars
