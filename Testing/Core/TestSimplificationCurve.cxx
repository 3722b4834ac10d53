#include "MeshFunctions.h"
#include "SimplificationCurve.h"

#include <gtest/gtest.h>

#include <array>

namespace SurfaceScalars::Truth
{
namespace
{

std::array<int, 3> numbersOf(const CriticalCounts& counts)
{
  return { static_cast<int>(counts.minima), static_cast<int>(counts.saddles),
    static_cast<int>(counts.maxima) };
}

void count(std::array<int, 3>& numbers, const CriticalPoint& point)
{
  const std::size_t kind = point.type == CriticalType::Minimum ? 0
    : point.type == CriticalType::Saddle                       ? 1
                                                               : 2;
  numbers[kind] += point.multiplicity;
}

// By persistence the counts are those of what removeBelow() leaves; by delta those of the sets
// C_delta. Without threshold both are all, and at f's range the extrema and handles are left.
TEST(SimplificationCurve, countsWhatIsLeft)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    const TriangleMesh mesh = subdivided(named.mesh);
    const MeshTopology topology = topologyOf(mesh);
    for (const auto& [name, values] : meshFunctions(mesh, 1))
    {
      SCOPED_TRACE(named.name + (", " + name));
      const double range = values.maxCoeff() - values.minCoeff();
      const VertexTypes types = classifyVertices(topology, values);
      const Values deltas = deltaThresholds(topology, values, types);
      const MeshCriticalPoints critical = meshCriticalPoints(mesh.points, topology, values);
      const SimplificationCurve curve =
        simplificationCurve(critical, deltas, range, { 0.0, 0.001, 0.01, 0.05, 0.2, 0.5, 1.0 });
      EXPECT_EQ(numbersOf(curve.byDelta[0]), numbersOf(types.counts));
      EXPECT_EQ(numbersOf(curve.byPersistence[0]), numbersOf(types.counts));
      for (std::size_t i = 1; i < curve.thresholds.size(); ++i)
      {
        const double threshold = curve.thresholds[i] * range;
        std::vector<CriticalPoint> kept = critical.points;
        removeBelow(kept, critical.pairs, threshold);
        std::array<int, 3> byPersistence{};
        for (const CriticalPoint& point : kept)
        {
          count(byPersistence, point);
        }
        EXPECT_EQ(numbersOf(curve.byPersistence[i]), byPersistence);
        std::array<int, 3> byDelta{};
        for (const CriticalPoint& point : critical.points)
        {
          if (deltas[static_cast<Eigen::Index>(point.input)] > threshold || threshold == 0.0)
          {
            count(byDelta, point);
          }
        }
        EXPECT_EQ(numbersOf(curve.byDelta[i]), byDelta);
        if (named.isClosed)
        {
          EXPECT_EQ(
            byPersistence[0] - byPersistence[1] + byPersistence[2], named.eulerCharacteristic);
        }
      }
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
