#include "DisjointSets.h"
#include "VolumeCriticalPoints.h"
#include "VolumeFunctions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

using VertexPairs = std::multiset<std::pair<std::size_t, std::size_t>>; ///< extremum and saddle

/// The merges of components as one vertex comes after the other, by their ranks.
VertexPairs mergesOf(const Tetrahedra& tetrahedra, const std::vector<int>& ranks)
{
  const auto count = static_cast<Index>(ranks.size());
  std::vector<std::set<Index>> before(count); // by rank
  for (Eigen::Index cell = 0; cell < tetrahedra.cols(); ++cell)
  {
    for (const Index a : tetrahedra.col(cell))
    {
      for (const Index b : tetrahedra.col(cell))
      {
        if (ranks[b] < ranks[a])
        {
          before[static_cast<Index>(ranks[a])].insert(static_cast<Index>(ranks[b]));
        }
      }
    }
  }
  VertexPairs merges;
  DisjointSets sets(count); // by rank; roots are the first vertices
  for (Index rank = 0; rank < count; ++rank)
  {
    std::set<Index> roots;
    for (const Index other : before[rank])
    {
      roots.insert(sets.find(other));
    }
    for (const Index root : roots)
    {
      if (root != *roots.begin())
      {
        merges.emplace(root, rank);
        sets.attach(root, *roots.begin());
      }
    }
    if (!roots.empty())
    {
      sets.attach(rank, *roots.begin());
    }
  }
  return merges;
}

/// The same by the vertices that have the ranks, for an image by its vertex.
VertexPairs pairsByMerging(const Glued& glued, std::vector<int> ranks, bool isRising)
{
  const auto last = static_cast<int>(ranks.size()) - 1;
  for (int& rank : ranks)
  {
    rank = isRising ? rank : last - rank;
  }
  std::vector<std::size_t> vertexOf(ranks.size());
  for (std::size_t i = 0; i < ranks.size(); ++i)
  {
    vertexOf[static_cast<std::size_t>(ranks[i])] = i;
  }
  VertexPairs pairs;
  for (const auto& [extremum, saddle] : mergesOf(glued.tetrahedra, ranks))
  {
    pairs.emplace(glued.originals[vertexOf[extremum]], glued.originals[vertexOf[saddle]]);
  }
  return pairs;
}

/// Cubes at random, which meet in vertices and edges, too.
NamedVolume crumbs(unsigned seed)
{
  Random random(seed);
  return { "crumbs " + std::to_string(seed),
    cubesVolume({ 5, 5, 5 }, [&](const Cube&) { return random.uniform() < 0.4; }), 0, 0, false };
}

// The pairs are among those of components that meet on the volume glued to its mirror image, a
// manifold or not; each ends one component of its saddle, and persistence is what the pairs say.
TEST(VolumePairs, pairsAreThoseOfComponentsThatMeet)
{
  std::vector<NamedVolume> volumes = volumesOfAllKinds();
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    volumes.push_back(crumbs(seed));
  }
  for (const NamedVolume& named : volumes)
  {
    const VolumeTopology topology = topologyOf(named.volume);
    Glued glued(named.volume);
    if (named.isClosed)
    {
      glued.tetrahedra = named.volume.tetrahedra; // no image of it
      glued.originals.resize(static_cast<std::size_t>(named.volume.vertices.cols()));
    }
    for (const auto& [name, values] : functionsOn(named.volume))
    {
      SCOPED_TRACE(named.name + ", " + name);
      const MeshCriticalPoints found =
        volumeCriticalPoints(named.volume.vertices, topology, values);
      VertexPairs minima;
      VertexPairs maxima;
      std::vector<int> ended(found.points.size(), 0);
      for (const CriticalPair& pair : found.pairs)
      {
        const CriticalPoint& extremum = found.points[pair.extremum];
        const CriticalPoint& saddle = found.points[pair.saddle];
        EXPECT_EQ(pair.persistence, std::abs(saddle.value - extremum.value));
        EXPECT_LE(pair.persistence, saddle.persistence);
        EXPECT_LE(++ended[pair.saddle], saddle.multiplicity);
        const bool isMinimum = extremum.type == CriticalType::Minimum;
        if (!isMinimum && extremum.type != CriticalType::Maximum)
        {
          continue; // a pair of saddles, see TestVolumePersistence
        }
        EXPECT_EQ(saddle.type, isMinimum ? CriticalType::Saddle : CriticalType::TwoSaddle);
        (isMinimum ? minima : maxima).emplace(extremum.input, saddle.input);
      }
      const std::vector<int> ranks = glued.ranks(values);
      const VertexPairs rising = pairsByMerging(glued, ranks, true);
      const VertexPairs falling = pairsByMerging(glued, ranks, false);
      EXPECT_TRUE(std::includes(rising.begin(), rising.end(), minima.begin(), minima.end()));
      EXPECT_TRUE(std::includes(falling.begin(), falling.end(), maxima.begin(), maxima.end()));
      EXPECT_TRUE(!named.isClosed || (minima == rising && maxima == falling));
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
