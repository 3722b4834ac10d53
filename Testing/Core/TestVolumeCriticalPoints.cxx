#include "Error.h"
#include "Meshes.h"
#include "VolumeCriticalPoints.h"
#include "VolumeFunctions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// 1 less the Euler characteristic of the lower link, which is counted: vertices, edges and
/// triangles of the tetrahedra around the vertex whose corners have lesser ranks.
std::vector<int> banchoffIndices(const Tetrahedra& tetrahedra, const std::vector<int>& ranks)
{
  std::vector<std::set<std::set<Index>>> lower(ranks.size());
  for (Eigen::Index cell = 0; cell < tetrahedra.cols(); ++cell)
  {
    for (const Index vertex : tetrahedra.col(cell))
    {
      for (unsigned subset = 1; subset < 16; ++subset)
      {
        std::set<Index> simplex;
        for (unsigned corner = 0; corner < 4; ++corner)
        {
          if (subset & (1U << corner))
          {
            simplex.insert(tetrahedra(corner, cell));
          }
        }
        if (std::all_of(simplex.begin(), simplex.end(),
              [&](Index other) { return ranks[other] < ranks[vertex]; }))
        {
          lower[vertex].insert(simplex);
        }
      }
    }
  }
  std::vector<int> indices;
  for (const auto& link : lower)
  {
    indices.push_back(std::accumulate(link.begin(), link.end(), 1,
      [](int sum, const std::set<Index>& simplex)
      { return sum + (simplex.size() % 2 == 0 ? 1 : -1); }));
  }
  return indices;
}

int indexAt(const VolumeTypes& types, Index vertex)
{
  return (types.types[vertex] == CriticalType::Minimum ? 1 : 0) -
    static_cast<int>(types.oneSaddles[vertex]) + static_cast<int>(types.twoSaddles[vertex]) -
    (types.types[vertex] == CriticalType::Maximum ? 1 : 0);
}

// Banchoff: 1 - chi(lower link) sums to the Euler characteristic whatever the values are. The types
// of interior vertices have this index, and on manifolds those of all vertices, the boundary
// counted half, sum to 0.
TEST(VolumeCriticalPoints, indicesAreBanchoffs)
{
  for (const NamedVolume& named : volumesOfAllKinds())
  {
    const VolumeTopology topology = topologyOf(named.volume);
    for (const auto& [name, values] : functionsOn(named.volume))
    {
      SCOPED_TRACE(named.name + ", " + name);
      const std::vector<int> expected = banchoffIndices(named.volume.tetrahedra, ranksOf(values));
      EXPECT_EQ(std::accumulate(expected.begin(), expected.end(), 0), named.eulerCharacteristic);
      const VolumeTypes types = classifyVolumeVertices(topology, values);
      int twice = 0;
      for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
      {
        const bool isBoundary = topology.isBoundary(vertex);
        twice += (isBoundary ? 1 : 2) * indexAt(types, vertex);
        EXPECT_TRUE(isBoundary || indexAt(types, vertex) == expected[vertex]) << vertex;
      }
      EXPECT_EQ(twice, 0);
      EXPECT_TRUE(!named.isClosed || types.counts.indexSum() == 0);
    }
  }
}

/// Each tetrahedron in 24, by the centers of its edges, faces and itself: simplices between
/// vertices of the boundary are then on the boundary.
Volume barycentric(const Volume& volume)
{
  std::map<std::set<Index>, Index> numbers;
  std::vector<Vector3d> places;
  Volume result{ {}, Tetrahedra(4, 24 * volume.tetrahedra.cols()) };
  Eigen::Index count = 0;
  for (Eigen::Index cell = 0; cell < volume.tetrahedra.cols(); ++cell)
  {
    std::array<Index, 4> corners;
    std::copy_n(volume.tetrahedra.col(cell).data(), 4, corners.begin());
    std::sort(corners.begin(), corners.end());
    do
    {
      std::set<Index> simplex;
      Vector3d sum = Vector3d::Zero();
      for (Eigen::Index i = 0; i < 4; ++i)
      {
        simplex.insert(corners[static_cast<std::size_t>(i)]);
        sum += volume.vertices.col(corners[static_cast<std::size_t>(i)]);
        const auto [entry, isNew] = numbers.try_emplace(simplex, static_cast<Index>(places.size()));
        if (isNew)
        {
          places.emplace_back(sum / static_cast<double>(i + 1));
        }
        result.tetrahedra(i, count) = entry->second;
      }
      ++count;
    } while (std::next_permutation(corners.begin(), corners.end()));
  }
  result.vertices =
    Eigen::Map<const Points>(places[0].data(), 3, static_cast<Eigen::Index>(places.size()));
  return result;
}

// The types of the boundary are those on the volume glued to its mirror image there.
TEST(VolumeCriticalPoints, boundaryIsThatOfTheGluedVolume)
{
  const Volume block = barycentric(blockVolume(2, 2, 1));
  const VolumeTopology topology = topologyOf(block);
  const Glued glued(block);
  for (const auto& [name, values] : functionsOn(block))
  {
    SCOPED_TRACE(name);
    const std::vector<int> expected = banchoffIndices(glued.tetrahedra, glued.ranks(values));
    const VolumeTypes types = classifyVolumeVertices(topology, values);
    for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
    {
      EXPECT_EQ(indexAt(types, vertex), expected[vertex]) << vertex;
    }
  }
}

// cos x + cos y + cos z on the 3-torus has 1 minimum, 3 saddles of each kind and 1 maximum, at
// vertices of a grid of even size.
TEST(VolumeCriticalPoints, areThoseOfAnAnalyticFunction)
{
  constexpr int size = 8;
  const Volume torus = threeTorus(size);
  Values values(torus.vertices.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    values[i] = (torus.vertices.col(i) * 2.0 * Pi / size).array().cos().sum();
  }
  const MeshCriticalPoints critical =
    volumeCriticalPoints(torus.vertices, topologyOf(torus), values);
  const VolumeCounts counts = volumeCountsOf(critical.points);
  EXPECT_EQ(counts.minima, 1U);
  EXPECT_EQ(counts.oneSaddles, 3U);
  EXPECT_EQ(counts.twoSaddles, 3U);
  EXPECT_EQ(counts.maxima, 1U);
  constexpr std::array byCrests{ CriticalType::Minimum, CriticalType::Saddle,
    CriticalType::TwoSaddle, CriticalType::Maximum };
  for (const CriticalPoint& point : critical.points)
  {
    const Vector3d halves = torus.vertices.col(static_cast<Eigen::Index>(point.input)) * 2.0 / size;
    EXPECT_TRUE((halves.array() == halves.array().round()).all());
    const auto crests = (halves.array() == 0.0).count(); // cosines of 1, the others are -1
    EXPECT_EQ(point.type, byCrests[static_cast<std::size_t>(crests)]);
    EXPECT_NEAR(point.value, 2.0 * static_cast<double>(crests) - 3.0, 1e-12);
    EXPECT_NEAR(point.persistence, 6.0, 1e-12); // nothing is cancelled
  }
}

// Over the center of a ball, z^3 - z r^2 / 4 is lower in a cap and a belt and higher in such: the
// center is both saddles. Squares of different signs are one of them.
TEST(VolumeCriticalPoints, aVertexCanBeBothSaddles)
{
  const TriangleMesh sphere = subdividedSphere(3);
  const auto center = static_cast<Index>(sphere.points.cols());
  Volume ball{ Points(3, center + 1), Tetrahedra(4, 0) };
  ball.vertices << sphere.points, Vector3d::Zero();
  ball.tetrahedra.resize(4, static_cast<Eigen::Index>(sphere.triangles.size()));
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i)
  {
    const auto& [a, b, c] = sphere.triangles[i];
    ball.tetrahedra.col(static_cast<Eigen::Index>(i)) << Index(a), Index(b), Index(c), center;
  }
  const auto typesOf = [&](const std::function<double(const Vector3d&)>& function)
  {
    Values values(ball.vertices.cols());
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      values[i] = function(ball.vertices.col(i));
    }
    return classifyVolumeVertices(topologyOf(ball), values);
  };
  const VolumeTypes both =
    typesOf([](const Vector3d& p) { return p.z() * (p.z() * p.z() - 0.25 * p.squaredNorm()); });
  EXPECT_EQ(both.oneSaddles[center], 1U);
  EXPECT_EQ(both.twoSaddles[center], 1U);
  EXPECT_EQ(both.types[center], CriticalType::Saddle);
  const VolumeTypes one =
    typesOf([](const Vector3d& p) { return p.dot(Vector3d(1, 2, -1.5).cwiseProduct(p)); });
  EXPECT_EQ(one.oneSaddles[center], 1U);
  EXPECT_EQ(one.twoSaddles[center], 0U);
  const VolumeTypes two =
    typesOf([](const Vector3d& p) { return p.dot(Vector3d(-1, -2, 1.5).cwiseProduct(p)); });
  EXPECT_EQ(two.types[center], CriticalType::TwoSaddle);
  EXPECT_EQ(two.twoSaddles[center], 1U);
}

// Results do not depend on the number of threads.
TEST(VolumeCriticalPoints, doNotDependOnThreads)
{
  const Volume block = blockVolume(20, 20, 20);
  const Values values = functionsOn(block)[1].values;
  const auto find = [&](int threadCount)
  {
    return volumeCriticalPoints(
      block.vertices, topologyOf(block, threadCount), values, { threadCount, {} });
  };
  const MeshCriticalPoints one = find(1);
  const MeshCriticalPoints four = find(4);
  ASSERT_EQ(one.points.size(), four.points.size());
  for (std::size_t i = 0; i < one.points.size(); ++i)
  {
    EXPECT_EQ(one.points[i].input, four.points[i].input);
    EXPECT_EQ(one.points[i].type, four.points[i].type);
    EXPECT_EQ(one.points[i].persistence, four.points[i].persistence);
  }
}

TEST(VolumeCriticalPoints, refusesOtherValues)
{
  const Volume block = blockVolume(2, 2, 2);
  const VolumeTopology topology = topologyOf(block);
  Values values = Values::Zero(27);
  EXPECT_THROW(classifyVolumeVertices(topology, Values::Zero(26)), InvalidInput);
  EXPECT_THROW(volumeCriticalPoints(Points::Zero(3, 26), topology, values), InvalidInput);
  values[13] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(classifyVolumeVertices(topology, values), InvalidInput);
  EXPECT_THROW(
    classifyVolumeVertices(topology, Values::Zero(27), { 1, [](double) { return false; } }),
    Aborted);
}

} // namespace
} // namespace SurfaceScalars::Truth
