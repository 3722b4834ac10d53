#include "Error.h"
#include "GluedPairs.h"
#include "Meshes.h"
#include "MeshlessApproximation.h"
#include "VolumeCriticalPoints.h"
#include "VolumeDomain.h"
#include "VolumeExamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

/// A height with noise on it, noise alone, and few different values.
std::vector<Values> functionsOn(const Volume& volume, unsigned seed)
{
  const Values smooth = Vector3d(0.3, 0.5, 0.8).transpose() * volume.vertices;
  Values noise = Values::Zero(smooth.size());
  addNoise(noise, 1.0, seed);
  return { smooth + 0.5 * noise, noise,
    noise.unaryExpr([](double value) { return std::floor(value); }) };
}

// The pairs of minima, saddles and maxima are those of the reduction of the boundary matrix on the
// volume glued to its mirror image: in balls, shells, rings, parts and closed volumes, with ties. A
// threshold leaves out what is less persistent on both sides, and nothing else.
TEST(VolumePersistence, pairsAreThoseOfMatrixReduction)
{
  const std::vector<CriticalType> types{ CriticalType::Minimum, CriticalType::Saddle,
    CriticalType::TwoSaddle, CriticalType::Maximum };
  for (const NamedVolume& named : volumesOfAllKinds())
  {
    const VolumeTopology topology = topologyOf(named.volume);
    for (const Values& values : functionsOn(named.volume, 1))
    {
      SCOPED_TRACE(named.name);
      const TypedPairs expected =
        typedPairs(ReducedPairs(named.volume.tetrahedra, values, Boundary::Mirrored).pairs, types);
      const MeshCriticalPoints found =
        volumeCriticalPoints(named.volume.vertices, topology, values);
      const TypedPairs pairs = typedPairs(found);
      EXPECT_TRUE(std::includes(expected.begin(), expected.end(), pairs.begin(), pairs.end()));
      EXPECT_TRUE(!named.isClosed || pairs == expected);
      expectHalfOfGlued(found, expected, topology, values);
    }
  }
}

// Pairs vanish together: what is left has the indices of the closed volume, sum 0.
TEST(VolumePersistence, removingPairsKeepsEulersSum)
{
  const Volume torus = threeTorus(6);
  for (const Values& values : functionsOn(torus, 4))
  {
    const MeshCriticalPoints all = volumeCriticalPoints(torus.vertices, topologyOf(torus), values);
    const double range = values.maxCoeff() - values.minCoeff();
    for (int step = 0; step <= 20; ++step)
    {
      std::vector<CriticalPoint> kept = all.points;
      removeBelow(kept, all.pairs, range * (step / 20.0));
      EXPECT_EQ(volumeCountsOf(kept).indexSum(), 0);
    }
  }
}

using Lifetime = std::pair<double, double>; ///< of a tunnel

std::vector<Lifetime> tunnelsOf(const Volume& volume, const Values& values)
{
  const MeshCriticalPoints found =
    volumeCriticalPoints(volume.vertices, topologyOf(volume), values);
  std::vector<Lifetime> tunnels;
  for (const CriticalPair& pair : found.pairs)
  {
    const CriticalPoint& first = found.points[pair.extremum];
    const CriticalPoint& last = found.points[pair.saddle];
    if (first.type == CriticalType::Saddle && last.type == CriticalType::TwoSaddle)
    {
      tunnels.emplace_back(first.value, last.value);
    }
  }
  return tunnels;
}

/// Finds others for those that have to have one, by augmenting paths.
class Matching
{
public:
  Matching(const std::vector<Lifetime>& first, const std::vector<Lifetime>& second, double distance)
    : first_(first)
    , second_(second)
    , distance_(distance)
    , partners_(second.size(), -1)
  {
  }

  /// Whether all of the first that last longer than twice the distance have others within it.
  bool exists()
  {
    for (std::size_t i = 0; i < this->first_.size(); ++i)
    {
      this->isSeen_.assign(this->second_.size(), false);
      const auto& [birth, death] = this->first_[i];
      if (death - birth > 2.0 * this->distance_ && !this->findFor(i))
      {
        return false;
      }
    }
    return true;
  }

private:
  bool findFor(std::size_t i)
  {
    for (std::size_t j = 0; j < this->second_.size(); ++j)
    {
      const bool isNear =
        std::abs(this->first_[i].first - this->second_[j].first) <= this->distance_ &&
        std::abs(this->first_[i].second - this->second_[j].second) <= this->distance_;
      if (isNear && !this->isSeen_[j])
      {
        this->isSeen_[j] = true;
        if (this->partners_[j] < 0 || this->findFor(static_cast<std::size_t>(this->partners_[j])))
        {
          this->partners_[j] = static_cast<int>(i);
          return true;
        }
      }
    }
    return false;
  }

  const std::vector<Lifetime>& first_;
  const std::vector<Lifetime>& second_;
  double distance_;
  std::vector<int> partners_;
  std::vector<bool> isSeen_;
};

// Stability (Cohen-Steiner, Edelsbrunner and Harer 2007): values that change by at most epsilon
// move the beginnings and ends of tunnels by at most epsilon, but for those that last at most twice
// that. It is enough to match those that last longer of either side (Mendelsohn and Dulmage).
TEST(VolumePersistence, isStable)
{
  const Volume torus = threeTorus(8);
  Values noise = Values::Zero(torus.vertices.cols());
  addNoise(noise, 1.0, 5);
  for (const double epsilon : { 1e-3, 0.03, 0.3 })
  {
    Values change = Values::Zero(noise.size());
    addNoise(change, 1.0, 6);
    change *= epsilon / change.cwiseAbs().maxCoeff();
    const std::vector<Lifetime> before = tunnelsOf(torus, noise);
    const std::vector<Lifetime> after = tunnelsOf(torus, noise + change);
    EXPECT_GT(before.size(), 50U);
    const double distance = epsilon * (1.0 + 1e-12);
    EXPECT_TRUE(Matching(before, after, distance).exists()) << epsilon;
    EXPECT_TRUE(Matching(after, before, distance).exists()) << epsilon;
  }
}

constexpr int HalfSize = 8;      // of a block around a ring
constexpr double Spacing = 0.25; // of its vertices

/// Along the circle x^2 + y^2 = 1 it is low: {f <= t} closes to a ring at x = 0.85, t = 0.2775, and
/// at the center, t = 1, the ring is filled.
Values ringFunction(const Volume& block)
{
  Values values(block.vertices.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    const Vector3d place = (block.vertices.col(i).array() - HalfSize) * Spacing;
    const double radius = place.head<2>().norm();
    values[i] = (radius - 1.0) * (radius - 1.0) + place.z() * place.z() + 0.3 * place.x();
  }
  return values;
}

/// To the accuracy of the grid, the saddles of the ring are the only ones inside.
void expectTunnel(const std::vector<CriticalPoint>& points, const VolumeTopology& topology)
{
  const auto expectOne = [&](CriticalType type, const Vector3d& place, double value)
  {
    std::vector<CriticalPoint> inside;
    std::copy_if(points.begin(), points.end(), std::back_inserter(inside),
      [&](const CriticalPoint& point)
      { return point.type == type && !topology.isBoundary(static_cast<Index>(point.input)); });
    ASSERT_EQ(inside.size(), 1U);
    const Vector3d found = (inside[0].position.array() - HalfSize) * Spacing;
    EXPECT_LT((found - place).norm(), 0.6);
    EXPECT_NEAR(inside[0].value, value, 0.05);
    EXPECT_NEAR(inside[0].persistence, 1.0 - 0.2775, 0.05);
  };
  expectOne(CriticalType::Saddle, { 0.85, 0.0, 0.0 }, 0.2775);
  expectOne(CriticalType::TwoSaddle, Vector3d::Zero(), 1.0);
}

// A threshold keeps the tunnel of a ring, and no saddles of noise.
TEST(VolumePersistence, knowsTheTunnelOfARing)
{
  const Volume block = blockVolume(2 * HalfSize, 2 * HalfSize, 2 * HalfSize);
  const VolumeTopology topology = topologyOf(block);
  Values values = ringFunction(block);
  addNoise(values, 0.05, 1);
  MeshCriticalPoints found = volumeCriticalPoints(block.vertices, topology, values);
  EXPECT_GT(found.points.size(), 60U);
  removeBelow(found.points, found.pairs, 0.07 * (values.maxCoeff() - values.minCoeff()));
  expectTunnel(found.points, topology);
}

// Nor does an approximation with a threshold.
TEST(VolumePersistence, approximationsKeepTunnels)
{
  const Volume block = blockVolume(2 * HalfSize, 2 * HalfSize, 2 * HalfSize);
  const VolumeTopology topology = topologyOf(block);
  ApproximationParameters parameters;
  parameters.sampleFraction = 0.05;
  parameters.persistenceThreshold = 0.07;
  const MeshlessApproximation result =
    approximateMeshless(volumeDomain(block.vertices, topology), ringFunction(block), parameters);
  expectTunnel(result.persistent, topology);
  EXPECT_TRUE(result.lost.empty());
}

// Progress never falls, and wherever it is stopped, the work ends without a result.
TEST(VolumePersistence, canBeStopped)
{
  const Volume block = blockVolume(6, 6, 6);
  const VolumeTopology topology = topologyOf(block);
  const Values values = functionsOn(block, 1)[1];
  int count = 0;
  double last = 0.0;
  volumeCriticalPoints(block.vertices, topology, values,
    { 1,
      [&](double fraction)
      {
        ++count;
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
      } });
  EXPECT_EQ(last, 1.0);
  EXPECT_GT(count, 10);
  for (int stop = 0; stop < count; ++stop)
  {
    int calls = 0;
    EXPECT_THROW(volumeCriticalPoints(
                   block.vertices, topology, values, { 1, [&](double) { return calls++ < stop; } }),
      Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
