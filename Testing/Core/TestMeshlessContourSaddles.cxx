#include "FieldTruth.h"
#include "MeshCriticalPoints.h"
#include "ModelExamples.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

constexpr double Width = 0.5;

/// Equal Gaussians in a row along x, 2 * 0.45 apart, with the middle at a place.
Field row(int count, const Vector3d& middle)
{
  Points centers(3, count);
  for (int i = 0; i < count; ++i)
  {
    centers.col(i) = middle + Vector3d(0.9 * (i - 0.5 * (count - 1)), 0.0, 0.0);
  }
  return gaussians(centers, Values::Ones(count), Width);
}

double valueAt(const Field& field, const Vector3d& place)
{
  return field.evaluate(place, {}).values[0];
}

/// How many points of the curves are at the place.
std::ptrdiff_t countAt(const LevelSets& sets, const Vector3d& place, double precision = 1e-10)
{
  std::ptrdiff_t count = 0;
  for (const LevelSetCurve& curve : sets.curves)
  {
    count += std::count_if(curve.points.begin(), curve.points.end(),
      [&](const LevelSetPoint& point) { return (point.position - place).norm() < precision; });
  }
  return count;
}

/// A curve through a place has two branches there, one that ends has one.
int branchesAt(const LevelSets& sets, const Vector3d& place)
{
  int branches = 0;
  for (const LevelSetCurve& curve : sets.curves)
  {
    for (const LevelSetPoint& point : curve.points)
    {
      const bool isEnd =
        !curve.closed && (&point == &curve.points.front() || &point == &curve.points.back());
      branches += (point.position - place).norm() < 1e-9 ? (isEnd ? 1 : 2) : 0;
    }
  }
  return branches;
}

// Two equal peaks: the level of the saddle between them is a figure eight, two loops that meet at
// the saddle, wherever in a triangle, on an edge or at a vertex it lies; also if the level is off
// by less than 1e-6 of the range. Beyond, it is two loops apart or one around both.
TEST(MeshlessContourSaddles, giveAFigureEightOnAPlane)
{
  const Mesh mesh = centeredSquare(9, 3.0, 0.0); // vertices at multiples of 1/3, shifted by 1/6
  for (const Vector3d& middle :
    { Vector3d(0.03, 0.1, 0.0), Vector3d(0.05, 0.05, 0.0), Vector3d(0.05, 1.0 / 6, 0.0),
      Vector3d(1.0 / 6, 1.0 / 6, 0.0), Vector3d(0.02, 1.0 / 6 - 1e-5, 0.0) })
  {
    const Field field = row(2, middle);
    const double level = valueAt(field, middle);
    for (const double off : { 0.0, 1e-9, -1e-9, 9e-7, -9e-7 })
    {
      const LevelSets sets = contoursOf(field, mesh, { level + off }).sets;
      ASSERT_EQ(sets.curves.size(), 2u) << middle.transpose() << " " << off;
      EXPECT_TRUE(sets.curves[0].closed && sets.curves[1].closed);
      EXPECT_NEAR(sets.curves[0].length / sets.curves[1].length, 1.0, 1e-2);
      EXPECT_EQ(countAt(sets, middle), 2) << middle.transpose() << " " << off;
    }
    EXPECT_EQ(contoursOf(field, mesh, { level + 3e-6 }).sets.curves.size(), 2u);
    EXPECT_EQ(contoursOf(field, mesh, { level - 3e-6 }).sets.curves.size(), 1u);
    EXPECT_EQ(countAt(contoursOf(field, mesh, { level + 3e-6 }).sets, middle), 0);
  }
}

// Three peaks in a row: two saddles of one level, a loop around each peak.
TEST(MeshlessContourSaddles, joinBranchesBetweenTwoSaddles)
{
  const Field field = row(3, Vector3d(0.02, 0.03, 0.0));
  const Vector3d saddle(0.02 + 0.45, 0.03, 0.0); // nearly: the third peak moves it
  double low = -0.1;
  double high = 0.1;
  const auto along = [&](double x) { return valueAt(field, saddle + Vector3d(x, 0, 0)); };
  for (int i = 0; i < 60; ++i) // the least value between the peaks
  {
    const double third = (high - low) / 3.0;
    (along(low + third) < along(high - third) ? high : low) +=
      along(low + third) < along(high - third) ? -third : third;
  }
  const double level = along(low);
  const LevelSets sets = contoursOf(field, centeredSquare(11, 3.4, 0.2), { level }).sets;
  ASSERT_EQ(sets.curves.size(), 3u);
  for (const LevelSetCurve& curve : sets.curves)
  {
    EXPECT_TRUE(curve.closed);
  }
}

// Peaks and pits in turn around a place are a saddle of multiplicity 2 there: six branches, which
// end at the boundary.
TEST(MeshlessContourSaddles, haveSixBranchesIfTheyAreDouble)
{
  Points centers(3, 6);
  Values heights(6);
  const Vector3d middle(0.04, 0.07, 0.0);
  for (int i = 0; i < 6; ++i)
  {
    const double angle = 0.1 + Pi / 3 * i;
    centers.col(i) = middle + 0.6 * Vector3d(std::cos(angle), std::sin(angle), 0.0);
    heights[i] = i % 2 == 0 ? 1.0 : -1.0;
  }
  const LevelSets sets =
    contoursOf(gaussians(centers, heights, Width), centeredSquare(8, 2.0, 0.2), { 0.0 }).sets;
  ASSERT_EQ(sets.curves.size(), 6u);
  EXPECT_EQ(countAt(sets, middle, 1e-6), 6);
  for (const LevelSetCurve& curve : sets.curves)
  {
    EXPECT_FALSE(curve.closed);
  }
}

// The height on a torus restricted to its mesh has saddles at vertices: the level of each is 1 + m
// loops that meet there, in addition to those of the other components.
TEST(MeshlessContourSaddles, giveLoopsAtVerticesOfATorus)
{
  const Mesh mesh = torusMesh(40, true);
  const Vector3d up = Vector3d(1.0, 0.13, 0.07).normalized();
  const MeshTopology topology(static_cast<Index>(mesh.vertices.cols()), mesh.triangles);
  const Values heights = mesh.vertices.transpose() * up;
  const VertexTypes types = classifyVertices(topology, heights);
  int saddles = 0;
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    if (types.types[vertex] != CriticalType::Saddle)
    {
      continue;
    }
    ++saddles;
    const LevelSets sets = contoursOf(linearField(up), mesh, { heights[vertex] }).sets;
    EXPECT_EQ(countAt(sets, mesh.vertices.col(vertex)),
      1 + static_cast<std::ptrdiff_t>(types.multiplicities[vertex]));
    for (const LevelSetCurve& curve : sets.curves)
    {
      EXPECT_TRUE(curve.closed);
    }
  }
  EXPECT_GE(saddles, 2);
}

/// Gaussians of random heights at random places.
Field randomGaussians(unsigned seed, double width = 0.45)
{
  Random random(seed);
  Points centers = randomPlaces(25, 1.0, seed);
  centers.row(2) *= 0.2;
  Values heights(25);
  std::generate(heights.begin(), heights.end(), [&] { return random.uniform(-1.0, 1.0); });
  return gaussians(centers, heights, width);
}

/// Critical points of a field in the plane z = 0, by Newton's method from random places, that are
/// saddles.
std::vector<Vector3d> saddlesInPlane(const Field& field, unsigned seed)
{
  const auto approximation = field.approximation();
  const Vector3d origin = field.cloud().origin();
  std::vector<Vector3d> saddles;
  const Points starts = randomPlaces(40, 0.9, seed);
  for (Eigen::Index start = 0; start < starts.cols(); ++start)
  {
    Vector3d place(starts(0, start), starts(1, start), 0.0);
    double determinant = 0.0;
    Vector2d step(1.0, 1.0);
    for (int i = 0; i < 40 && step.norm() > 1e-14 && place.cwiseAbs().maxCoeff() < 0.95; ++i)
    {
      const FieldJet jet = approximation->jet(place - origin, Derivatives::Hessian);
      const Eigen::Matrix2d hessian = jet.hessian.topLeftCorner<2, 2>();
      determinant = hessian.determinant();
      step = -hessian.inverse() * jet.gradient.head<2>();
      place.head<2>() += step * std::min(1.0, 0.1 / step.norm());
    }
    const bool isNew = std::none_of(saddles.begin(), saddles.end(),
      [&](const Vector3d& other) { return (other - place).norm() < 1e-6; });
    if (isNew && step.norm() <= 1e-14 && determinant < 0.0)
    {
      saddles.push_back(place);
    }
  }
  return saddles;
}

// Four branches meet at every saddle of random functions, on meshes coarser and finer than these:
// each curve through it has two of them, or ends there.
TEST(MeshlessContourSaddles, areFoundOnAPlane)
{
  int count = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const Field field = randomGaussians(seed);
    const Mesh mesh = centeredSquare(3 + static_cast<int>(seed) % 9, 2.0, 0.3);
    for (const Vector3d& saddle : saddlesInPlane(field, seed))
    {
      const LevelSets sets = contoursOf(field, mesh, { valueAt(field, saddle) + 5e-7 }).sets;
      EXPECT_EQ(branchesAt(sets, saddle), 4) << "seed " << seed << " at " << saddle.transpose();
      ++count;
    }
  }
  EXPECT_GT(count, 15);
}

// On a mesh that bends at its edges a smooth function has saddles on these: where it has a minimum
// along the edge and falls on both sides, or the other way round.
TEST(MeshlessContourSaddles, areFoundOnEdges)
{
  Mesh roof{ Points(3, 4), Triangles(3, 2) };
  roof.vertices << 0, 0, 1, -1, -1, 1, 0.1, 0.1, 0, 0, -1, -0.8;
  roof.triangles << 0, 1, 1, 0, 2, 3;
  const Vector3d place(0.0, 0.2, 0.0);
  // y^2 and a slope upwards, of a Gaussian far below: least at `place` along the ridge.
  const Field field = gaussians(place - Vector3d(0.0, 0.0, 0.7), -Values::Ones(1), 0.8);
  const double level = valueAt(field, place);
  const LevelSets sets = contoursOf(field, roof, { level }).sets;
  ASSERT_EQ(sets.curves.size(), 4u);
  EXPECT_EQ(countAt(sets, place), 4);
}

// Four branches meet where a random function is least along a ridge and falls to both sides, or the
// other way round, however much faster it changes across than along.
TEST(MeshlessContourSaddles, areFoundAlongARidge)
{
  Mesh roof{ Points(3, 4), Triangles(3, 2) };
  roof.vertices << 0, 0, 1, -1, -1, 1, 0.1, 0.1, 0, 0, -1.2, -1;
  roof.triangles << 0, 1, 1, 0, 2, 3;
  int count = 0;
  for (unsigned seed = 1; seed <= 120; ++seed)
  {
    const Field field = randomGaussians(seed, 0.9);
    const auto approximation = field.approximation();
    const Vector3d origin = field.cloud().origin();
    const auto slope = [&](double y) -> Vector3d
    { return approximation->jet(Vector3d(0.0, y, 0.0) - origin, Derivatives::Gradient).gradient; };
    for (double y = -0.95; y < 0.95; y += 0.05)
    {
      double low = y;
      double high = y + 0.05;
      const bool isLeast = slope(low).y() < 0.0;
      for (int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        ((slope(middle).y() < 0.0) == isLeast ? low : high) = middle;
      }
      const Vector3d gradient = slope(low);
      const double left = gradient.dot(Vector3d(-1.0, 0.0, -1.0));
      const double right = gradient.dot(Vector3d(1.0, 0.0, -1.2));
      if (std::abs(gradient.y()) < 1e-12 && (left < -0.01) == isLeast &&
        (right < -0.01) == isLeast && (left > 0.01) != isLeast && (right > 0.01) != isLeast)
      {
        const Vector3d place(0.0, low, 0.0);
        const LevelSets sets = contoursOf(field, roof, { valueAt(field, place) }).sets;
        EXPECT_EQ(branchesAt(sets, place), 4) << "seed " << seed << " at " << low;
        ++count;
      }
    }
  }
  EXPECT_GT(count, 10);
}

// Neither a peak, a pit, a ridge nor a vertex that merely has the level's value is taken for one.
TEST(MeshlessContourSaddles, areNothingElse)
{
  const Mesh mesh = centeredSquare(8, 2.0, 0.2);
  EXPECT_TRUE(contoursOf(bump(Vector3d::Zero(), Width), mesh, { 1.0 }).sets.curves.size() <= 1);
  // A ridge along y, at whose very value there is at most what rounding leaves.
  Points line(3, 41);
  for (int i = 0; i < 41; ++i)
  {
    line.col(i) = Vector3d(0.0, 0.1 * (i - 20), 0.0);
  }
  const Field ridge = gaussians(line, Values::Constant(41, 0.2), 0.3);
  const double top = valueAt(ridge, Vector3d::Zero());
  for (const LevelSetCurve& curve : contoursOf(ridge, mesh, { top - 1e-3 }).sets.curves)
  {
    EXPECT_FALSE(curve.closed);
  }
  const LevelSets line2 =
    contoursOf(linearField(Vector3d(1, 1, 0)), centeredSquare(8, 2.0, 0.0), { 0.0 }).sets;
  EXPECT_EQ(line2.curves.size(), 1u);
}

} // namespace
} // namespace SurfaceScalars
