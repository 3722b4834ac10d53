#include "DisjointSets.h"
#include "Error.h"
#include "Functions.h"
#include "LinkWalk.h"
#include "Meshes.h"
#include "MorseComplex.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace SurfaceScalars::Truth
{
namespace
{

/// A mesh with a function, its complex, and what the test walks along.
struct Example
{
  Example(TriangleMesh triangleMesh, const Values& function, double threshold = 0.0)
    : mesh(std::move(triangleMesh))
    , topology(static_cast<Index>(mesh.points.cols()), trianglesOf(mesh))
    , links(orderedLinks(mesh))
    , complex(morseComplex(mesh.points, topology, function, threshold))
  {
  }

  bool isBelow(Index a, Index b) const
  {
    return std::make_pair(this->complex.values[a], a) < std::make_pair(this->complex.values[b], b);
  }
  bool isNext(Index a, Index b) const
  {
    const std::vector<int>& link = this->links[a].vertices;
    return std::find(link.begin(), link.end(), static_cast<int>(b)) != link.end();
  }
  Index vertexOf(std::size_t node) const
  {
    return static_cast<Index>(this->complex.nodes[node].input);
  }

  TriangleMesh mesh;
  MeshTopology topology;
  std::vector<OrderedLink> links;
  MorseComplex complex;
};

Values noise(const TriangleMesh& mesh, unsigned seed)
{
  Random random(seed);
  Values values(mesh.points.cols());
  std::generate(values.begin(), values.end(), [&]() { return random.uniform(); });
  return values;
}

std::vector<TriangleMesh> closedMeshes()
{
  return { subdividedSphere(3), gridMesh(Grid::Torus, 20, 13), plateWithHoles(3, 1) };
}

std::vector<TriangleMesh> openMeshes()
{
  return { gridMesh(Grid::Patch, 15, 12), gridMesh(Grid::Moebius, 18, 5),
    besideEachOther(gridMesh(Grid::Cylinder, 12, 6), subdividedSphere(2)) };
}

std::vector<Example> noisyExamples()
{
  std::vector<Example> examples;
  for (const std::vector<TriangleMesh>& meshes : { closedMeshes(), openMeshes() })
  {
    for (const TriangleMesh& mesh : meshes)
    {
      for (const double threshold : { 0.0, 0.3, 0.7 })
      {
        examples.emplace_back(mesh, noise(mesh, 1), threshold);
      }
    }
  }
  return examples;
}

/// How many components the part of the link has that is lower, or higher.
std::size_t linkComponents(const Example& example, Index vertex, bool lower)
{
  const OrderedLink& link = example.links[vertex];
  const auto isIn = [&](std::size_t i)
  { return example.isBelow(static_cast<Index>(link.vertices[i]), vertex) == lower; };
  std::size_t count = 0;
  for (std::size_t i = 0; i < link.vertices.size(); ++i)
  {
    const bool isFirst = i == 0 && !link.isClosed;
    const std::size_t last = i == 0 ? link.vertices.size() - 1 : i - 1;
    count += isIn(i) && (isFirst || !isIn(last)) ? 1 : 0;
  }
  return count;
}

// From each saddle one path for each component of its lower and of its upper link: m + 1 of each
// inside the mesh, m + 2 together on the boundary.
TEST(MorseComplex, saddlesSendOnePathIntoEachSector)
{
  for (const Example& example : noisyExamples())
  {
    std::map<std::pair<std::size_t, bool>, std::size_t> counts;
    for (const Separatrix& separatrix : example.complex.separatrices)
    {
      ++counts[{ separatrix.source, separatrix.ascending }];
    }
    for (std::size_t i = 0; i < example.complex.nodes.size(); ++i)
    {
      const CriticalPoint& node = example.complex.nodes[i];
      const bool isSaddle = node.type == CriticalType::Saddle;
      const Index vertex = example.vertexOf(i);
      const std::size_t down = counts[{ i, false }];
      const std::size_t up = counts[{ i, true }];
      EXPECT_EQ(down, isSaddle ? linkComponents(example, vertex, true) : 0);
      EXPECT_EQ(up, isSaddle ? linkComponents(example, vertex, false) : 0);
      if (isSaddle)
      {
        const bool isBoundary = example.topology.isBoundary(vertex);
        EXPECT_EQ(
          down + up, static_cast<std::size_t>(node.multiplicity) * (isBoundary ? 1 : 2) + 2);
      }
    }
  }
}

/// The steepest way from a vertex, ties to the last vertex; the vertex itself if there is none.
Index steepest(const Example& example, Index vertex, bool ascending)
{
  Index best = vertex;
  double slope = -1.0;
  for (const int index : example.links[vertex].vertices)
  {
    const auto neighbor = static_cast<Index>(index);
    if (example.isBelow(neighbor, vertex) == ascending)
    {
      continue;
    }
    const double rise =
      std::abs(example.complex.values[neighbor] - example.complex.values[vertex]) /
      (example.mesh.points.col(neighbor) - example.mesh.points.col(vertex)).norm();
    if (rise > slope || (rise == slope && example.isBelow(neighbor, best) != ascending))
    {
      slope = rise;
      best = neighbor;
    }
  }
  return best;
}

// Paths go along edges, always the steepest way, strictly downwards or upwards, from a saddle to an
// extremum: from each vertex there is one way, so that paths that meet go on together.
TEST(MorseComplex, pathsAreSteepest)
{
  for (const Example& example : noisyExamples())
  {
    for (const Separatrix& separatrix : example.complex.separatrices)
    {
      const std::vector<Index>& path = separatrix.vertices;
      ASSERT_GE(path.size(), 2u);
      EXPECT_EQ(path.front(), example.vertexOf(separatrix.source));
      EXPECT_EQ(path.back(), example.vertexOf(separatrix.destination));
      EXPECT_EQ(example.complex.nodes[separatrix.destination].type,
        separatrix.ascending ? CriticalType::Maximum : CriticalType::Minimum);
      EXPECT_EQ(separatrix.persistence,
        std::abs(example.complex.values[path.front()] - example.complex.values[path.back()]));
      EXPECT_TRUE(example.isNext(path[0], path[1]));
      EXPECT_EQ(example.isBelow(path[0], path[1]), separatrix.ascending);
      for (std::size_t i = 1; i < path.size(); ++i)
      {
        const Index next = i + 1 < path.size() ? path[i + 1] : path[i];
        EXPECT_EQ(next, steepest(example, path[i], separatrix.ascending));
      }
    }
  }
}

// Of the paths of a saddle in one direction one is the steepest of all ways from it, and all begin
// in different sectors.
TEST(MorseComplex, pathsOfASaddleBeginSteepest)
{
  for (const Example& example : noisyExamples())
  {
    std::map<std::pair<std::size_t, bool>, std::set<Index>> starts;
    for (const Separatrix& separatrix : example.complex.separatrices)
    {
      std::set<Index>& known = starts[{ separatrix.source, separatrix.ascending }];
      EXPECT_TRUE(known.insert(separatrix.vertices[1]).second);
    }
    for (const auto& [from, vertices] : starts)
    {
      EXPECT_EQ(vertices.count(steepest(example, example.vertexOf(from.first), from.second)), 1u);
    }
  }
}

// The minima of a connected surface are joined by the descending paths of its saddles, and the
// maxima by the ascending ones: none is forgotten.
TEST(MorseComplex, extremaAreJoined)
{
  for (const Example& example : noisyExamples())
  {
    for (const bool ascending : { false, true })
    {
      DisjointSets sets(static_cast<Index>(example.complex.nodes.size()));
      std::map<std::size_t, Index> ends;
      for (const Separatrix& separatrix : example.complex.separatrices)
      {
        if (separatrix.ascending != ascending)
        {
          continue;
        }
        const auto extremum = static_cast<Index>(separatrix.destination);
        const Index other = ends.emplace(separatrix.source, extremum).first->second;
        if (sets.find(extremum) != sets.find(other))
        {
          sets.attach(sets.find(extremum), sets.find(other));
        }
      }
      std::set<Index> roots;
      for (Index i = 0; i < static_cast<Index>(example.complex.nodes.size()); ++i)
      {
        if (example.complex.nodes[i].type ==
          (ascending ? CriticalType::Maximum : CriticalType::Minimum))
        {
          roots.insert(sets.find(i));
        }
      }
      EXPECT_EQ(roots.size(), example.topology.componentCount());
    }
  }
}

// The tilted torus: one minimum, two saddles of the handle, one maximum, and four paths each way.
TEST(MorseComplex, ofATiltedTorus)
{
  const TriangleMesh torus = gridMesh(Grid::Torus, 80, 40);
  const Example example(torus, valuesOf(tiltedHeight(), torus.points));
  std::map<CriticalType, int> counts;
  for (const CriticalPoint& node : example.complex.nodes)
  {
    ++counts[node.type];
  }
  EXPECT_EQ(counts[CriticalType::Minimum], 1);
  EXPECT_EQ(counts[CriticalType::Saddle], 2);
  EXPECT_EQ(counts[CriticalType::Maximum], 1);
  ASSERT_EQ(example.complex.separatrices.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i)
  {
    EXPECT_EQ(example.complex.separatrices[i].ascending, i % 4 >= 2) << "descending ones first";
  }
}

// Noise of 5% makes thousands of nodes; without those of less persistence the complex has the nodes
// of the tilted torus again, and the range as threshold leaves the least that the genus allows.
TEST(MorseComplex, isSimplifiedByPersistence)
{
  const TriangleMesh torus = gridMesh(Grid::Torus, 80, 40);
  Values values = valuesOf(tiltedHeight(), torus.points);
  addNoise(values, 0.05 * (values.maxCoeff() - values.minCoeff()), 1);
  const double range = values.maxCoeff() - values.minCoeff();
  EXPECT_GT(Example(torus, values).complex.nodes.size(), 1000u);
  for (const double threshold : { 0.6 * range, range })
  {
    const Example example(torus, values, threshold);
    EXPECT_EQ(example.complex.nodes.size(), 4u);
    EXPECT_EQ(example.complex.separatrices.size(), 8u);
  }
  const TriangleMesh plate = plateWithHoles(3, 2);
  const Values rough = noise(plate, 2);
  const Example example(plate, rough, rough.maxCoeff() - rough.minCoeff());
  int multiplicities = 0;
  for (const CriticalPoint& node : example.complex.nodes)
  {
    multiplicities += node.type == CriticalType::Saddle ? node.multiplicity : 0;
  }
  EXPECT_EQ(multiplicities, 6) << "genus 3";
}

// Constant functions and vertices at the same place have a complex, too.
TEST(MorseComplex, ofDegenerateInput)
{
  TriangleMesh plate = plateWithHoles(2, 1);
  plate.points.setZero();
  const Example example(plate, Values::Zero(plate.points.cols()));
  for (const Separatrix& separatrix : example.complex.separatrices)
  {
    EXPECT_EQ(separatrix.persistence, 0.0);
    EXPECT_EQ(example.complex.nodes[separatrix.destination].type,
      separatrix.ascending ? CriticalType::Maximum : CriticalType::Minimum);
  }
}

// Thresholds that no function has are refused.
TEST(MorseComplex, refusesThresholds)
{
  const TriangleMesh mesh = subdividedSphere(1);
  const Values values = noise(mesh, 1);
  for (const double threshold : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(Example(mesh, values, threshold), InvalidInput);
  }
  EXPECT_THROW(Example(mesh, values.head(3)), InvalidInput);
}

// The number of threads changes nothing.
TEST(MorseComplex, doesNotDependOnThreads)
{
  const TriangleMesh mesh = plateWithHoles(2, 3);
  const MeshTopology topology(static_cast<Index>(mesh.points.cols()), trianglesOf(mesh));
  const Values values = noise(mesh, 3);
  const MorseComplex one = morseComplex(mesh.points, topology, values, 0.2, { 1, {} });
  const MorseComplex two = morseComplex(mesh.points, topology, values, 0.2, { 2, {} });
  ASSERT_EQ(one.separatrices.size(), two.separatrices.size());
  EXPECT_GT(one.separatrices.size(), 1000u);
  for (std::size_t i = 0; i < one.separatrices.size(); ++i)
  {
    EXPECT_EQ(one.separatrices[i].source, two.separatrices[i].source);
    EXPECT_EQ(one.separatrices[i].vertices, two.separatrices[i].vertices);
  }
  EXPECT_EQ(one.values, two.values);
}

} // namespace
} // namespace SurfaceScalars::Truth
