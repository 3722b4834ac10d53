#include "LinkWalk.h"
#include "MeshCriticalPoints.h"
#include "MeshFunctions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

/// Whether a vertex that is critical is so too for a positive delta, by the signs that are left
/// around it; along the boundary there and back.
bool remains(
  const OrderedLink& link, const Values& values, int vertex, CriticalType type, double delta)
{
  std::vector<int> around = link.vertices;
  if (!link.isClosed)
  {
    around.insert(around.end(), link.vertices.rbegin(), link.vertices.rend());
  }
  std::vector<bool> signs;
  std::size_t neutral = 0;
  for (const int neighbor : around)
  {
    const double difference = values[neighbor] - values[vertex];
    if (std::abs(difference) > delta)
    {
      signs.push_back(difference > 0.0);
    }
    else
    {
      ++neutral;
    }
  }
  if (type != CriticalType::Saddle)
  {
    return neutral == 0;
  }
  int changes = 0;
  for (std::size_t i = 0; i < signs.size(); ++i)
  {
    changes += signs[i] != signs[(i + 1) % signs.size()] ? 1 : 0;
  }
  return changes >= 4;
}

// The thresholds of all vertices, found in one pass, are those at which vertices drop out as delta
// rises; the sets C_delta are nested.
TEST(MeshDelta, thresholdsAreWhereVerticesDropOut)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    const MeshTopology topology = topologyOf(named.mesh);
    const std::vector<OrderedLink> links = orderedLinks(named.mesh);
    for (const auto& [name, values] : meshFunctions(named.mesh, 1))
    {
      SCOPED_TRACE(named.name + (", " + name));
      const VertexTypes types = classifyVertices(topology, values);
      const Values thresholds = deltaThresholds(topology, values, types);
      const double largest = 1.1 * (values.maxCoeff() - values.minCoeff());
      std::vector<bool> last(links.size(), true);
      for (int step = 0; step <= 100; ++step)
      {
        const double delta = largest * step / 100.0;
        for (std::size_t i = 0; i < links.size(); ++i)
        {
          const auto vertex = static_cast<int>(i);
          const bool expected = types.types[i] != CriticalType::Regular &&
            remains(links[i], values, vertex, types.types[i], delta);
          ASSERT_EQ(thresholds[vertex] > delta, expected) << "vertex " << i << ", delta " << delta;
          ASSERT_TRUE(last[i] || !expected) << "nested";
          last[i] = expected;
        }
      }
    }
  }
}

// Of a function without equal neighbors, every critical vertex has a threshold, and regular ones
// have none; thresholds scale with f.
TEST(MeshDelta, criticalVerticesHaveThresholds)
{
  const TriangleMesh mesh = plateWithHoles(2, 3);
  const MeshTopology topology = topologyOf(mesh);
  const Values values = randomValues(mesh, 2);
  const VertexTypes types = classifyVertices(topology, values);
  const Values thresholds = deltaThresholds(topology, values, types);
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    EXPECT_EQ(thresholds[vertex] > 0.0, types.types[vertex] != CriticalType::Regular);
  }
  const Values shifted = 4.0 * values;
  EXPECT_EQ(deltaThresholds(topology, shifted, types, { 1, {} }), 4.0 * thresholds);
}

} // namespace
} // namespace SurfaceScalars::Truth
