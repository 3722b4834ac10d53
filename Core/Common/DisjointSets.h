#pragma once

#include "Basics.h"

#include <numeric>
#include <vector>

namespace SurfaceScalars
{

/// A partition into sets, each known by its root (union-find with path halving). The caller says
/// which root stays: here it is the oldest vertex of a component.
class DisjointSets
{
public:
  explicit DisjointSets(Index count)
    : parents_(count)
  {
    std::iota(this->parents_.begin(), this->parents_.end(), Index(0));
  }

  Index find(Index element)
  {
    Index* parents = this->parents_.data();
    while (parents[element] != element)
    {
      element = parents[element] = parents[parents[element]];
    }
    return element;
  }

  bool isRoot(Index element) const { return this->parents_[element] == element; }

  /// Makes `parent` the next element on the way from `root` to its root. The caller answers for it
  /// that `parent` is not in the set of `root`.
  void attach(Index root, Index parent) { this->parents_[root] = parent; }

private:
  std::vector<Index> parents_;
};

} // namespace SurfaceScalars
