#pragma once

#include "Basics.h"
#include "DisjointSets.h"
#include "Execution.h"

#include <algorithm>
#include <array>
#include <vector>

namespace SurfaceScalars
{

/// Two components of what is not after a vertex become one at that vertex; each is known by its
/// first vertex, an extremum.
struct Merge
{
  Index younger; ///< ends here
  Index elder;
  Index vertex;
  std::array<Index, 2> basins; ///< that meet at the vertex
};

/// How the components of the vertices visited so far begin and merge as one vertex after another is
/// visited.
struct MergeTree
{
  std::vector<Index> basins; ///< of each vertex: the extremum that steps to the first neighbor
                             ///< lead to
  std::vector<Merge> merges; ///< in the order of the vertices
};

/**
 * The merge tree of a graph whose vertices are visited in a strict order: by value for the sublevel
 * sets of a function, the other way round for its superlevel sets.
 *
 * Basins come first, by steps to the first neighbor; then only edges between basins count and are
 * sorted, few unless the function is noise. Time O(edges + m log m) for m of those.
 *
 * @param neighborsOf of an index: a range of indices; one of the two ends of an edge has to name it
 * @param isBefore of two indices: whether the first is visited before the second
 */
template <class Adjacency, class Order>
class MergeTreeBuilder
{
public:
  MergeTreeBuilder(
    Index count, const Adjacency& neighborsOf, const Order& isBefore, const Poll& poll)
    : count_(count)
    , neighborsOf_(neighborsOf)
    , isBefore_(isBefore)
    , poll_(poll)
    , sets_(count)
  {
  }

  MergeTree build()
  {
    this->findBasins();
    this->findPasses();
    std::sort(this->passes_.begin(), this->passes_.end(),
      [this](const Pass& a, const Pass& b) { return this->isBefore_(a.vertex, b.vertex); });
    this->merge();
    return std::move(this->result_);
  }

private:
  /// An edge between basins, passable from its later end on.
  struct Pass
  {
    Index vertex;
    Index a;
    Index b;
  };

  template <class Body>
  void forEachVertex(const Body& body) const
  {
    for (Index vertex = 0; vertex < this->count_; ++vertex)
    {
      if (vertex % 65536 == 0)
      {
        this->poll_();
      }
      body(vertex);
    }
  }

  /// Each vertex hangs on its first neighbor, or, if it names none that is before it, on one that
  /// names it.
  void findBasins()
  {
    this->forEachVertex(
      [this](Index vertex)
      {
        Index first = vertex;
        for (const Index neighbor : this->neighborsOf_(vertex))
        {
          if (this->isBefore_(neighbor, first))
          {
            first = neighbor;
          }
          else if (this->sets_.isRoot(neighbor) && this->isBefore_(vertex, neighbor))
          {
            this->sets_.attach(neighbor, vertex);
          }
        }
        if (first != vertex)
        {
          this->sets_.attach(vertex, first);
        }
      });
    this->result_.basins.resize(this->count_);
    this->forEachVertex(
      [this](Index vertex) { this->result_.basins[vertex] = this->sets_.find(vertex); });
  }

  void findPasses()
  {
    const std::vector<Index>& basins = this->result_.basins;
    this->forEachVertex(
      [&](Index vertex)
      {
        const std::size_t known = this->passes_.size();
        for (const Index neighbor : this->neighborsOf_(vertex))
        {
          if (basins[neighbor] == basins[vertex])
          {
            continue;
          }
          if (this->isBefore_(vertex, neighbor))
          {
            if (!this->names(neighbor, vertex))
            {
              this->passes_.push_back({ neighbor, basins[neighbor], basins[vertex] });
            }
          }
          else if (std::none_of(this->passes_.begin() + static_cast<std::ptrdiff_t>(known),
                     this->passes_.end(),
                     [&](const Pass& pass)
                     { return pass.vertex == vertex && pass.b == basins[neighbor]; }))
          {
            this->passes_.push_back({ vertex, basins[vertex], basins[neighbor] });
          }
        }
      });
  }

  bool names(Index vertex, Index neighbor) const
  {
    const auto& around = this->neighborsOf_(vertex);
    return std::find(around.begin(), around.end(), neighbor) != around.end();
  }

  void merge()
  {
    for (const Pass& pass : this->passes_)
    {
      Index elder = this->sets_.find(pass.a);
      Index younger = this->sets_.find(pass.b);
      if (elder == younger)
      {
        continue;
      }
      if (this->isBefore_(younger, elder))
      {
        std::swap(younger, elder);
      }
      this->sets_.attach(younger, elder);
      this->result_.merges.push_back({ younger, elder, pass.vertex, { pass.a, pass.b } });
    }
  }

  Index count_;
  const Adjacency& neighborsOf_;
  const Order& isBefore_;
  const Poll& poll_;
  DisjointSets sets_;
  std::vector<Pass> passes_;
  MergeTree result_;
};

} // namespace SurfaceScalars
