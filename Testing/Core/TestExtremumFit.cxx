#include "ExtremumFit.h"
#include "Functions.h"
#include "Meshes.h"
#include "Sampling.h"
#include "SmoothingQueries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr double Length = 0.06;
constexpr double Noise = 0.1;

/// A sphere as rough as a scan.
TriangleMesh roughSphere()
{
  TriangleMesh mesh = subdividedSphere(5);
  Values heights = Values::Ones(mesh.points.cols());
  addNoise(heights, 0.003, 7);
  mesh.points = mesh.points * heights.asDiagonal();
  return mesh;
}

Index highest(const Values& values)
{
  Eigen::Index vertex = 0;
  values.maxCoeff(&vertex);
  return static_cast<Index>(vertex);
}

class ExtremumFit : public testing::Test
{
protected:
  /// With a tolerance of everything.
  Index fitted(const Values& values, const Values& smooth, Index vertex, double sign,
    double tolerance = 100.0) const
  {
    return fittedExtremum({ mesh_.topology(), mesh_.vertices(), values, smooth, Length, Noise },
      vertex, tolerance, sign, [] {});
  }

  double distance(Index a, Index b) const
  {
    return (mesh_.vertices().col(a) - mesh_.vertices().col(b)).norm();
  }

  const SmoothingMesh mesh_ = smoothingMesh(roughSphere());
};

// A function that is smooth in space has its highest vertex where the surface sticks out. Smoothing
// misses it; the mean square with fits is less than half, for the lowest vertex of -f alike.
TEST_F(ExtremumFit, findsExtremaOfFunctionsOfThePlace)
{
  const Values clean = valuesOf(tiltedHeight(), mesh_.vertices());
  const TikhonovSmoother& smoother = mesh_.smoother({});
  double ofSmooth = 0.0;
  double ofFits = 0.0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    Values noisy = clean;
    addNoise(noisy, Noise, seed);
    const Values smooth = smoother.smooth(noisy, smoother.epsilonOfLength(Length));
    const Index start = highest(smooth);
    const Index found = fitted(noisy, smooth, start, 1.0);
    EXPECT_EQ(fitted(-noisy, -smooth, start, -1.0), found);
    ofSmooth += std::pow(distance(start, highest(clean)), 2);
    ofFits += std::pow(distance(found, highest(clean)), 2);
  }
  EXPECT_LT(ofFits, 0.5 * ofSmooth);
}

// Without noise it is the highest vertex within half of the largest window over which f is a
// quadric.
TEST_F(ExtremumFit, isExactWithoutNoise)
{
  const Values clean = valuesOf(tiltedHeight(), mesh_.vertices());
  Index start = highest(clean);
  for (int step = 0; step < 3; ++step)
  {
    start = *mesh_.topology().link(start).begin();
  }
  const Index found = fitted(clean, clean, start, 1.0);
  for (Index vertex = 0; vertex < mesh_.topology().vertexCount(); ++vertex)
  {
    EXPECT_TRUE(distance(vertex, start) > 3.0 * Length || clean[vertex] <= clean[found]);
  }
}

// Where f is no quadric over a window of the least size, the vertex remains; so it does without
// tolerance.
TEST_F(ExtremumFit, leavesOthersWhereTheyAre)
{
  const auto shortWaves = [](const Vector3d& p)
  { return 20.0 * std::cos(8.0 * p.x()) * std::cos(8.0 * p.y()); };
  const Values waves = valuesOf(shortWaves, mesh_.vertices());
  const Values height = valuesOf(tiltedHeight(), mesh_.vertices());
  for (Index vertex = 0; vertex < mesh_.topology().vertexCount(); vertex += 100)
  {
    EXPECT_EQ(fitted(waves, waves, vertex, 1.0), vertex);
    EXPECT_EQ(fitted(height, height, vertex, 1.0, 0.0), vertex);
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
