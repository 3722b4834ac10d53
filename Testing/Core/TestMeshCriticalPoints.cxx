#include "Error.h"
#include "LinkWalk.h"
#include "MeshCriticalPoints.h"
#include "MeshFunctions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

std::vector<VertexType> listOf(const VertexTypes& types)
{
  std::vector<VertexType> list;
  for (std::size_t i = 0; i < types.types.size(); ++i)
  {
    list.push_back({ types.types[i], static_cast<int>(types.multiplicities[i]) });
  }
  return list;
}

/// Twice the sum of the indices, where those of boundary vertices count half.
std::int64_t doubleIndexSum(const MeshTopology& mesh, const VertexTypes& types)
{
  std::int64_t sum = 0;
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    sum += std::int64_t(mesh.isBoundary(vertex) ? 1 : 2) *
      indexOf(types.types[vertex], static_cast<int>(types.multiplicities[vertex]));
  }
  return sum;
}

// The middle vertices of triangles tell what a walk around each link tells, on closed surfaces, on
// those with boundary and on those with a twist, whatever the function.
TEST(MeshCriticalPoints, typesAreThoseOfAWalkAroundTheLinks)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    for (unsigned seed = 1; seed <= 5; ++seed)
    {
      const TriangleMesh mesh = shuffled(named.mesh, seed).mesh;
      const MeshTopology topology = topologyOf(mesh);
      const std::vector<OrderedLink> links = orderedLinks(mesh);
      for (const auto& [name, values] : meshFunctions(mesh, seed))
      {
        EXPECT_EQ(listOf(classifyVertices(topology, values)), typesByWalking(links, values))
          << named.name << ", " << name;
      }
    }
  }
}

// Euler's formula: the indices sum to the characteristic, where those of the boundary count half:
// glued to its mirror image the surface has twice the characteristic, and the boundary once.
TEST(MeshCriticalPoints, indicesSumToTheCharacteristic)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    const TriangleMesh fine = subdivided(named.mesh);
    const MeshTopology topology = topologyOf(fine);
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
      for (const auto& [name, values] : meshFunctions(fine, seed))
      {
        const VertexTypes types = classifyVertices(topology, values);
        EXPECT_EQ(doubleIndexSum(topology, types), 2 * named.eulerCharacteristic)
          << named.name << ", " << name;
        if (named.isClosed)
        {
          EXPECT_EQ(std::int64_t(types.counts.minima) - types.counts.saddles + types.counts.maxima,
            named.eulerCharacteristic);
        }
      }
    }
  }
}

// On a consistent numbering a constant function rises with the index: a minimum at the first vertex
// and a maximum at the last, in each component.
TEST(MeshCriticalPoints, constantFunctionsHaveExtrema)
{
  const TriangleMesh mesh = besideEachOther(subdividedSphere(2), gridMesh(Grid::Patch, 9, 9));
  const VertexTypes types =
    classifyVertices(topologyOf(mesh), Values::Constant(mesh.points.cols(), 1.0));
  EXPECT_GE(types.counts.minima, 2u);
  EXPECT_GE(types.counts.maxima, 2u);
  EXPECT_EQ(types.types.front(), CriticalType::Minimum);
  EXPECT_EQ(types.types.back(), CriticalType::Maximum);
}

// Counts are those of the vertices, saddles with their multiplicity.
TEST(MeshCriticalPoints, countsAddUp)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const VertexTypes types = classifyVertices(topologyOf(mesh), randomValues(mesh, 1));
  CriticalCounts counts;
  for (const VertexType& vertex : listOf(types))
  {
    counts.minima += vertex.type == CriticalType::Minimum ? 1 : 0;
    counts.maxima += vertex.type == CriticalType::Maximum ? 1 : 0;
    counts.saddles +=
      vertex.type == CriticalType::Saddle ? static_cast<Index>(vertex.multiplicity) : 0;
  }
  EXPECT_EQ(types.counts.minima, counts.minima);
  EXPECT_EQ(types.counts.saddles, counts.saddles);
  EXPECT_EQ(types.counts.maxima, counts.maxima);
  EXPECT_GT(counts.saddles, 100u);
}

// A vertex of 2k triangles around which f goes up and down is a saddle of multiplicity k - 1.
TEST(MeshCriticalPoints, saddlesMayHaveAnyMultiplicity)
{
  const int count = 200000;
  TriangleMesh wheel{ Points::Zero(3, count + 1), {} };
  Values values = Values::Zero(count + 1);
  for (int i = 0; i < count; ++i)
  {
    wheel.triangles.push_back({ i, (i + 1) % count, count });
    values[i] = i % 2 == 0 ? 1.0 : -1.0;
  }
  const MeshTopology topology = topologyOf(wheel);
  const VertexTypes types = classifyVertices(topology, values);
  EXPECT_EQ(types.multiplicities[count], 99999u);
  EXPECT_EQ(doubleIndexSum(topology, types), 2);
}

// f + constant, a multiple of f and the number of threads change nothing; -f swaps the extrema of a
// function of distinct values, and another numbering its vertices only.
TEST(MeshCriticalPoints, typesAreThoseOfTheFunction)
{
  const TriangleMesh mesh = gridMesh(Grid::Moebius, 400, 100);
  const MeshTopology topology = topologyOf(mesh);
  Values values = randomValues(mesh, 1);
  values = (values * 1e6).array().round();
  const std::vector<VertexType> types = listOf(classifyVertices(topology, values, { 1, {} }));
  EXPECT_EQ(listOf(classifyVertices(topology, values.array() + 12345.0)), types);
  EXPECT_EQ(listOf(classifyVertices(topology, values * 1e-3)), types);
  EXPECT_EQ(listOf(classifyVertices(topology, values, { 4, {} })), types);

  const Values distinct = randomValues(mesh, 2);
  std::vector<VertexType> expected = listOf(classifyVertices(topology, distinct));
  const ShuffledMesh other = shuffled(mesh, 3);
  Values renumbered(distinct.size());
  for (Eigen::Index i = 0; i < distinct.size(); ++i)
  {
    renumbered[other.names[static_cast<std::size_t>(i)]] = distinct[i];
  }
  const std::vector<VertexType> found =
    listOf(classifyVertices(topologyOf(other.mesh), renumbered));
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(found[static_cast<std::size_t>(other.names[i])], expected[i]);
  }
  for (VertexType& vertex : expected)
  {
    vertex.type = vertex.type == CriticalType::Minimum ? CriticalType::Maximum
      : vertex.type == CriticalType::Maximum           ? CriticalType::Minimum
                                                       : vertex.type;
  }
  EXPECT_EQ(listOf(classifyVertices(topology, -distinct)), expected);
}

// Values that are missing or not finite are refused with their vertex; whoever wants to stop is
// heard.
TEST(MeshCriticalPoints, refusesBadValues)
{
  const TriangleMesh mesh = subdividedSphere(1);
  const MeshTopology topology = topologyOf(mesh);
  Values values = randomValues(mesh, 1);
  EXPECT_THROW(classifyVertices(topology, values.head(3)), InvalidInput);
  EXPECT_THROW(meshCriticalPoints(mesh.points.leftCols(3), topology, values), InvalidInput);
  EXPECT_THROW(classifyVertices(topology, values, { 1, [](double) { return false; } }), Aborted);
  values[7] = std::numeric_limits<double>::quiet_NaN();
  try
  {
    persistencePairs(topology, values);
    FAIL();
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("nan at vertex 7"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
