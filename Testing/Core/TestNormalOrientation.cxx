#include "Error.h"
#include "NormalOrientation.h"
#include "Queries.h"
#include "Sampling.h"
#include "Torus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace SurfaceScalars
{
namespace
{

using NormalField = std::function<Vector3d(const Vector3d&)>;

constexpr int FitCount = 28;

struct Oriented
{
  NeighborGraph graph;
  Points normals;

  Vector3d place(Index point) const
  {
    return this->graph.points().col(point) + this->graph.origin();
  }
};

Oriented orient(const Points& points, int fitCount = FitCount)
{
  NeighborGraph graph(points, NeighborQuery());
  Points normals = estimateNormals(graph, { fitCount, 0.0 });
  orientNormals(graph, normals);
  return { std::move(graph), std::move(normals) };
}

/// How many normals point to the other side than the exact ones, and how far off the others are.
struct Comparison
{
  int opposite = 0;
  double largestAngle = 0.0;
};

Comparison compare(const Oriented& oriented, const NormalField& exact)
{
  Comparison result;
  for (Index i = 0; i < oriented.graph.pointCount(); ++i)
  {
    const double cosine = oriented.normals.col(i).dot(exact(oriented.place(i)));
    result.opposite += cosine < 0.0 ? 1 : 0;
    result.largestAngle = std::max(result.largestAngle, std::acos(std::min(1.0, std::abs(cosine))));
  }
  return result;
}

Vector3d radial(const Vector3d& place)
{
  return place.normalized();
}

Vector3d torusNormalAt(const Vector3d& place)
{
  return Truth::torusNormal(Truth::torusAngles(place));
}

// On closed surfaces all normals point outwards, and the fits of degree 2 know them closely.
TEST(NormalOrientation, pointsOutOfClosedSurfaces)
{
  const Comparison sphere = compare(orient(Truth::randomSphere(3000, 1)), radial);
  EXPECT_EQ(sphere.opposite, 0);
  EXPECT_LT(sphere.largestAngle, 0.05);
  const Comparison torus =
    compare(orient(Truth::randomTorus(5000, Truth::Torus::Closed, 1)), torusNormalAt);
  EXPECT_EQ(torus.opposite, 0);
  EXPECT_LT(torus.largestAngle, 0.1);
}

// Components of the graph are oriented each on its own: two spheres side by side both have their
// normals outside, though half of those of each point to the center of all points.
TEST(NormalOrientation, orientsEachComponent)
{
  const Vector3d aside(1.5, 0.0, 0.0);
  Points points(3, 4000);
  points << Truth::randomSphere(2000, 1).colwise() + aside,
    Truth::randomSphere(2000, 2).colwise() - aside;
  const Comparison comparison = compare(orient(points),
    [&](const Vector3d& place) { return radial(place - (place.x() > 0.0 ? aside : -aside)); });
  EXPECT_EQ(comparison.opposite, 0);
}

// An open sheet, wavy enough for its normals to point to and away from the center of the points:
// they agree, and to the side that most of them want (upwards: it is nearly a graph over z = 0).
TEST(NormalOrientation, agreesOnAnOpenSheet)
{
  Points points = Truth::randomPlane(4000, 1);
  for (auto point : points.colwise())
  {
    point.z() = 0.2 * std::sin(3.0 * point.x()) * std::cos(2.0 * point.y());
  }
  const Comparison comparison = compare(orient(points),
    [](const Vector3d& p)
    {
      return Vector3d(-0.6 * std::cos(3.0 * p.x()) * std::cos(2.0 * p.y()),
        0.4 * std::sin(3.0 * p.x()) * std::sin(2.0 * p.y()), 1.0)
        .normalized();
    });
  EXPECT_EQ(comparison.opposite, 0);
}

// A horizontal plane, on which the center of the points tells nothing, has its normals upwards.
TEST(NormalOrientation, turnsPlanesUpwards)
{
  const Comparison comparison =
    compare(orient(Truth::randomPlane(1000, 1)), [](const Vector3d&) { return Vector3d::UnitZ(); });
  EXPECT_EQ(comparison.opposite, 0);
  EXPECT_LT(comparison.largestAngle, 1e-7);
}

// With noise as wide as two sampling steps the fits need larger neighborhoods; their normals agree.
TEST(NormalOrientation, withstandsNoise)
{
  Points points = Truth::randomTorus(20000, Truth::Torus::Closed, 1);
  Truth::addNoise(points, 0.01 * Truth::torusDiagonal(), 2);
  const Comparison comparison = compare(orient(points, 200), torusNormalAt);
  EXPECT_EQ(comparison.opposite, 0);
}

// Samples on a line have no normal: zero, and no others suffer.
TEST(NormalOrientation, leavesLinesWithoutNormals)
{
  Points points = Points::Zero(3, 50);
  points.row(0).setLinSpaced(0.0, 1.0);
  const Oriented oriented = orient(points);
  EXPECT_TRUE(oriented.normals.isZero(0.0));
}

// Whether to go on is asked at every point: with a radius that covers everything each takes long.
TEST(NormalOrientation, canBeAbortedAtEachPoint)
{
  const NeighborGraph graph(Truth::randomSphere(500, 4), NeighborQuery());
  const FitSize everything{ FitCount, 10.0 };
  for (const int last : { 3, 400 })
  {
    int calls = 0;
    const Execution execution{ 1, [&](double) { return ++calls < last; } };
    EXPECT_THROW(estimateNormals(graph, everything, execution), Aborted);
    EXPECT_EQ(calls, last);
  }
}

// Neither the number of threads nor the signs of the estimates matter: the same normals bit for
// bit.
TEST(NormalOrientation, isDeterministic)
{
  const Points points = Truth::randomTorus(5000, Truth::Torus::Cut, 3);
  const NeighborGraph graph(points, NeighborQuery());
  const Points one = estimateNormals(graph, { FitCount, 0.0 }, { 1, {} });
  EXPECT_EQ(one, estimateNormals(graph, { FitCount, 0.0 }, { 3, {} }));
  Points flipped = one;
  flipped.rightCols(2000) *= -1.0; // the signs of estimates mean nothing
  Points expected = one;
  orientNormals(graph, expected);
  orientNormals(graph, flipped);
  EXPECT_EQ(expected, flipped);
}

} // namespace
} // namespace SurfaceScalars
