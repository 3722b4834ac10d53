#include "GluedPairs.h"
#include "MeshCriticalPoints.h"
#include "MeshFunctions.h"
#include "ValueRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

namespace SurfaceScalars::Truth
{
namespace
{

using VertexPairs = std::multiset<std::pair<std::size_t, std::size_t>>; ///< extremum and saddle

/// Of vertices and edges: dimension 0; of edges and triangles: dimension 1.
VertexPairs verticesOf(const ReducedPairs& reduced, int dimension)
{
  VertexPairs vertices;
  for (const VertexPair& pair : reduced.pairs)
  {
    if (pair.dimension == dimension)
    {
      const auto [extremum, saddle] =
        dimension == 0 ? std::pair(pair.birth, pair.death) : std::pair(pair.death, pair.birth);
      vertices.emplace(extremum.first, saddle.first);
    }
  }
  return vertices;
}

VertexPairs verticesOf(const std::vector<PersistencePair>& pairs)
{
  VertexPairs vertices;
  for (const PersistencePair& pair : pairs)
  {
    vertices.emplace(pair.extremum, pair.saddle);
  }
  return vertices;
}

int indexSum(const std::vector<CriticalPoint>& points)
{
  return std::accumulate(points.begin(), points.end(), 0,
    [](int sum, const CriticalPoint& point) { return sum + indexOf(point); });
}

double rangeOf(const Values& values)
{
  return values.maxCoeff() - values.minCoeff();
}

/// A disk: what of the sphere is not below its equator.
TriangleMesh hemisphere(int levels)
{
  const TriangleMesh sphere = subdividedSphere(levels);
  TriangleMesh half;
  std::vector<int> names(static_cast<std::size_t>(sphere.points.cols()), -1);
  std::vector<Vector3d> points;
  for (std::array<int, 3> triangle : sphere.triangles)
  {
    if (std::any_of(triangle.begin(), triangle.end(),
          [&](int vertex) { return sphere.points(2, vertex) < 0.0; }))
    {
      continue;
    }
    for (int& vertex : triangle)
    {
      int& name = names[static_cast<std::size_t>(vertex)];
      if (name < 0)
      {
        name = static_cast<int>(points.size());
        points.push_back(sphere.points.col(vertex));
      }
      vertex = name;
    }
    half.triangles.push_back(triangle);
  }
  half.points =
    Eigen::Map<const Points>(points[0].data(), 3, static_cast<Eigen::Index>(points.size()));
  return half;
}

// On closed surfaces union-find finds the pairs of the reduction of the boundary matrix, from below
// those of vertices and edges, from above those of edges and triangles.
TEST(MeshPersistence, pairsAreThoseOfMatrixReduction)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    const MeshTopology topology = topologyOf(named.mesh);
    for (const auto& [name, values] : meshFunctions(named.mesh, 1))
    {
      SCOPED_TRACE(named.name + (", " + name));
      const PersistencePairs pairs = persistencePairs(topology, values);
      const ReducedPairs expected(topology.triangles(), values, Boundary::AsItIs);
      EXPECT_EQ(verticesOf(pairs.minima), verticesOf(expected, 0));
      if (named.isClosed)
      {
        EXPECT_EQ(verticesOf(pairs.maxima), verticesOf(expected, 1));
      }
      for (const PersistencePair& pair : pairs.maxima)
      {
        EXPECT_EQ(pair.persistence, values[pair.extremum] - values[pair.saddle]);
      }
    }
  }
}

// Points have the types, multiplicities and persistence that an independent union-find along the
// edges gives; what no pair cancels are a minimum, a maximum and twice as many saddles as handles.
TEST(MeshPersistence, pointsHaveThePersistenceOfTheirPairs)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    if (!named.isClosed)
    {
      continue;
    }
    const TriangleMesh mesh = subdivided(named.mesh);
    for (const auto& [name, values] : meshFunctions(mesh, 2))
    {
      SCOPED_TRACE(named.name + (", " + name));
      const MeshCriticalPoints found = meshCriticalPoints(mesh.points, topologyOf(mesh), values);
      const std::vector<CriticalPoint> expected = meshCriticalPoints(mesh, values);
      ASSERT_EQ(found.points.size(), expected.size());
      int cancelled = 0;
      for (std::size_t i = 0; i < expected.size(); ++i)
      {
        const CriticalPoint& point = found.points[i];
        EXPECT_EQ(point.input, expected[i].input);
        EXPECT_EQ(point.type, expected[i].type);
        EXPECT_EQ(point.multiplicity, expected[i].multiplicity);
        EXPECT_EQ(point.position, expected[i].position);
        EXPECT_EQ(point.value, expected[i].value);
        if (point.type == CriticalType::Saddle)
        {
          EXPECT_EQ(point.persistence, expected[i].persistence);
          cancelled += point.multiplicity;
        }
      }
      EXPECT_EQ(cancelled - static_cast<int>(found.pairs.size()), 2 - named.eulerCharacteristic);
    }
  }
}

// removeBelow() keeps the index sum of a closed mesh, and what a larger threshold keeps is among
// what a smaller one keeps, with no larger multiplicity.
TEST(MeshPersistence, removingPairsKeepsEulersSum)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    if (!named.isClosed)
    {
      continue;
    }
    const TriangleMesh mesh = subdivided(named.mesh);
    for (const auto& [name, values] : meshFunctions(mesh, 3))
    {
      const MeshCriticalPoints all = meshCriticalPoints(mesh.points, topologyOf(mesh), values);
      std::map<std::size_t, int> last;
      for (const CriticalPoint& point : all.points)
      {
        last[point.input] = point.multiplicity;
      }
      for (int step = 0; step <= 100; ++step)
      {
        std::vector<CriticalPoint> kept = all.points;
        removeBelow(kept, all.pairs, rangeOf(values) * (step / 100.0));
        ASSERT_EQ(indexSum(kept), named.eulerCharacteristic) << named.name << ", " << name;
        std::map<std::size_t, int> multiplicities;
        for (const CriticalPoint& point : kept)
        {
          EXPECT_GT(point.multiplicity, 0);
          EXPECT_LE(point.multiplicity, last.at(point.input));
          multiplicities[point.input] = point.multiplicity;
        }
        last = multiplicities;
      }
    }
  }
}

/// Meshes with boundary.
std::vector<TriangleMesh> openMeshes()
{
  std::vector<TriangleMesh> meshes{ hemisphere(3), gridMesh(Grid::Cylinder, 15, 6),
    gridMesh(Grid::Moebius, 15, 6) };
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    if (!named.isClosed)
    {
      meshes.push_back(named.mesh);
    }
  }
  return meshes;
}

const std::vector<CriticalType> Types{ CriticalType::Minimum, CriticalType::Saddle,
  CriticalType::Maximum };

/// Twice the sum of the indices, those of the boundary counted half.
std::int64_t doubleIndexSum(const std::vector<CriticalPoint>& points, const MeshTopology& topology)
{
  return std::accumulate(points.begin(), points.end(), std::int64_t(0),
    [&](std::int64_t sum, const CriticalPoint& point)
    {
      const bool isBoundary = topology.isBoundary(static_cast<Index>(point.input));
      return sum + indexOf(point) * (isBoundary ? 1 : 2);
    });
}

/// The sum of the indices of what either a vertex or its image keeps.
/// @param persistences of both, by point
int oneSided(const std::vector<CriticalPoint>& points,
  const std::vector<std::vector<double>>& persistences, double threshold,
  const MeshTopology& topology)
{
  int sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto isThere = std::count_if(persistences[i].begin(), persistences[i].end(),
      [=](double persistence) { return persistence >= threshold; });
    if (isThere % 2 != 0 && !topology.isBoundary(static_cast<Index>(points[i].input)))
    {
      sum += indexOf(points[i].type, 1);
    }
  }
  return sum;
}

// With boundary, pairs are some of those of the reduction of the boundary matrix on the surface
// glued to its mirror image. A threshold keeps what is persistent on either side, and nothing else.
TEST(MeshPersistence, boundariesAreMirrors)
{
  for (const TriangleMesh& mesh : openMeshes())
  {
    const MeshTopology topology = topologyOf(mesh);
    for (unsigned seed = 1; seed <= 3; ++seed)
    {
      for (const auto& [name, values] : meshFunctions(mesh, seed))
      {
        SCOPED_TRACE(name);
        const TypedPairs expected =
          typedPairs(ReducedPairs(topology.triangles(), values, Boundary::Mirrored).pairs, Types);
        const MeshCriticalPoints found = meshCriticalPoints(mesh.points, topology, values);
        const TypedPairs pairs = typedPairs(found);
        EXPECT_TRUE(std::includes(expected.begin(), expected.end(), pairs.begin(), pairs.end()));
        expectHalfOfGlued(found, expected, topology, values);
      }
    }
  }
}

// The persistence of an extremum is that of its pair on the surface itself.
TEST(MeshPersistence, extremaHaveThatOfTheSurfaceItself)
{
  for (const TriangleMesh& mesh : openMeshes())
  {
    const MeshTopology topology = topologyOf(mesh);
    for (const auto& [name, values] : meshFunctions(mesh, 1))
    {
      std::map<std::size_t, double> expected;
      const PersistencePairs pairs = persistencePairs(topology, values);
      for (const auto* ofKind : { &pairs.minima, &pairs.maxima })
      {
        for (const PersistencePair& pair : *ofKind)
        {
          expected[pair.extremum] = pair.persistence;
        }
      }
      for (const CriticalPoint& point : meshCriticalPoints(mesh.points, topology, values).points)
      {
        const auto pair = expected.find(point.input);
        if (point.type != CriticalType::Saddle && pair != expected.end())
        {
          EXPECT_EQ(point.persistence, pair->second);
        }
        else if (point.type != CriticalType::Saddle)
        {
          EXPECT_EQ(point.persistence, rangeOf(values));
        }
      }
    }
  }
}

// Whatever the threshold, the sum of the indices, those of the boundary counted half, is Euler's
// characteristic and half of the indices of what is kept on one side only. Where the boundary is
// higher than all else, that is nothing, but for the global minimum.
TEST(MeshPersistence, boundariesKeepEulersSumButForOneSidedPoints)
{
  for (const TriangleMesh& mesh : openMeshes())
  {
    const MeshTopology topology = topologyOf(mesh);
    for (const auto& [name, values] : meshFunctions(mesh, 1))
    {
      SCOPED_TRACE(name);
      const MeshCriticalPoints all = meshCriticalPoints(mesh.points, topology, values);
      const TypedPairs glued =
        typedPairs(ReducedPairs(topology.triangles(), values, Boundary::Mirrored).pairs, Types);
      const std::vector<std::vector<double>> persistences =
        gluedPersistences(all, glued, topology, values);
      for (int step = 0; step <= 20; ++step)
      {
        const double threshold = rangeOf(values) * (step / 20.0);
        std::vector<CriticalPoint> kept = all.points;
        removeBelow(kept, all.pairs, threshold);
        EXPECT_EQ(doubleIndexSum(kept, topology),
          2 * topology.eulerCharacteristic() +
            oneSided(all.points, persistences, threshold, topology));
      }
    }
  }
  const TriangleMesh bowl = hemisphere(4);
  const MeshTopology topology = topologyOf(bowl);
  Values values = randomValues(bowl, 1);
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    values[i] = topology.isBoundary(static_cast<Index>(i)) ? 10.0 - bowl.points(0, i) : values[i];
  }
  const MeshCriticalPoints all = meshCriticalPoints(bowl.points, topology, values);
  for (int step = 0; step <= 20; ++step)
  {
    std::vector<CriticalPoint> kept = all.points;
    removeBelow(kept, all.pairs, 0.5 * rangeOf(values) * (step / 20.0));
    EXPECT_EQ(doubleIndexSum(kept, topology), 2);
  }
}

// f + constant and the number of threads change nothing; persistence scales with f, and another
// numbering of the vertices gives the same pairs.
TEST(MeshPersistence, isThatOfTheFunction)
{
  const TriangleMesh mesh = plateWithHoles(3, 3);
  const MeshTopology topology = topologyOf(mesh);
  const Values values = (randomValues(mesh, 1) * 1e9).array().round();
  const PersistencePairs pairs = persistencePairs(topology, values, { 1, {} });
  const Values moved = (4.0 * values).array() + 4096.0;
  const PersistencePairs others = persistencePairs(topology, moved, { 4, {} });
  EXPECT_EQ(verticesOf(pairs.minima), verticesOf(others.minima));
  EXPECT_EQ(verticesOf(pairs.maxima), verticesOf(others.maxima));
  for (std::size_t i = 0; i < pairs.minima.size(); ++i)
  {
    EXPECT_EQ(others.minima[i].persistence, 4.0 * pairs.minima[i].persistence);
  }

  const ShuffledMesh other = shuffled(mesh, 2);
  Values renumbered(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    renumbered[other.names[static_cast<std::size_t>(i)]] = values[i];
  }
  VertexPairs expected;
  for (const auto& [extremum, saddle] : verticesOf(pairs.minima))
  {
    expected.emplace(other.names[extremum], other.names[saddle]);
  }
  EXPECT_EQ(verticesOf(persistencePairs(topologyOf(other.mesh), renumbered).minima), expected);
}

} // namespace
} // namespace SurfaceScalars::Truth
