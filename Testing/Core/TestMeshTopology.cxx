#include "Error.h"
#include "LinkWalk.h"
#include "MeshTopology.h"
#include "Meshes.h"
#include "Sampling.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// The same cycle, wherever it begins and whichever way it goes, or the same path.
void expectSameLink(std::vector<int> link, const OrderedLink& expected, bool isBoundary)
{
  ASSERT_EQ(isBoundary, !expected.isClosed);
  ASSERT_EQ(link.size(), expected.vertices.size());
  if (expected.isClosed)
  {
    std::rotate(
      link.begin(), std::find(link.begin(), link.end(), expected.vertices[0]), link.end());
  }
  if (link != expected.vertices)
  {
    std::reverse(link.begin() + (expected.isClosed ? 1 : 0), link.end());
  }
  EXPECT_EQ(link, expected.vertices);
}

/// The sentence with which a mesh is refused.
std::string refusal(Index vertexCount, const std::vector<std::array<int, 3>>& triangles,
  const VertexName& nameOf = {})
{
  try
  {
    const MeshTopology mesh(vertexCount, trianglesOf({ {}, triangles }), {}, nameOf);
    return "taken";
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
}

void expectIn(const std::string& part, const std::string& sentence)
{
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

// Links are those found by walking around each vertex, whatever the order of vertices and triangles
// and the direction of each triangle; V - E + F is what the surface has.
TEST(MeshTopology, linksGoAround)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    for (const TriangleMesh& mesh : { named.mesh, shuffled(named.mesh, 1).mesh })
    {
      SCOPED_TRACE(named.name);
      const MeshTopology topology = topologyOf(mesh);
      const std::vector<OrderedLink> expected = orderedLinks(mesh);
      EXPECT_EQ(topology.isClosed(), named.isClosed);
      EXPECT_EQ(topology.eulerCharacteristic(), named.eulerCharacteristic);
      EXPECT_EQ(topology.eulerCharacteristic(), mesh.eulerCharacteristic());
      EXPECT_EQ(topology.componentCount(), 1u);
      for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
      {
        const VertexRange link = topology.link(vertex);
        expectSameLink({ link.begin(), link.end() }, expected[vertex], topology.isBoundary(vertex));
      }
    }
  }
}

// A path along the edges of the link comes back to where it begins exactly around interior
// vertices; on a consistently oriented mesh all links go around the same way.
TEST(MeshTopology, linksFollowTheOrientation)
{
  const TriangleMesh mesh = subdividedSphere(2);
  const MeshTopology topology = topologyOf(mesh);
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    const VertexRange path = topology.linkPath(vertex);
    EXPECT_EQ(path.size(), topology.link(vertex).size() + 1);
    EXPECT_EQ(*path.begin(), *(path.end() - 1));
    for (const Index* next = path.begin(); next + 1 != path.end(); ++next)
    {
      Eigen::Matrix3d corners;
      corners << mesh.points.col(vertex), mesh.points.col(next[0]), mesh.points.col(next[1]);
      EXPECT_GT(corners.determinant(), 0.0);
    }
  }
}

// Components are numbered by their first vertices, and their characteristics add up.
TEST(MeshTopology, componentsAreCounted)
{
  const TriangleMesh sphere = subdividedSphere(1);
  const TriangleMesh mesh =
    besideEachOther(besideEachOther(sphere, plateWithHoles(2, 0)), gridMesh(Grid::Patch, 2, 2));
  const MeshTopology topology = topologyOf(mesh);
  EXPECT_EQ(topology.componentCount(), 3u);
  EXPECT_EQ(topology.eulerCharacteristic(), 2 - 2 + 1);
  const auto sphereCount = static_cast<Index>(sphere.points.cols());
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    const Index expected = vertex < sphereCount ? 0 : vertex + 9 < topology.vertexCount() ? 1 : 2;
    EXPECT_EQ(topology.component(vertex), expected);
  }
}

// A vertex may have any number of triangles: links of 100000 vertices take no longer than others.
TEST(MeshTopology, aVertexMayHaveManyTriangles)
{
  const int count = 100000;
  TriangleMesh wheel{ Points::Zero(3, count + 1), {} };
  for (int i = 0; i < count; ++i)
  {
    wheel.triangles.push_back({ i, (i + 1) % count, count });
  }
  wheel = shuffled(wheel, 2).mesh;
  const MeshTopology topology = topologyOf(wheel);
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  Index most = 0;
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    most = std::max(most, topology.link(vertex).size());
  }
  EXPECT_EQ(most, static_cast<Index>(count));
}

// Two triangles on the same three vertices are a sphere.
TEST(MeshTopology, twoTrianglesMayMakeASphere)
{
  const MeshTopology topology(3, trianglesOf({ {}, { { 0, 1, 2 }, { 0, 2, 1 } } }));
  EXPECT_TRUE(topology.isClosed());
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  EXPECT_EQ(topology.link(0).size(), 2u);
}

// The number of threads changes nothing, and a refused mesh is refused at its first bad vertex.
TEST(MeshTopology, threadsChangeNothing)
{
  TriangleMesh mesh = shuffled(gridMesh(Grid::Moebius, 300, 200), 3).mesh;
  const MeshTopology one = topologyOf(mesh, 1);
  const MeshTopology four = topologyOf(mesh, 4);
  for (Index vertex = 0; vertex < one.vertexCount(); ++vertex)
  {
    const VertexRange link = four.linkPath(vertex);
    ASSERT_TRUE(std::equal(
      link.begin(), link.end(), one.linkPath(vertex).begin(), one.linkPath(vertex).end()));
  }
  mesh.triangles.push_back(mesh.triangles[70000]);
  mesh.triangles.push_back(mesh.triangles[100]);
  const auto sentence = [&](int threadCount) -> std::string
  {
    try
    {
      topologyOf(mesh, threadCount);
    }
    catch (const InvalidInput& error)
    {
      return error.what();
    }
    return "taken";
  };
  expectIn("edge between vertices", sentence(1));
  EXPECT_EQ(sentence(1), sentence(4));
}

// What is no manifold is refused with a vertex, by the caller's name for it.
TEST(MeshTopology, refusesWithAVertex)
{
  const auto named = [](Index vertex) { return std::size_t(vertex) + 100; };
  expectIn(
    "needs triangles, found none. Choose a mesh, or a filter for point sets.", refusal(3, {}));
  expectIn("needs corners below 3, the number of vertices, found 3 in triangle 1",
    refusal(3, { { 0, 1, 2 }, { 0, 1, 3 } }, named));
  expectIn("vertex 101 twice in triangle 1", refusal(3, { { 0, 1, 2 }, { 1, 0, 1 } }, named));
  expectIn("none at vertex 103", refusal(4, { { 0, 1, 2 } }, named));
  expectIn("more at the edge between vertices 100 and 101",
    refusal(5, { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } }, named));
  expectIn("several fans of the 2 triangles at vertex 102",
    refusal(5, { { 0, 1, 2 }, { 2, 3, 4 } }, named));
  expectIn("several fans of the 6 triangles at vertex 0", // two closed ones
    refusal(7,
      { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 2, 3 }, { 0, 4, 5 }, { 0, 5, 6 }, { 0, 6, 4 },
        { 4, 5, 6 } }));
}

// Whoever wants to stop is heard.
TEST(MeshTopology, canBeStopped)
{
  const TriangleMesh mesh = gridMesh(Grid::Torus, 100, 100);
  for (const double limit : { 0.0, 0.2, 0.5, 0.9 })
  {
    const Execution execution{ 1, [=](double fraction) { return fraction < limit; } };
    EXPECT_THROW(MeshTopology(10000, trianglesOf(mesh), execution), Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
