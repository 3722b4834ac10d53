#include "Error.h"
#include "LevelSetCoverage.h"
#include "LevelSetDistortion.h"
#include "MeshCriticalPoints.h"
#include "MeshExamples.h"
#include "MeshFunctions.h"
#include "TetrahedralGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

const Values None; ///< critical values

/// The points in which edges of simplices cross a value; those of several simplices several times.
std::vector<Vector3d> crossingsOf(const SimplicialMesh& mesh, const Values& values, double isoValue)
{
  std::vector<Vector3d> points;
  for (Eigen::Index simplex = 0; simplex < mesh.simplices.cols(); ++simplex)
  {
    for (const Index from : mesh.simplices.col(simplex))
    {
      for (const Index to : mesh.simplices.col(simplex))
      {
        if (values[from] < isoValue && values[to] >= isoValue)
        {
          const double t = (isoValue - values[from]) / (values[to] - values[from]);
          points.emplace_back((1.0 - t) * mesh.vertices.col(from) + t * mesh.vertices.col(to));
        }
      }
    }
  }
  return points;
}

/// Over all pairs.
double hausdorff(const std::vector<Vector3d>& one, const std::vector<Vector3d>& other)
{
  const auto farthest = [](const std::vector<Vector3d>& from, const std::vector<Vector3d>& to)
  {
    double greatest = 0.0;
    for (const Vector3d& place : from)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3d& next : to)
      {
        least = std::min(least, (place - next).norm());
      }
      greatest = std::max(greatest, least);
    }
    return greatest;
  };
  return std::max(farthest(one, other), farthest(other, one));
}

/// All edges of simplices, those of several of them several times.
Simplices edgesOfSimplices(const Simplices& simplices)
{
  const Eigen::Index pairs = simplices.rows() * (simplices.rows() - 1) / 2;
  Simplices edges(2, pairs * simplices.cols());
  Eigen::Index count = 0;
  for (Eigen::Index simplex = 0; simplex < simplices.cols(); ++simplex)
  {
    for (Eigen::Index i = 0; i < simplices.rows(); ++i)
    {
      for (Eigen::Index j = 0; j < i; ++j)
      {
        edges.col(count++) << simplices(i, simplex), simplices(j, simplex);
      }
    }
  }
  return edges;
}

/// The distances are those over all pairs of crossings, in all intervals whose ends have some.
void expectBruteForce(const SimplicialMesh& mesh, const Simplices& edges, const Values& values,
  const Values& isoValues, const std::string& name)
{
  const LevelSetDistortion distortion =
    hausdorffDistortion(mesh.vertices, edges, values, isoValues, None);
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i + 1 < isoValues.size(); ++i)
  {
    const auto one = crossingsOf(mesh, values, isoValues[i]);
    const auto other = crossingsOf(mesh, values, isoValues[i + 1]);
    if (!one.empty() && !other.empty())
    {
      ASSERT_LT(row, distortion.distances.size()) << name;
      EXPECT_EQ(distortion.isoValues[row], isoValues[i]) << name;
      EXPECT_EQ(distortion.nextIsoValues[row], isoValues[i + 1]) << name;
      EXPECT_NEAR(distortion.distances[row], hausdorff(one, other), 1e-12) << name;
      ++row;
    }
  }
  EXPECT_EQ(row, distortion.distances.size()) << name;
  EXPECT_EQ(static_cast<std::size_t>(isoValues.size() - 1 - row), distortion.leftOut) << name;
}

// Hausdorff distances are those over all pairs of points, for smooth, noisy, random and stepped
// functions on surfaces of all kinds.
TEST(LevelSetDistortion, isTheHausdorffDistance)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    const SimplicialMesh mesh{ named.mesh.points, trianglesOf(named.mesh) };
    for (const auto& [name, values] : meshFunctions(named.mesh, 1))
    {
      if (values.minCoeff() < values.maxCoeff())
      {
        expectBruteForce(mesh, edgesOf(topologyOf(named.mesh)), values, dyadicIsoValues(values, 4),
          named.name + (", " + name));
      }
    }
  }
}

// So they are in volumes.
TEST(LevelSetDistortion, isTheHausdorffDistanceInVolumes)
{
  const SimplicialMesh grid = tetrahedralGrid(6);
  Values values = (grid.vertices.colwise() - Vector3d(0.3, 0.4, 0.6)).colwise().norm();
  const Simplices edges = edgesOfSimplices(grid.simplices);
  expectBruteForce(grid, edges, values, dyadicIsoValues(values, 4), "distance");
  addNoise(values, 0.3, 2);
  expectBruteForce(grid, edges, values, dyadicIsoValues(values, 3), "noise");
}

// A mesh has vertices - edges + triangles = its characteristic, and each edge once.
TEST(LevelSetDistortion, takesEachEdgeOnce)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    Simplices edges = edgesOf(topologyOf(named.mesh));
    EXPECT_EQ(named.mesh.points.cols() - edges.cols() +
        static_cast<Eigen::Index>(named.mesh.triangles.size()),
      named.eulerCharacteristic)
      << named.name;
  }
}

// As many halvings as asked for can be afforded, up to a bound: one more crosses more often.
TEST(LevelSetDistortion, countsCrossings)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const Simplices edges = edgesOf(topologyOf(mesh));
  const Values values = randomValues(mesh, 1);
  const SimplicialMesh asEdges{ mesh.points, edges };
  for (const double crossings : { 1e4, 1e5 })
  {
    const int halvings = affordableHalvings(edges, values, 20, crossings);
    for (const int more : { 0, 1 })
    {
      double count = 0.0;
      for (const double isoValue : dyadicIsoValues(values, halvings + more))
      {
        count += static_cast<double>(crossingsOf(asEdges, values, isoValue).size());
      }
      EXPECT_TRUE(more == 0 ? count <= crossings : count > 0.9 * crossings) << count;
    }
  }
  EXPECT_EQ(affordableHalvings(edges, values, 3, 1e9), 3);
  EXPECT_EQ(affordableHalvings(edges, values, 3, 0.0), 1);
}

// Intervals that hold a critical value, ends included, are left out and counted; what is left is
// what it is without them.
TEST(LevelSetDistortion, leavesCriticalValuesOut)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const Simplices edges = edgesOf(topologyOf(mesh));
  const Values height = mesh.points.row(2).transpose();
  const Values isoValues = Values::LinSpaced(9, -0.8, 0.8);
  const Values critical = Eigen::Vector3d(-0.7, isoValues[4], 0.95);
  const LevelSetDistortion all = hausdorffDistortion(mesh.points, edges, height, isoValues, None);
  const LevelSetDistortion some =
    hausdorffDistortion(mesh.points, edges, height, isoValues, critical);
  ASSERT_EQ(all.distances.size(), 8);
  EXPECT_EQ(all.leftOut, 0u);
  EXPECT_EQ(some.leftOut, 3u);
  const std::vector<Eigen::Index> left = { 1, 2, 5, 6, 7 };
  EXPECT_EQ(some.distances, Values(all.distances(left)));
  EXPECT_EQ(some.isoValues, Values(isoValues(left)));
}

// Two surfaces with a gap between their values: no level set is in the gap, and no way leads from
// one to the other. Between their own critical values each has its distances.
TEST(LevelSetDistortion, knowsComponents)
{
  const TriangleMesh mesh = besideEachOther(subdividedSphere(3), subdividedSphere(3));
  const MeshTopology topology = topologyOf(mesh);
  Values height = mesh.points.row(2).transpose();
  height.tail(height.size() / 2).array() += 5.0;
  const Values isoValues = Values::LinSpaced(70, -0.95, 5.95);
  for (const LevelSetDistortion& distortion :
    { hausdorffDistortion(mesh.points, edgesOf(topology), height, isoValues, None),
      geodesicDistortion(mesh.points, topology, height, isoValues, None) })
  {
    EXPECT_EQ(distortion.distances.size(), 38);
    EXPECT_EQ(distortion.leftOut, 31u);
    EXPECT_TRUE(distortion.distances.allFinite());
    EXPECT_LT(distortion.distances.maxCoeff(), 0.5);
  }
  // Overlapping ranges: where a level set has a part on one sphere alone, no way leads to it.
  height.tail(height.size() / 2).array() -= 4.0;
  const LevelSetDistortion distortion =
    geodesicDistortion(mesh.points, topology, height, Eigen::Vector3d(-0.5, 0.5, 0.6), None);
  EXPECT_EQ(distortion.leftOut, 1u);
  EXPECT_EQ(distortion.isoValues, Values::Constant(1, 0.5));
}

// Between regular values nothing but distances comes out, whatever the function.
TEST(LevelSetDistortion, isFiniteBetweenRegularValues)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    const MeshTopology topology = topologyOf(named.mesh);
    for (const auto& [name, values] : meshFunctions(named.mesh, 2))
    {
      if (values.minCoeff() == values.maxCoeff())
      {
        continue;
      }
      std::vector<double> critical;
      for (const CriticalPoint& point :
        meshCriticalPoints(named.mesh.points, topology, values).points)
      {
        critical.push_back(point.value);
      }
      std::sort(critical.begin(), critical.end());
      const Eigen::Map<const Values> criticalValues(
        critical.data(), static_cast<Eigen::Index>(critical.size()));
      const Values isoValues = dyadicIsoValues(values, 8);
      const LevelSetDistortion geodesic =
        geodesicDistortion(named.mesh.points, topology, values, isoValues, criticalValues);
      const LevelSetDistortion straight = hausdorffDistortion(
        named.mesh.points, edgesOf(topology), values, isoValues, criticalValues);
      EXPECT_EQ(geodesic.isoValues, straight.isoValues) << named.name << ", " << name;
      EXPECT_EQ(geodesic.distances.size() + static_cast<Eigen::Index>(geodesic.leftOut), 254);
      EXPECT_GE(geodesic.distances.size() ? geodesic.distances.minCoeff() : 0.0, 0.0);
    }
  }
}

// Neither the number of threads nor what else is measured, and in which blocks, changes a distance.
TEST(LevelSetDistortion, isThatOfTheLevelSets)
{
  const TriangleMesh mesh = gridMesh(Grid::Torus, 120, 60);
  const MeshTopology topology = topologyOf(mesh);
  const Simplices edges = edgesOf(topology);
  const Values values = randomValues(mesh, 5);
  const Values isoValues = dyadicIsoValues(values, 8); // 1.9 million crossings
  const LevelSetDistortion one =
    hausdorffDistortion(mesh.points, edges, values, isoValues, None, { 1, {} });
  const LevelSetDistortion four =
    hausdorffDistortion(mesh.points, edges, values, isoValues, None, { 4, {} });
  EXPECT_EQ(one.distances, four.distances);
  for (const Eigen::Index i : { 0, 60, 128, 200 })
  {
    EXPECT_EQ(
      hausdorffDistortion(mesh.points, edges, values, isoValues.segment(i, 2), None).distances[0],
      one.distances[i]);
  }
  const Values few = isoValues.segment(100, 20);
  EXPECT_EQ(geodesicDistortion(mesh.points, topology, values, few, None, { 1, {} }).distances,
    geodesicDistortion(mesh.points, topology, values, few, None, { 4, {} }).distances);
}

// What cannot be worked on is refused; whoever wants to stop is heard.
TEST(LevelSetDistortion, refusesBadInput)
{
  const TriangleMesh mesh = subdividedSphere(2);
  const MeshTopology topology = topologyOf(mesh);
  const Values height = mesh.points.row(2).transpose();
  const Values isoValues = Values::LinSpaced(9, -0.8, 0.8);
  const auto expectRefusal = [&](const Values& values, const Values& levels, const Values& critical)
  {
    EXPECT_THROW(
      hausdorffDistortion(mesh.points, edgesOf(topology), values, levels, critical), InvalidInput);
    EXPECT_THROW(geodesicDistortion(mesh.points, topology, values, levels, critical), InvalidInput);
  };
  expectRefusal(height.head(3), isoValues, None);
  expectRefusal(Values::Constant(height.size(), std::nan("")), isoValues, None);
  expectRefusal(height, isoValues.reverse(), None);
  expectRefusal(height, Eigen::Vector2d(0.1, 0.1), None);
  expectRefusal(height, Eigen::Vector2d(0.1, std::nan("")), None);
  expectRefusal(height, isoValues, Eigen::Vector2d(0.2, 0.1));
  Values hole = height;
  hole[7] = std::nan("");
  try
  {
    hausdorffDistortion(mesh.points, edgesOf(topology), hole, isoValues, None);
    ADD_FAILURE() << "took NaN";
  }
  catch (const InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("nan at vertex 7"), std::string::npos);
  }
  const Execution stopped{ 1, [](double) { return false; } };
  EXPECT_THROW(
    hausdorffDistortion(mesh.points, edgesOf(topology), height, isoValues, None, stopped), Aborted);
  EXPECT_THROW(
    geodesicDistortion(mesh.points, topology, height, isoValues, None, stopped), Aborted);
  EXPECT_EQ(geodesicDistortion(mesh.points, topology, height, None, None).distances.size(), 0);
}

} // namespace
} // namespace SurfaceScalars::Truth
