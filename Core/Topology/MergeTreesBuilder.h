#pragma once

#include "DisjointSets.h"
#include "Execution.h"
#include "MergeTree.h"
#include "MeshLinks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace SurfaceScalars
{

/**
 * The merge trees of a graph whose vertices are visited in a strict order, for the sublevel sets of
 * a function, and the other way round, for its superlevel sets.
 *
 * Basins come first, by steps to the first neighbor; then only edges between basins count and are
 * sorted, few unless the function is noise. Time O(edges + m log m) for m of those. Results do not
 * depend on the number of threads.
 *
 * @param neighborsOf of an index: a range of indices; one of the two ends of an edge has to name
 * it. Of MeshLinks only the places are looked at where components can merge
 * @param isBelow the order, as ValueOrder
 */
template <class Adjacency, class Order>
class MergeTreesBuilder
{
public:
  MergeTreesBuilder(
    Index count, const Adjacency& neighborsOf, const Order& isBelow, const Execution& execution)
    : count_(count)
    , neighborsOf_(neighborsOf)
    , isBelow_(isBelow)
    , execution_(execution)
    , sweeps_{ Sweep(count), Sweep(count) }
    , isRoot_(count)
  {
  }

  /// @throws Aborted
  MergeTrees build()
  {
    this->hangOnNamed();
    if constexpr (!AreLinks)
    {
      this->hangOnNaming();
    }
    this->findBasins();
    this->findPasses();
    this->merge();
    return { std::move(this->sweeps_[Up].tree), std::move(this->sweeps_[Down].tree) };
  }

private:
  static constexpr std::size_t Grain = 1 << 14; // vertices per block of a parallel loop
  static constexpr bool AreLinks = std::is_same_v<Adjacency, MeshLinks>; // both ends name an edge
  static constexpr std::size_t Up = 0;                                   // the order itself
  static constexpr std::size_t Down = 1;                                 // the other way round

  /// An edge between basins, passable from its later end on.
  struct Pass
  {
    double value; ///< of the vertex: sorting need not look it up
    Index vertex;
    Index a;
    Index b;
  };

  /// A vertex that names a root.
  struct Naming
  {
    Index root;
    Index vertex;
  };

  struct Sweep
  {
    explicit Sweep(Index count)
      : sets(count)
    {
    }

    DisjointSets sets;
    std::vector<Pass> passes;
    MergeTree tree;
  };

  template <class Found>
  using BothSweeps = std::array<std::vector<Found>, 2>;

  bool isBefore(std::size_t sweep, Index a, Index b) const
  {
    return sweep == Up ? this->isBelow_(a, b) : this->isBelow_(b, a);
  }

  template <class Body>
  void forEachVertex(const Execution& execution, const Body& body) const
  {
    parallelFor(this->count_, Grain, execution,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t vertex = begin; vertex < end; ++vertex)
        {
          body(static_cast<Index>(vertex));
        }
      });
  }

  /// What body adds for each vertex, in the order of their indices.
  template <class Found, class Body>
  BothSweeps<Found> collect(const Execution& execution, const Body& body) const
  {
    std::vector<BothSweeps<Found>> blocks((this->count_ + Grain - 1) / Grain);
    this->forEachVertex(execution, [&](Index vertex) { body(vertex, blocks[vertex / Grain]); });
    BothSweeps<Found> all;
    for (const std::size_t sweep : { Up, Down })
    {
      for (BothSweeps<Found>& block : blocks)
      {
        all[sweep].insert(all[sweep].end(), block[sweep].begin(), block[sweep].end());
        block[sweep] = {};
      }
    }
    return all;
  }

  /// Each vertex hangs on the first of the neighbors that it names, unless it comes before them.
  void hangOnNamed()
  {
    this->forEachVertex(
      this->execution_.part(0.0, 0.4), [this](Index vertex) { this->hangOnNamed(vertex); });
  }

  /// Least and largest value come first, for which no branch has to be guessed.
  void hangOnNamed(Index vertex)
  {
    const auto& around = this->neighborsOf_(vertex);
    double least = this->isBelow_.value(vertex);
    double largest = least;
    for (const Index neighbor : around)
    {
      least = std::min(this->isBelow_.value(neighbor), least);
      largest = std::max(this->isBelow_.value(neighbor), largest);
    }
    std::array<Index, 2> first{ vertex, vertex };
    for (const Index neighbor : around)
    {
      const double value = this->isBelow_.value(neighbor);
      if (value == least && this->isBefore(Up, neighbor, first[Up]))
      {
        first[Up] = neighbor;
      }
      if (value == largest && this->isBefore(Down, neighbor, first[Down]))
      {
        first[Down] = neighbor;
      }
    }
    this->sweeps_[Up].sets.attach(vertex, first[Up]);
    this->sweeps_[Down].sets.attach(vertex, first[Down]);
    this->isRoot_[vertex] = first[Up] == vertex || first[Down] == vertex ? 1 : 0;
  }

  /// A vertex that names none that is before it hangs on one that names it.
  void hangOnNaming()
  {
    const auto isRoot = [this](Index vertex) { return this->isRoot_[vertex] != 0; };
    const BothSweeps<Naming> namings =
      this->template collect<Naming>(this->execution_.part(0.4, 0.6),
        [&](Index vertex, BothSweeps<Naming>& found)
        {
          const auto& around = this->neighborsOf_(vertex);
          if (std::any_of(around.begin(), around.end(), isRoot)) // hardly ever
          {
            this->findNamings(vertex, found);
          }
        });
    for (const std::size_t sweep : { Up, Down })
    {
      DisjointSets& sets = this->sweeps_[sweep].sets;
      for (const Naming& naming : namings[sweep])
      {
        if (sets.isRoot(naming.root))
        {
          sets.attach(naming.root, naming.vertex);
        }
      }
    }
  }

  void findNamings(Index vertex, BothSweeps<Naming>& found) const
  {
    for (const Index neighbor : this->neighborsOf_(vertex))
    {
      for (const std::size_t sweep : { Up, Down })
      {
        if (this->sweeps_[sweep].sets.isRoot(neighbor) && this->isBefore(sweep, vertex, neighbor))
        {
          found[sweep].push_back({ neighbor, vertex });
        }
      }
    }
  }

  void findBasins()
  {
    parallelForEach(2, this->execution_.part(0.6, 0.7),
      [this](std::size_t sweep, const Poll&)
      {
        Sweep& of = this->sweeps_[sweep];
        of.tree.basins.resize(this->count_);
        for (Index vertex = 0; vertex < this->count_; ++vertex)
        {
          of.tree.basins[vertex] = of.sets.find(vertex);
        }
      });
  }

  void findPasses()
  {
    const std::vector<Index>& up = this->sweeps_[Up].tree.basins;
    const std::vector<Index>& down = this->sweeps_[Down].tree.basins;
    BothSweeps<Pass> passes = this->template collect<Pass>(this->execution_.part(0.7, 0.9),
      [&](Index vertex, BothSweeps<Pass>& found)
      {
        if constexpr (AreLinks)
        {
          this->addPassesOfLink(Up, vertex, found[Up]);
          this->addPassesOfLink(Down, vertex, found[Down]);
          return;
        }
        const auto& around = this->neighborsOf_(vertex);
        const auto isElsewhere = [&, ofUp = up[vertex], ofDown = down[vertex]](Index neighbor)
        { return up[neighbor] != ofUp || down[neighbor] != ofDown; };
        if (std::any_of(around.begin(), around.end(), isElsewhere)) // seldom
        {
          this->addPasses(Up, vertex, found[Up]);
          this->addPasses(Down, vertex, found[Down]);
        }
      });
    this->sweeps_[Up].passes = std::move(passes[Up]);
    this->sweeps_[Down].passes = std::move(passes[Down]);
  }

  void addPassesOfLink(std::size_t sweep, Index vertex, std::vector<Pass>& passes) const
  {
    const std::vector<Index>& basins = this->sweeps_[sweep].tree.basins;
    this->neighborsOf_.forEachOfSeveralParts(
      vertex, [&](Index neighbor) { return this->isBefore(sweep, neighbor, vertex); },
      [&](Index neighbor)
      {
        if (basins[neighbor] != basins[vertex])
        {
          passes.push_back(this->pass(vertex, basins[vertex], basins[neighbor]));
        }
      });
  }

  Pass pass(Index vertex, Index a, Index b) const
  {
    return { this->isBelow_.value(vertex), vertex, a, b };
  }

  void addPasses(std::size_t sweep, Index vertex, std::vector<Pass>& passes) const
  {
    const std::vector<Index>& basins = this->sweeps_[sweep].tree.basins;
    const auto known = static_cast<std::ptrdiff_t>(passes.size());
    for (const Index neighbor : this->neighborsOf_(vertex))
    {
      if (basins[neighbor] == basins[vertex])
      {
        continue;
      }
      if (this->isBefore(sweep, vertex, neighbor))
      {
        if (!this->names(neighbor, vertex))
        {
          passes.push_back(this->pass(neighbor, basins[neighbor], basins[vertex]));
        }
      }
      else if (std::none_of(passes.begin() + known, passes.end(),
                 [&](const Pass& pass)
                 { return pass.vertex == vertex && pass.b == basins[neighbor]; }))
      {
        passes.push_back(this->pass(vertex, basins[vertex], basins[neighbor]));
      }
    }
  }

  bool names(Index vertex, Index neighbor) const
  {
    const auto& around = this->neighborsOf_(vertex);
    return std::find(around.begin(), around.end(), neighbor) != around.end();
  }

  void merge()
  {
    parallelForEach(2, this->execution_.part(0.9, 1.0),
      [this](std::size_t sweep, const Poll&) { this->merge(sweep); });
  }

  void merge(std::size_t sweep)
  {
    Sweep& of = this->sweeps_[sweep];
    std::sort(of.passes.begin(), of.passes.end(),
      [=](const Pass& a, const Pass& b)
      {
        return a.value == b.value ? this->isBefore(sweep, a.vertex, b.vertex)
                                  : (a.value < b.value) == (sweep == Up);
      });
    for (const Pass& pass : of.passes)
    {
      Index elder = of.sets.find(pass.a);
      Index younger = of.sets.find(pass.b);
      if (elder == younger)
      {
        continue;
      }
      if (this->isBefore(sweep, younger, elder))
      {
        std::swap(younger, elder);
      }
      of.sets.attach(younger, elder);
      of.tree.merges.push_back({ younger, elder, pass.vertex, { pass.a, pass.b } });
    }
  }

  Index count_;
  const Adjacency& neighborsOf_;
  const Order& isBelow_;
  const Execution& execution_;
  std::array<Sweep, 2> sweeps_;
  std::vector<char> isRoot_; ///< of a sweep: whether a vertex names none that is before it
};

} // namespace SurfaceScalars
