#include "Error.h"
#include "MeshExamples.h"
#include "StarRefinement.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace SurfaceScalars::Truth
{
namespace
{

using Needed = std::vector<NeededLink>;

TriangleMesh tetrahedron()
{
  TriangleMesh mesh{ Points(3, 4), { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } };
  mesh.points << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  return mesh;
}

MeshTopology topologyOf(const RefinedMesh& mesh)
{
  return MeshTopology(static_cast<Index>(mesh.vertices.cols()), mesh.triangles);
}

Vector3d areaVector(const Points& points, const Triangles& triangles, Eigen::Index triangle)
{
  const auto corners = triangles.col(triangle);
  const Vector3d origin = points.col(corners[0]);
  return (points.col(corners[1]) - origin).cross(points.col(corners[2]) - origin) / 2.0;
}

/// As many neighbors as a saddle of this multiplicity has at least: for 2 + 2m changes of sign
/// around it, on the boundary for m + 1 along its link.
NeededLink saddleAt(const MeshTopology& mesh, Index vertex, Index multiplicity)
{
  return { vertex, mesh.isBoundary(vertex) ? multiplicity + 2 : 2 + 2 * multiplicity };
}

/// Some vertices, neighbors among them.
Needed randomSaddles(const MeshTopology& mesh, unsigned seed)
{
  Random random(seed);
  const auto anyOf = [&](Index count) { return static_cast<Index>(random.uniform(0.0, count)); };
  Needed needed;
  for (int i = 0; i < 6; ++i)
  {
    needed.push_back(saddleAt(mesh, anyOf(mesh.vertexCount()), 1 + anyOf(3)));
    const VertexRange link = mesh.link(needed.back().vertex);
    needed.push_back(saddleAt(mesh, link.begin()[anyOf(link.size())], 1 + anyOf(3)));
  }
  return needed;
}

void expectPartsOf(const TriangleMesh& mesh, const RefinedMesh& refined)
{
  const Triangles triangles = trianglesOf(mesh);
  std::vector<Vector3d> sums(mesh.triangles.size(), Vector3d::Zero());
  std::vector<int> counts(mesh.triangles.size());
  for (Eigen::Index i = 0; i < refined.triangles.cols(); ++i)
  {
    const Index origin = refined.origins[static_cast<std::size_t>(i)];
    const Vector3d whole = areaVector(mesh.points, triangles, origin);
    const Vector3d part = areaVector(refined.vertices, refined.triangles, i);
    EXPECT_GT(part.dot(whole), 0.0);
    EXPECT_LE(part.cross(whole).norm(), 1e-12 * whole.squaredNorm());
    sums[origin] += part;
    ++counts[origin];
  }
  for (Eigen::Index i = 0; i < triangles.cols(); ++i)
  {
    const Vector3d whole = areaVector(mesh.points, triangles, i);
    EXPECT_LE((sums[static_cast<std::size_t>(i)] - whole).norm(), 1e-12 * whole.norm());
  }
  for (Eigen::Index i = 0; i < refined.triangles.cols(); ++i)
  {
    const auto place = static_cast<std::size_t>(i);
    EXPECT_EQ(refined.isSplit[place] != 0, counts[refined.origins[place]] > 1);
  }
}

/// Vertices of the mesh stay, added ones are where EdgeVertex says.
void expectAddedVertices(const TriangleMesh& mesh, const RefinedMesh& refined)
{
  const Eigen::Index count = mesh.points.cols();
  ASSERT_EQ(refined.vertices.cols(), count + static_cast<Eigen::Index>(refined.added.size()));
  EXPECT_EQ(refined.vertices.leftCols(count), mesh.points);
  for (std::size_t i = 0; i < refined.added.size(); ++i)
  {
    const EdgeVertex& added = refined.added[i];
    const Eigen::Index own = count + static_cast<Eigen::Index>(i);
    ASSERT_LT(std::max(added.from, added.to), own);
    const Vector3d from = refined.vertices.col(added.from);
    const Vector3d to = refined.vertices.col(added.to);
    EXPECT_LE((from + added.fraction * (to - from) - refined.vertices.col(own)).norm(),
      1e-14 * (from.norm() + to.norm()));
  }
}

std::string refusal(const TriangleMesh& mesh, const Needed& needed)
{
  try
  {
    refineStars(mesh.points, topologyOf(mesh), needed, [](Index v) { return v + 100; });
    return "taken";
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
}

// On every mesh, for vertices in need anywhere and next to each other, each gets what it needs and
// none loses neighbors; the parts of a triangle lie in its plane, run its way and sum up to it;
// the result is a manifold of the same components and Euler characteristic.
TEST(StarRefinement, keepsTheSurface)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    SCOPED_TRACE(named.name);
    for (unsigned seed = 0; seed < 5; ++seed)
    {
      const MeshTopology before = topologyOf(named.mesh);
      const Needed needed = randomSaddles(before, seed);
      const RefinedMesh refined = refineStars(named.mesh.points, before, needed);
      const MeshTopology after = topologyOf(refined);
      EXPECT_EQ(after.eulerCharacteristic(), named.eulerCharacteristic);
      EXPECT_EQ(after.isClosed(), named.isClosed);
      EXPECT_EQ(after.componentCount(), before.componentCount());
      for (const NeededLink& need : needed)
      {
        EXPECT_GE(after.link(need.vertex).size(), need.size);
      }
      for (Index vertex = 0; vertex < before.vertexCount(); ++vertex)
      {
        EXPECT_GE(after.link(vertex).size(), before.link(vertex).size());
        EXPECT_EQ(after.isBoundary(vertex), before.isBoundary(vertex));
      }
      expectPartsOf(named.mesh, refined);
      expectAddedVertices(named.mesh, refined);
    }
  }
}

// Where nothing is needed nothing changes.
TEST(StarRefinement, leavesWhatSuffices)
{
  const TriangleMesh mesh = gridMesh(Grid::Torus, 6, 5);
  const RefinedMesh refined = refineStars(mesh.points, topologyOf(mesh), { { 3, 6 }, { 4, 1 } });
  EXPECT_TRUE(refined.added.empty());
  EXPECT_EQ(refined.vertices, mesh.points);
  EXPECT_EQ(refined.triangles, trianglesOf(mesh));
  EXPECT_EQ(std::count(refined.isSplit.begin(), refined.isSplit.end(), 1), 0);
}

// One vertex gets an equal number of neighbors in each of its triangles, as few as suffice: a
// multiple of what it has. Only triangles at the edges of its link are split, into that many.
TEST(StarRefinement, dividesAlike)
{
  const TriangleMesh mesh = subdividedSphere(3);
  const MeshTopology before = topologyOf(mesh);
  for (const Index vertex : { Index(0), Index(60) }) // of 4 and 6 neighbors
  {
    const Index size = before.link(vertex).size();
    for (Index parts = 2; parts <= 4; ++parts)
    {
      const RefinedMesh refined =
        refineStars(mesh.points, before, { { vertex, (parts - 1) * size + 1 } });
      EXPECT_EQ(topologyOf(refined).link(vertex).size(), parts * size);
      EXPECT_EQ(refined.added.size(), std::size_t(parts - 1) * size);
      EXPECT_EQ(std::count(refined.isSplit.begin(), refined.isSplit.end(), 1),
        std::ptrdiff_t(2) * size * parts);
    }
  }
}

// A saddle of multiplicity 3 needs 8 neighbors, which a corner of a tetrahedron gets from its 3 by
// thirds of the opposite edges, all of one triangle; and so do all four corners at once.
TEST(StarRefinement, giveCornersOfATetrahedronMultiplicityThree)
{
  const TriangleMesh mesh = tetrahedron();
  const RefinedMesh one = refineStars(mesh.points, topologyOf(mesh), { { 3, 8 } });
  EXPECT_EQ(topologyOf(one).link(3).size(), 9u);
  EXPECT_EQ(one.vertices.cols(), 4 + 6);
  expectPartsOf(mesh, one);

  const Needed all = { { 0, 8 }, { 1, 8 }, { 2, 8 }, { 3, 8 } };
  const RefinedMesh refined = refineStars(mesh.points, topologyOf(mesh), all);
  const MeshTopology topology = topologyOf(refined);
  EXPECT_EQ(topology.eulerCharacteristic(), 2);
  for (Index vertex = 0; vertex < 4; ++vertex)
  {
    EXPECT_GE(topology.link(vertex).size(), 8u);
  }
  expectPartsOf(mesh, refined);
}

// Where two vertices face the same edge it is divided for both at once, in the larger number of
// parts; each has what the other's share of that edge adds.
TEST(StarRefinement, sharesEdges)
{
  const TriangleMesh mesh = subdividedSphere(0); // an octahedron
  const MeshTopology topology = topologyOf(mesh);
  Index opposite = 1;
  while (std::count(topology.link(0).begin(), topology.link(0).end(), opposite))
  {
    ++opposite;
  }
  const RefinedMesh refined = refineStars(mesh.points, topology, { { 0, 6 }, { opposite, 12 } });
  EXPECT_EQ(topologyOf(refined).link(0).size(), 12u);
  EXPECT_EQ(topologyOf(refined).link(opposite).size(), 12u);
  EXPECT_EQ(refined.vertices.cols(), 6 + 8);
}

// On the boundary only the edges opposite to the vertex are divided: a corner of one triangle gets
// 5 neighbors from 2, and the boundary itself no vertex but those within that edge.
TEST(StarRefinement, splitsAtTheBoundary)
{
  const TriangleMesh mesh{ (Points(3, 3) << 0, 1, 0, 0, 0, 1, 0, 0, 0).finished(),
    { { 0, 1, 2 } } };
  const RefinedMesh refined = refineStars(mesh.points, topologyOf(mesh), { { 0, 5 } });
  EXPECT_EQ(topologyOf(refined).link(0).size(), 5u);
  EXPECT_EQ(refined.triangles.cols(), 4);
  expectPartsOf(mesh, refined);
}

// What cannot be had is refused, with what can; both are true: one more is refused, that is not.
TEST(StarRefinement, refusesMoreThanQuarters)
{
  const TriangleMesh mesh = tetrahedron();
  EXPECT_EQ(refusal(mesh, { { 2, 13 } }),
    "needs saddles of multiplicity at most 5 at vertex 102, which has 3 neighbors and 12 after its "
    "triangles are split in 4, found one that needs 13. Ask for a lower multiplicity, or at a "
    "vertex with more neighbors.");
  EXPECT_EQ(refusal(mesh, { saddleAt(topologyOf(mesh), 2, 5) }), "taken");

  const TriangleMesh patch = gridMesh(Grid::Patch, 3, 3);
  EXPECT_NE(refusal(patch, { saddleAt(topologyOf(patch), 1, 12) }).find("at most 11 at vertex 101"),
    std::string::npos);
  EXPECT_EQ(refusal(patch, { saddleAt(topologyOf(patch), 1, 11) }), "taken");

  const TriangleMesh pillow{ mesh.points.leftCols(3), { { 0, 1, 2 }, { 0, 2, 1 } } };
  EXPECT_EQ(refusal(pillow, { { 1, 4 } }),
    "needs vertices with at least 3 neighbors to split triangles at, found 2 at vertex 101. Ask "
    "for this critical point elsewhere.");
  EXPECT_EQ(refusal(pillow, { { 1, 2 } }), "taken");
}

} // namespace
} // namespace SurfaceScalars::Truth
