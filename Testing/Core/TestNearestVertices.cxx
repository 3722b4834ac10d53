#include "Error.h"
#include "MeshExamples.h"
#include "NearestVertices.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// The vertex a walk through all of them finds first.
Index nearestOfAll(const Points& vertices, const Vector3d& place)
{
  Index nearest = 0;
  for (Eigen::Index i = 1; i < vertices.cols(); ++i)
  {
    const auto vertex = static_cast<Index>(i);
    if ((vertices.col(vertex) - place).squaredNorm() <
      (vertices.col(nearest) - place).squaredNorm())
    {
      nearest = vertex;
    }
  }
  return nearest;
}

Points placesOf(const std::vector<Vector3d>& list)
{
  Points places(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    places.col(static_cast<Eigen::Index>(i)) = list[i];
  }
  return places;
}

std::string refusal(const TriangleMesh& mesh, const std::vector<Vector3d>& places,
  double maximumDistance = 0.0, const PlaceName& nameOf = {})
{
  try
  {
    nearestVertices(mesh.points, topologyOf(mesh), placesOf(places), maximumDistance, nameOf,
      [](Index vertex) { return vertex + 100; });
    return "taken";
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
}

// The same as a walk through all vertices, for places off the mesh, at vertices and half way
// between them, where the first of two is taken.
TEST(NearestVertices, areThoseOfAWalk)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const MeshTopology topology = topologyOf(mesh);
  Random random(1);
  for (int i = 0; i < 200; ++i)
  {
    const auto vertex = static_cast<Index>(random.uniform(0.0, topology.vertexCount()));
    const Vector3d at = mesh.points.col(vertex);
    const Vector3d next = mesh.points.col(*topology.link(vertex).begin());
    const Vector3d off = at + 0.1 * Vector3d(random.normal(), random.normal(), random.normal());
    const Vector3d halfWay = (at + next) / 2.0;
    for (const Vector3d& place : { at, off, halfWay })
    {
      EXPECT_EQ(nearestVertices(mesh.points, topology, place, 10.0),
        std::vector<Index>{ nearestOfAll(mesh.points, place) });
    }
  }
  EXPECT_EQ(nearestVertices(mesh.points, topology, Vector3d(0, 0, 0), 1.5).size(), 1u);
}

// Of vertices at one place, such as those at a seam, the first is taken.
TEST(NearestVertices, takeTheFirstAtOnePlace)
{
  const TriangleMesh mesh = besideEachOther(subdividedSphere(1), subdividedSphere(1));
  const Index last = static_cast<Index>(mesh.points.cols()) - 1;
  TriangleMesh doubled = mesh;
  doubled.points.rightCols(18) = mesh.points.leftCols(18);
  EXPECT_EQ(
    nearestVertices(doubled.points, topologyOf(doubled), doubled.points.col(last), 0.0).front(),
    last - 18);
}

// Without a given distance a twentieth of the diagonal is allowed, or an edge of the vertex if that
// is longer.
TEST(NearestVertices, areAsFarAsAnEdge)
{
  const TriangleMesh fine = gridMesh(Grid::Patch, 40, 40);
  const double diagonal =
    (fine.points.rowwise().maxCoeff() - fine.points.rowwise().minCoeff()).norm();
  const Vector3d above(0, 0, 1);
  const Vector3d corner = fine.points.col(0);
  EXPECT_EQ(refusal(fine, { corner + 0.0499 * diagonal * above }), "taken");
  EXPECT_NE(refusal(fine, { corner + 0.0501 * diagonal * above }), "taken");

  const TriangleMesh coarse = subdividedSphere(0); // edges of sqrt(2)
  EXPECT_EQ(refusal(coarse, { coarse.points.col(0) * 2.41 }), "taken");
  EXPECT_NE(refusal(coarse, { coarse.points.col(0) * 2.42 }), "taken");
}

// Whoever is refused is named.
TEST(NearestVertices, namesWhatIsRefused)
{
  const TriangleMesh mesh = subdividedSphere(2);
  const Vector3d at = mesh.points.col(7);
  EXPECT_EQ(refusal(mesh, { at, 3.0 * at }, 0.5),
    "needs critical points at most 0.5 from a vertex, found critical point 1 at a distance of 2. "
    "Move it, or raise the maximum distance.");
  EXPECT_EQ(refusal(mesh, { 1e200 * at }, 0.5, [](std::size_t) { return "point 5"; }),
    "needs critical points at most 0.5 from a vertex, found point 5 at a distance of 1e+200. Move "
    "it, or raise the maximum distance.");
  EXPECT_EQ(refusal(mesh, { at, 1.01 * at }),
    "needs critical points at different vertices, found critical point 0 and critical point 1 both "
    "next to vertex 107. Move or remove one of them.");
  EXPECT_EQ(refusal(mesh, { Vector3d(0, std::numeric_limits<double>::quiet_NaN(), 0) }),
    "needs critical points with finite coordinates, found a NaN or infinite one of critical point "
    "0. Correct or remove it.");
  EXPECT_EQ(refusal(mesh, { at }, -1.0),
    "needs a maximum distance of at least 0, found -1. Choose 0 for an automatic one.");
  EXPECT_EQ(refusal(mesh, {}), "taken");
}

} // namespace
} // namespace SurfaceScalars::Truth
