#include "FuzzyCriticalPoints.h"
#include "Sampling.h"
#include "Surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

/// Waves down to the sampling step, in all directions, as high as they are long.
Values roughValues(const Points& points, unsigned seed)
{
  Random random(seed);
  Values values = Values::Zero(points.cols());
  for (int wave = 0; wave < 200; ++wave)
  {
    const double frequency = std::pow(2.0, random.uniform(0.0, 6.0));
    const Vector3d direction(random.normal(), random.normal(), random.normal());
    const Vector3d wave3 = frequency * direction.normalized();
    const double phase = random.uniform(0.0, 2.0 * Pi);
    values.array() += ((points.transpose() * wave3).array() + phase).cos() / frequency;
  }
  return values;
}

int saddlesThatStay(const Points& points, unsigned seed)
{
  const NeighborGraph graph(points, NeighborQuery());
  const Values values = graph.average(roughValues(points, seed));
  const FuzzyCriticalPoints found = findCriticalPoints(graph, values, {});
  EXPECT_GT(found.points.size(), 20u);
  const double range = values.maxCoeff() - values.minCoeff();
  int count = 0;
  for (const CriticalPoint& point : found.points)
  {
    const bool stays = point.persistence > 0.95 * range;
    count += point.type == CriticalType::Saddle && stays ? point.multiplicity : 0;
  }
  return count;
}

// No saddle is that of a handle where there is none, however rough the function: every loop cuts a
// sphere in two (Jordan). On a torus two are.
TEST(PersistenceHandles, areThoseOfTheSurface)
{
  for (const unsigned seed : { 1u, 3u })
  {
    EXPECT_EQ(saddlesThatStay(randomSphere(10000, seed), seed + 10), 0) << seed;
    EXPECT_EQ(saddlesThatStay(randomTorus(10000, Torus::Closed, seed), seed + 10), 2) << seed;
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
