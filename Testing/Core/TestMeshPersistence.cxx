#include "LinkWalk.h"
#include "MeshCriticalPoints.h"
#include "MeshFunctions.h"
#include "ValueRanks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace SurfaceScalars::Truth
{
namespace
{

using VertexPairs = std::multiset<std::pair<std::size_t, std::size_t>>; ///< extremum and saddle

/// Persistence pairs by reduction of the boundary matrix over Z2, where each simplex comes with its
/// highest vertex: of vertices and edges (minima), and of edges and triangles (maxima).
struct ReducedPairs
{
  ReducedPairs(const TriangleMesh& mesh, const Values& values)
  {
    const std::vector<int> ranks = ranksOf(values);
    std::vector<std::size_t> vertexOf(ranks.size());
    std::set<std::vector<int>> simplices; // vertices by rank, descending; faces come before
    for (std::size_t i = 0; i < ranks.size(); ++i)
    {
      vertexOf[static_cast<std::size_t>(ranks[i])] = i;
      simplices.insert({ ranks[i] });
    }
    for (const auto& triangle : mesh.triangles)
    {
      std::vector<int> corners;
      for (const int vertex : triangle)
      {
        corners.push_back(ranks[static_cast<std::size_t>(vertex)]);
      }
      std::sort(corners.rbegin(), corners.rend());
      const auto [a, b, c] = std::tie(corners[0], corners[1], corners[2]);
      simplices.insert({ { a, b, c }, { a, b }, { a, c }, { b, c } });
    }
    std::map<std::vector<int>, std::set<std::vector<int>>> reduced; // by their last simplex
    for (const std::vector<int>& simplex : simplices)
    {
      std::set<std::vector<int>> column;
      for (std::size_t left = 0; simplex.size() > 1 && left < simplex.size(); ++left)
      {
        std::vector<int> face = simplex;
        face.erase(face.begin() + static_cast<std::ptrdiff_t>(left));
        column.insert(face);
      }
      for (auto found = reduced.end();
           !column.empty() && (found = reduced.find(*column.rbegin())) != reduced.end();)
      {
        for (const std::vector<int>& face : std::set<std::vector<int>>(found->second))
        {
          if (!column.insert(face).second)
          {
            column.erase(face);
          }
        }
      }
      if (column.empty())
      {
        continue;
      }
      const std::vector<int> born = *column.rbegin();
      reduced.emplace(born, std::move(column));
      const std::size_t birth = vertexOf[static_cast<std::size_t>(born[0])];
      const std::size_t death = vertexOf[static_cast<std::size_t>(simplex[0])];
      if (birth != death)
      {
        simplex.size() == 2 ? this->minima.emplace(birth, death)
                            : this->maxima.emplace(death, birth);
      }
    }
  }

  VertexPairs minima;
  VertexPairs maxima;
};

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

/// Glued to its mirror image along the boundary: images follow, that of a boundary vertex is
/// itself.
TriangleMesh mirrored(const TriangleMesh& mesh, std::vector<int>& images)
{
  int count = static_cast<int>(mesh.points.cols());
  const std::vector<OrderedLink> links = orderedLinks(mesh);
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    images.push_back(links[i].isClosed ? count++ : static_cast<int>(i));
  }
  TriangleMesh result = mesh;
  result.points.conservativeResize(3, count);
  for (std::size_t i = 0; i < images.size(); ++i)
  {
    result.points.col(images[i]) = mesh.points.col(static_cast<Eigen::Index>(i));
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const auto image = [&](int vertex) { return images[static_cast<std::size_t>(vertex)]; };
    result.triangles.push_back({ image(a), image(c), image(b) });
  }
  return result;
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
      const ReducedPairs expected(named.mesh, values);
      EXPECT_EQ(verticesOf(pairs.minima), expected.minima);
      if (named.isClosed)
      {
        EXPECT_EQ(verticesOf(pairs.maxima), expected.maxima);
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

// With boundary, points have the larger persistence of their two images on the surface glued to its
// mirror image; extrema that of their pairs on the surface itself. No saddle is in more pairs than
// its multiplicity.
TEST(MeshPersistence, boundariesAreMirrors)
{
  for (const TriangleMesh& mesh :
    { hemisphere(3), gridMesh(Grid::Cylinder, 15, 6), gridMesh(Grid::Moebius, 15, 6) })
  {
    const MeshTopology topology = topologyOf(mesh);
    std::vector<int> images;
    const TriangleMesh glued = mirrored(mesh, images);
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
      const Values values = randomValues(mesh, seed);
      Values gluedValues(glued.points.cols());
      for (std::size_t i = 0; i < images.size(); ++i)
      {
        gluedValues[static_cast<Eigen::Index>(i)] = gluedValues[images[i]] =
          values[static_cast<Eigen::Index>(i)];
      }
      const MeshCriticalPoints found = meshCriticalPoints(mesh.points, topology, values);
      std::map<std::size_t, double> expected;
      for (const CriticalPoint& point :
        meshCriticalPoints(glued.points, topologyOf(glued), gluedValues).points)
      {
        expected[point.input] = point.persistence;
      }
      std::map<std::size_t, double> ofPairs;
      const PersistencePairs pairs = persistencePairs(topology, values);
      for (const auto* ofKind : { &pairs.minima, &pairs.maxima })
      {
        for (const PersistencePair& pair : *ofKind)
        {
          ofPairs[pair.extremum] = pair.persistence;
        }
      }
      std::vector<int> left;
      for (const CriticalPoint& point : found.points)
      {
        EXPECT_EQ(point.persistence,
          std::max(
            expected.at(point.input), expected.at(static_cast<std::size_t>(images[point.input]))));
        if (point.type != CriticalType::Saddle)
        {
          const auto pair = ofPairs.find(point.input);
          EXPECT_EQ(point.persistence, pair == ofPairs.end() ? rangeOf(values) : pair->second);
        }
        left.push_back(point.multiplicity);
      }
      for (const CriticalPair& pair : found.pairs)
      {
        EXPECT_GE(--left[pair.saddle], 0);
        EXPECT_NE(found.points[pair.extremum].type, CriticalType::Saddle);
      }
    }
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
