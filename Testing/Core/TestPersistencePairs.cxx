#include "Error.h"
#include "MergeTreesBuilder.h"
#include "Persistence.h"
#include "Queries.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

namespace SurfaceScalars::Truth
{
namespace
{

using VertexPairs = std::set<std::pair<Index, Index>>; ///< extremum and saddle

/// The pairs of minima by reduction of the boundary matrix of the graph over Z2.
VertexPairs reducedPairs(const NeighborGraph& graph, const Values& values)
{
  const Index count = graph.pointCount();
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), Index(0));
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return values[a] < values[b]; });
  std::vector<Index> ranks(count);
  for (Index i = 0; i < count; ++i)
  {
    ranks[order[i]] = i;
  }
  std::set<std::array<Index, 2>> edges; // ranks, the higher first
  for (Index i = 0; i < count; ++i)
  {
    for (const Index j : graph.neighbors(i))
    {
      edges.insert({ std::max(ranks[i], ranks[j]), std::min(ranks[i], ranks[j]) });
    }
  }
  VertexPairs pairs;
  std::vector<std::set<Index>> reduced(count); // by their highest vertex
  for (const std::array<Index, 2>& edge : edges)
  {
    std::set<Index> column(edge.begin(), edge.end());
    while (!column.empty() && !reduced[*column.rbegin()].empty())
    {
      for (const Index vertex : std::set<Index>(reduced[*column.rbegin()]))
      {
        if (!column.insert(vertex).second)
        {
          column.erase(vertex);
        }
      }
    }
    if (!column.empty())
    {
      const Index youngest = *column.rbegin();
      reduced[youngest] = column;
      if (youngest != edge[0])
      {
        pairs.insert({ order[youngest], order[edge[0]] });
      }
    }
  }
  return pairs;
}

VertexPairs verticesOf(const std::vector<PersistencePair>& pairs)
{
  VertexPairs vertices;
  for (const PersistencePair& pair : pairs)
  {
    vertices.insert({ pair.extremum, pair.saddle });
  }
  EXPECT_EQ(vertices.size(), pairs.size());
  return vertices;
}

/// Few different values, so that many are equal.
Values randomSteps(Index count, int steps, unsigned seed)
{
  Random random(seed);
  Values values(count);
  for (double& value : values)
  {
    value = std::floor(random.uniform(0.0, steps));
  }
  return values;
}

// Union-find pairs as the reduction of the boundary matrix does, on graphs whose lists of neighbors
// are not symmetric and that have several components, with ties broken by index; superlevel sets
// are the sublevel sets of -f with ties the other way round.
TEST(PersistencePairs, pairsAreThoseOfMatrixReduction)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    const Points points = randomPlane(150, seed);
    const NeighborGraph graph(points, nearest(2 + static_cast<int>(seed % 5)));
    const Values values = randomSteps(graph.pointCount(), seed % 2 == 0 ? 8 : 100000, seed);
    const PersistencePairs pairs = persistencePairs(graph, values);

    EXPECT_EQ(verticesOf(pairs.minima), reducedPairs(graph, values)) << seed;
    for (const PersistencePair& pair : pairs.minima)
    {
      EXPECT_EQ(pair.persistence, values[pair.saddle] - values[pair.extremum]);
    }
    if (seed % 2 == 1)
    {
      EXPECT_EQ(verticesOf(pairs.maxima), reducedPairs(graph, -values)) << seed;
    }
    const auto byPersistence = [](const PersistencePair& a, const PersistencePair& b)
    { return a.persistence > b.persistence; };
    EXPECT_TRUE(std::is_sorted(pairs.minima.begin(), pairs.minima.end(), byPersistence));
    EXPECT_TRUE(std::is_sorted(pairs.maxima.begin(), pairs.maxima.end(), byPersistence));
  }
}

// The pairs of a graph of many blocks, most of whose edges join basins, are the same with one
// thread and with several.
TEST(PersistencePairs, pairsDoNotDependOnThreads)
{
  const NeighborGraph graph(randomSphere(50000, 1), nearest(8));
  const Values values = randomSteps(graph.pointCount(), 1000, 2);
  const PersistencePairs alone = persistencePairs(graph, values, { 1, {} });
  const PersistencePairs together = persistencePairs(graph, values, { 3, {} });

  EXPECT_GT(alone.minima.size(), 1000);
  EXPECT_EQ(verticesOf(alone.minima), verticesOf(together.minima));
  EXPECT_EQ(verticesOf(alone.maxima), verticesOf(together.maxima));
}

// A constant function has only pairs of persistence 0.
TEST(PersistencePairs, constantFunctionsHaveNone)
{
  const NeighborGraph graph(randomSphere(2000, 1), nearest(16));
  const PersistencePairs pairs = persistencePairs(graph, Values::Constant(2000, 3.0));
  for (const std::vector<PersistencePair>& ofKind : { pairs.minima, pairs.maxima })
  {
    EXPECT_TRUE(std::all_of(ofKind.begin(), ofKind.end(),
      [](const PersistencePair& pair) { return pair.persistence == 0.0; }));
  }
  EXPECT_THROW(persistencePairs(graph, Values::Zero(3)), InvalidInput);
}

} // namespace
} // namespace SurfaceScalars::Truth
