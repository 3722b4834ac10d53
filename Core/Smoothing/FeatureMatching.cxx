#include "FeatureMatching.h"

#include "DisjointSets.h"
#include "MergeTreesBuilder.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// Moves one set into the other, the smaller one element by element.
template <class Set>
void moveInto(Set& to, Set& from)
{
  if (to.size() < from.size())
  {
    std::swap(to, from);
  }
  to.merge(from);
  from.clear();
}

/// Each extremum takes, as it ends, the first match left in its component.
class InnerFirst
{
public:
  InnerFirst(
    const std::vector<Index>& matches, const std::vector<char>& isAsked, double persistence)
    : matches_(matches)
    , isAsked_(isAsked)
    , persistence_(persistence)
  {
  }

  void meet(Index component, Index match) { this->free_[component].insert(match); }

  void end(Index extremum, double persistence)
  {
    if (!(persistence > this->persistence_) ||
      (!this->isAsked_.empty() && this->isAsked_[extremum] == 0))
    {
      return;
    }
    std::set<Index>& free = this->free_[extremum];
    if (free.empty())
    {
      this->unmatched.push_back(extremum);
      return;
    }
    this->taken.push_back(this->matches_[*free.begin()]);
    free.erase(free.begin());
  }

  void join(Index younger, Index elder) { moveInto(this->free_[elder], this->free_[younger]); }

  std::vector<Index> taken;
  std::vector<Index> unmatched;

private:
  const std::vector<Index>& matches_;
  const std::vector<char>& isAsked_;
  double persistence_;
  std::map<Index, std::set<Index>> free_; ///< of each component, places in the list of matches
};

/// Of the extrema of a component as many remain as it has matches, the most persistent ones: the
/// one that it is of is more persistent than those inside.
class PersistentFirst
{
public:
  void meet(Index component, Index) { ++this->components_[component].matchCount; }

  void end(Index extremum, double persistence)
  {
    Component& component = this->components_[extremum];
    component.extrema.insert({ persistence, extremum });
    if (component.extrema.size() > component.matchCount)
    {
      component.extrema.erase(component.extrema.begin());
    }
  }

  void join(Index younger, Index elder)
  {
    Component& to = this->components_[elder];
    Component& from = this->components_[younger];
    to.matchCount += from.matchCount;
    moveInto(to.extrema, from.extrema);
    this->components_.erase(younger);
  }

  std::vector<Index> extrema() const
  {
    std::vector<Index> result;
    for (const auto& [first, component] : this->components_)
    {
      for (const auto& [persistence, extremum] : component.extrema)
      {
        result.push_back(extremum);
      }
    }
    return result;
  }

private:
  struct Component
  {
    std::size_t matchCount = 0;
    std::set<std::pair<double, Index>> extrema; ///< that ended, by persistence
  };

  std::map<Index, Component> components_; ///< by extremum
};

/// The range of values on each component, by its first extremum, which never ends.
std::map<Index, double> rangesOf(
  DisjointSets& sets, const std::vector<Index>& basins, const ValuesRef& values)
{
  std::map<Index, double> ranges;
  for (Index vertex = 0; vertex < basins.size(); ++vertex)
  {
    const Index first = sets.find(basins[vertex]);
    double& range = ranges[first];
    range = std::max(range, std::abs(values[first] - values[vertex]));
  }
  return ranges;
}

/// Follows the components of one sweep: they meet matches, named by their places in the list, join,
/// and extrema end.
template <class Order, class Matching>
void sweep(const MergeTree& tree, const ValuesRef& values, const Order& isBefore,
  const std::vector<Index>& matches, Matching& matching)
{
  std::vector<Index> inOrder(matches.size());
  std::iota(inOrder.begin(), inOrder.end(), Index{ 0 });
  std::sort(inOrder.begin(), inOrder.end(),
    [&](Index a, Index b) { return isBefore(matches[a], matches[b]); });
  DisjointSets sets(static_cast<Index>(tree.basins.size()));
  auto next = inOrder.begin();
  const auto meetMatches = [&](const auto& isMet)
  {
    for (; next != inOrder.end() && isMet(matches[*next]); ++next)
    {
      matching.meet(sets.find(tree.basins[matches[*next]]), *next);
    }
  };
  for (const Merge& merge : tree.merges)
  {
    meetMatches([&](Index match) { return isBefore(match, merge.vertex); });
    matching.end(merge.younger, std::abs(values[merge.younger] - values[merge.vertex]));
    matching.join(merge.younger, merge.elder);
    sets.attach(merge.younger, merge.elder);
  }
  meetMatches([](Index) { return true; });
  for (const auto& [extremum, range] : rangesOf(sets, tree.basins, values))
  {
    matching.end(extremum, range);
  }
}

/// Minima are matched with minima, maxima with maxima.
template <class Matching>
void sweepBoth(const MeshTopology& mesh, const ValuesRef& values, const ExtremalVertices& matches,
  Matching& ofMinima, Matching& ofMaxima, const Execution& execution)
{
  const ValueOrder isBelow{ values.data() };
  const auto isAbove = [&](Index a, Index b) { return isBelow(b, a); };
  const MeshLinks neighborsOf{ mesh };
  const MergeTrees trees =
    MergeTreesBuilder(mesh.vertexCount(), neighborsOf, isBelow, execution.part(0.0, 0.7)).build();
  parallelForEach(2, execution.part(0.7, 1.0),
    [&](std::size_t which, const Poll&)
    {
      if (which == 0)
      {
        sweep(trees.sublevel, values, isBelow, matches.minima, ofMinima);
      }
      else
      {
        sweep(trees.superlevel, values, isAbove, matches.maxima, ofMaxima);
      }
    });
}

std::vector<Index> sorted(std::vector<Index> vertices)
{
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

} // namespace

std::vector<Index> unmatchedExtrema(const MeshTopology& mesh, const ValuesRef& values,
  const ExtremalVertices& matches, double persistence, const std::vector<char>& isAsked,
  const Execution& execution)
{
  InnerFirst minima(matches.minima, isAsked, persistence);
  InnerFirst maxima(matches.maxima, isAsked, persistence);
  sweepBoth(mesh, values, matches, minima, maxima, execution);
  std::vector<Index> result = sorted(minima.unmatched);
  const std::vector<Index> rest = sorted(maxima.unmatched);
  result.insert(result.end(), rest.begin(), rest.end());
  return result;
}

ExtremalVertices takenExtrema(const MeshTopology& mesh, const ValuesRef& values,
  const ExtremalVertices& matches, const std::vector<char>& isAsked, const Execution& execution)
{
  InnerFirst minima(matches.minima, isAsked, 0.0);
  InnerFirst maxima(matches.maxima, isAsked, 0.0);
  sweepBoth(mesh, values, matches, minima, maxima, execution);
  return { sorted(minima.taken), sorted(maxima.taken) };
}

ExtremalVertices extremaWithCounterpart(const MeshTopology& mesh, const ValuesRef& values,
  const ExtremalVertices& matches, const Execution& execution)
{
  PersistentFirst minima;
  PersistentFirst maxima;
  sweepBoth(mesh, values, matches, minima, maxima, execution);
  return { sorted(minima.extrema()), sorted(maxima.extrema()) };
}

} // namespace SurfaceScalars
