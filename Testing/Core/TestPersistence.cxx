#include "CriticalPoints.h"
#include "Functions.h"
#include "MergeTreesBuilder.h"
#include "Persistence.h"
#include "Queries.h"
#include "Sampling.h"
#include "ValueOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace SurfaceScalars::Truth
{
namespace
{

/// A function of the angles of the torus, with its derivatives by u and v.
SpaceFunction angular(const std::function<double(double, double)>& value,
  const std::function<Vector2d(double, double)>& derivatives)
{
  const auto gradient = [=](const Vector3d& p) -> Vector3d
  {
    const Vector2d angles = torusAngles(p);
    const Vector2d by = derivatives(angles.x(), angles.y());
    const double axial = p.head<2>().norm();
    const Vector3d outwards(p.x() / axial, p.y() / axial, 0.0);
    const Vector2d tube =
      Vector2d(axial, p.z()) - Vector2d(torusPoint({ 0.0, 0.5 * Pi }).head<2>().norm(), 0.0);
    return by.x() * Vector3d(-p.y(), p.x(), 0.0) / (axial * axial) +
      by.y() * (tube.x() * Vector3d::UnitZ() - tube.y() * outwards) / tube.squaredNorm();
  };
  return { "angular",
    [=](const Vector3d& p)
    {
      const Vector2d angles = torusAngles(p);
      return value(angles.x(), angles.y());
    },
    gradient };
}

/// cos 3u cos 2v: 12 minima at -1, 12 maxima at 1 and 24 saddles at 0.
SpaceFunction waves()
{
  return angular([](double u, double v) { return std::cos(3.0 * u) * std::cos(2.0 * v); },
    [](double u, double v)
    {
      return Vector2d(
        -3.0 * std::sin(3.0 * u) * std::cos(2.0 * v), -2.0 * std::cos(3.0 * u) * std::sin(2.0 * v));
    });
}

/// Waves of different heights: critical points of many values.
SpaceFunction slantedWaves()
{
  return angular(
    [](double u, double v)
    {
      return std::cos(3.0 * u) * std::cos(2.0 * v) + 0.3 * std::cos(u - 0.4) +
        0.2 * std::sin(v + 0.5);
    },
    [](double u, double v)
    {
      return Vector2d(-3.0 * std::sin(3.0 * u) * std::cos(2.0 * v) - 0.3 * std::sin(u - 0.4),
        -2.0 * std::cos(3.0 * u) * std::sin(2.0 * v) + 0.2 * std::cos(v + 0.5));
    });
}

/// A function on the torus, its samples and its exact critical points.
struct Sampled
{
  Sampled(SpaceFunction f, int count, unsigned seed)
    : function(std::move(f))
    , graph(randomTorus(count, Torus::Closed, seed), nearest(16))
    , values(graph.pointCount())
  {
    for (Index i = 0; i < this->graph.pointCount(); ++i)
    {
      this->values[i] = this->function.value(this->graph.points().col(i) + this->graph.origin());
    }
    this->points = criticalPoints(closedTorus(), this->function);
    for (CriticalPoint& point : this->points)
    {
      Neighborhood nearest;
      this->graph.nearest(point.position - this->graph.origin(), 1, nearest);
      point.input = this->graph.inputOfPoint(nearest.indices.front());
    }
  }
  double range() const { return this->values.maxCoeff() - this->values.minCoeff(); }
  std::vector<CriticalPair> assign()
  {
    return assignPersistence(this->points, this->graph, this->values);
  }

  SpaceFunction function;
  NeighborGraph graph;
  Values values;
  std::vector<CriticalPoint> points;
};

int indexSum(const std::vector<CriticalPoint>& points)
{
  return std::accumulate(points.begin(), points.end(), 0,
    [](int sum, const CriticalPoint& point) { return sum + indexOf(point); });
}

std::vector<double> persistences(const std::vector<CriticalPoint>& points, CriticalType type)
{
  std::vector<double> result;
  for (const CriticalPoint& point : points)
  {
    if (point.type == type)
    {
      result.push_back(point.persistence);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Nothing cancels on a tilted torus: the global extrema and the saddles of the handle have f's
// range.
TEST(Persistence, essentialPointsHaveTheRange)
{
  for (const int count : { 5000, 50000 })
  {
    Sampled torus(tiltedHeight(), count, 1);
    ASSERT_EQ(torus.points.size(), 4u);
    EXPECT_TRUE(torus.assign().empty());
    for (const CriticalPoint& point : torus.points)
    {
      EXPECT_EQ(point.persistence, torus.range());
    }
  }
}

// Equal values everywhere: 11 of the 12 minima and of the 12 maxima end at saddles, each at its
// own, and two saddles are the handle's.
TEST(Persistence, eachSaddleCancelsOneExtremum)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    Sampled torus(waves(), 5000, seed);
    ASSERT_EQ(torus.points.size(), 48u);
    const std::vector<CriticalPair> pairs = torus.assign();

    EXPECT_EQ(pairs.size(), 22u);
    std::set<std::size_t> partners;
    for (const CriticalPair& pair : pairs)
    {
      EXPECT_NEAR(pair.persistence, 1.0, 1e-9);
      partners.insert({ pair.extremum, pair.saddle });
    }
    EXPECT_EQ(partners.size(), 44u) << "no point twice";
    for (const CriticalPoint& point : torus.points)
    {
      const auto i = static_cast<std::size_t>(&point - torus.points.data());
      EXPECT_NEAR(point.persistence, partners.count(i) == 1 ? 1.0 : torus.range(), 1e-9);
    }
  }
}

/// The persistence of minima, or of maxima for sign -1, on a fine triangulation of the torus by
/// angles; without the global extremum.
std::vector<double> meshPersistences(const SpaceFunction& function, double sign, double atLeast)
{
  const int columns = 1200;
  const int rows = 600;
  const auto vertex = [=](int i, int j)
  { return static_cast<Index>((i + columns) % columns * rows + (j + rows) % rows); };
  Values values(columns * rows);
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      values[vertex(i, j)] =
        sign * function.value(torusPoint({ 2.0 * Pi * i / columns, 2.0 * Pi * j / rows }));
    }
  }
  const auto neighborsOf = [=](Index index)
  {
    const int i = static_cast<int>(index) / rows;
    const int j = static_cast<int>(index) % rows;
    return std::array<Index, 6>{ vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1),
      vertex(i - 1, j), vertex(i - 1, j - 1), vertex(i, j - 1) };
  };
  const ValueOrder isBelow{ values.data() };
  const MergeTree tree =
    MergeTreesBuilder(static_cast<Index>(values.size()), neighborsOf, isBelow, {}).build().sublevel;
  std::vector<double> result;
  for (const Merge& merge : tree.merges)
  {
    const double persistence = values[merge.vertex] - values[merge.younger];
    if (persistence >= atLeast)
    {
      result.push_back(persistence);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Persistence at different values is that of a triangulation of the torus a hundred times finer.
TEST(Persistence, agreesWithAFineMesh)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    Sampled torus(slantedWaves(), 5000, seed);
    ASSERT_EQ(indexSum(torus.points), 0);
    const std::vector<CriticalPair> pairs = torus.assign();
    for (const CriticalType type : { CriticalType::Minimum, CriticalType::Maximum })
    {
      std::vector<double> found = persistences(torus.points, type);
      const std::vector<double> exact =
        meshPersistences(torus.function, type == CriticalType::Minimum ? 1.0 : -1.0, 1e-3);
      EXPECT_EQ(found.back(), torus.range());
      found.pop_back();
      ASSERT_EQ(found.size(), exact.size());
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        EXPECT_NEAR(found[i], exact[i], 1e-3);
      }
    }
    EXPECT_EQ(pairs.size() + 4, torus.points.size() - pairs.size());
  }
}

// Removing pairs keeps the index sum at Euler's characteristic, whatever the threshold; what a
// larger threshold keeps is among what a smaller one keeps, and no threshold below f's range
// removes the extrema and the handle.
TEST(Persistence, thresholdsAreNested)
{
  Sampled torus(slantedWaves(), 5000, 4);
  const std::vector<CriticalPair> pairs = torus.assign();
  std::vector<CriticalPoint> last = torus.points;
  for (double threshold = 0.0; threshold < torus.range(); threshold += 0.05)
  {
    std::vector<CriticalPoint> kept = torus.points;
    removeBelow(kept, pairs, threshold);
    EXPECT_EQ(indexSum(kept), 0) << threshold;
    for (const CriticalPoint& point : kept)
    {
      EXPECT_GE(point.persistence, threshold);
      EXPECT_TRUE(std::any_of(last.begin(), last.end(),
        [&](const auto& other) { return other.position == point.position; }));
    }
    last = kept;
  }
  EXPECT_EQ(last.size(), 4u);
}

// Persistence of a f + b is |a| times that of f, and the order of the critical points says nothing.
TEST(Persistence, isThatOfTheFunction)
{
  Sampled torus(slantedWaves(), 5000, 5);
  torus.assign();
  for (const double factor : { 4.0, -0.5 })
  {
    Sampled other(slantedWaves(), 5000, 5);
    other.values = (factor * other.values).array() + 8.0;
    std::reverse(other.points.begin(), other.points.end());
    for (CriticalPoint& point : other.points)
    {
      point.value = factor * point.value + 8.0;
      if (factor < 0.0 && point.type != CriticalType::Saddle)
      {
        point.type =
          point.type == CriticalType::Minimum ? CriticalType::Maximum : CriticalType::Minimum;
      }
    }
    other.assign();
    std::reverse(other.points.begin(), other.points.end());
    for (std::size_t i = 0; i < torus.points.size(); ++i)
    {
      EXPECT_NEAR(
        other.points[i].persistence, std::abs(factor) * torus.points[i].persistence, 1e-9);
    }
  }
}

// Noise on the samples makes extrema of the graph but no others: pairs of refined points stay.
TEST(Persistence, extremaOfTheGraphAloneDoNotCount)
{
  Sampled torus(slantedWaves(), 20000, 6);
  torus.assign();
  Sampled noisy(slantedWaves(), 20000, 6);
  addNoise(noisy.values, 0.01, 7);
  EXPECT_GT(persistencePairs(noisy.graph, noisy.values).minima.size(), 12u);
  noisy.assign();
  for (std::size_t i = 0; i < torus.points.size(); ++i)
  {
    const double expected = torus.points[i].persistence;
    EXPECT_NEAR(noisy.points[i].persistence, expected, expected == torus.range() ? 0.3 : 1e-9);
  }
}

// What the samples do not show has no persistence: a point that is not critical, called uncertain,
// and a second maximum beside another with a saddle between them.
TEST(Persistence, spuriousPointsHaveLittle)
{
  Sampled torus(slantedWaves(), 20000, 8);
  Sampled spurious(slantedWaves(), 20000, 8);
  const std::vector<CriticalPair> expected = torus.assign();

  const auto addAt = [&](const Vector2d& angles, CriticalType type, double rise)
  {
    CriticalPoint point;
    point.position = torusPoint(angles);
    Neighborhood nearest;
    spurious.graph.nearest(point.position - spurious.graph.origin(), 1, nearest);
    point.input = spurious.graph.inputOfPoint(nearest.indices.front());
    point.value = spurious.function.value(point.position) + rise;
    point.type = type;
    spurious.points.push_back(point);
  };
  const std::size_t exact = spurious.points.size();
  addAt({ 0.6, 0.4 }, CriticalType::Uncertain, 0.0);
  addAt({ 0.05, 0.35 }, CriticalType::Maximum, 0.001);
  addAt({ 0.05, 0.25 }, CriticalType::Saddle, 0.0);
  spurious.points.back().value = spurious.points[exact + 1].value - 0.0015;
  const std::vector<CriticalPair> pairs = spurious.assign();

  EXPECT_EQ(pairs.size(), expected.size() + 1);
  EXPECT_EQ(spurious.points[exact].persistence, 0.0);
  EXPECT_NEAR(spurious.points[exact + 1].persistence, 0.0015, 1e-9);
  EXPECT_NEAR(spurious.points[exact + 2].persistence, 0.0015, 1e-9);
  for (std::size_t i = 0; i < exact; ++i)
  {
    EXPECT_NEAR(spurious.points[i].persistence, torus.points[i].persistence, 1e-9);
  }
}

// A saddle that the finder missed costs its extremum a partner, not its persistence.
TEST(Persistence, missedSaddlesAreSeenByTheGraph)
{
  Sampled torus(slantedWaves(), 20000, 9);
  const std::vector<CriticalPair> pairs = torus.assign();
  for (const CriticalPair& missed : pairs)
  {
    Sampled other(slantedWaves(), 20000, 9);
    other.points[missed.saddle].type = CriticalType::Regular;
    const std::vector<CriticalPair> others = other.assign();
    EXPECT_NEAR(other.points[missed.extremum].persistence, missed.persistence, 0.1);
  }
}

// A monkey saddle between three minima and three maxima at the boundary, which are not critical: it
// has the persistence of what it joins.
TEST(Persistence, saddlesJoinComponentsOfTheBoundary)
{
  const NeighborGraph graph(randomPlane(5000, 10), nearest(16));
  Values values(graph.pointCount());
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    const Vector3d p = graph.points().col(i) + graph.origin();
    values[i] = p.x() * p.x() * p.x() - 3.0 * p.x() * p.y() * p.y();
  }
  CriticalPoint monkey;
  monkey.position = Vector3d::Zero();
  monkey.type = CriticalType::Saddle;
  monkey.multiplicity = 2;
  Neighborhood nearest;
  graph.nearest(-graph.origin(), 1, nearest);
  monkey.input = graph.inputOfPoint(nearest.indices.front());
  std::vector<CriticalPoint> points{ monkey };
  EXPECT_TRUE(assignPersistence(points, graph, values).empty());
  EXPECT_NEAR(points[0].persistence, 2.0, 0.15) << "the lesser two of the minima -2, -2, -1";
}

} // namespace
} // namespace SurfaceScalars::Truth
