#include "ModelExamples.h"
#include "Polyline.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

constexpr double Width = 0.8;
constexpr double Level = 0.7;
const Vector3d Center(0.03, -0.02, 0.0);

/// Of a place in the plane from the circle where bump(Center, Width) is Level.
double distanceFromCircle(const Vector3d& place)
{
  return std::abs((place - Center).norm() - radiusOf(Level, Width));
}

double distanceToCurve(const Vector3d& place, const LevelSetCurve& curve)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    least = std::min(least,
      distanceToSegment(
        place, curve.points[i].position, curve.points[(i + 1) % curve.points.size()].position));
  }
  return least;
}

// The curve's points are on the level set to rounding, what lies between them within the tolerance,
// and each point of the level set is that close to the curve: both Hausdorff distances.
TEST(MeshlessContour, staysWithinTheToleranceOfACircle)
{
  const Field field = bump(Center, Width);
  for (const double tolerance : { 1e-2, 1e-3, 1e-4, 1e-5, 1e-6 })
  {
    const MeshlessContours contours =
      contoursOf(field, centeredSquare(7, 1.6, 0.3), { Level }, tolerance, 14);
    ASSERT_EQ(contours.sets.curves.size(), 1u);
    const LevelSetCurve& curve = contours.sets.curves.front();
    EXPECT_TRUE(curve.closed);
    for (const LevelSetPoint& point : curve.points)
    {
      EXPECT_LE(distanceFromCircle(point.position), 1e-13);
      EXPECT_LE(point.residual, 1e-13);
    }
    EXPECT_LE(largestDistance(curve, distanceFromCircle), tolerance);
    EXPECT_LE(contours.largestDeviation, tolerance);
    const double radius = radiusOf(Level, Width);
    for (int i = 0; i < 1000; ++i)
    {
      const double angle = 2.0 * Pi * i / 1000;
      const Vector3d place = Center + radius * Vector3d(std::cos(angle), std::sin(angle), 0.0);
      EXPECT_LE(distanceToCurve(place, curve), tolerance);
    }
  }
}

/// The mean distance from the circle along the curve.
double meanDistance(const LevelSetCurve& curve)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    const Vector3d& from = curve.points[i].position;
    const Vector3d along = curve.points[(i + 1) % curve.points.size()].position - from;
    for (const double t : { 0.125, 0.375, 0.625, 0.875 })
    {
      sum += 0.25 * along.norm() * distanceFromCircle(from + t * along);
    }
  }
  return sum / curve.length;
}

// Halving edges divides the error by four, and the largest deviation foretells it.
TEST(MeshlessContour, isOfSecondOrder)
{
  const Field field = bump(Center, Width);
  const Mesh mesh = centeredSquare(6, 1.6, 0.2);
  double before = 0.0;
  for (int refinement = 0; refinement <= 6; ++refinement)
  {
    const MeshlessContours contours = contoursOf(field, mesh, { Level }, 1e-12, refinement);
    const LevelSetCurve& curve = contours.sets.curves.front();
    EXPECT_LE(largestDistance(curve, distanceFromCircle), 1.05 * contours.largestDeviation);
    const double error = meanDistance(curve);
    if (refinement >= 3) // before, some triangles have yet to follow
    {
      EXPECT_NEAR(before / error, 4.0, 0.7) << refinement;
    }
    before = error;
  }
}

// A peak within one triangle is found, at which no edge is crossed, and so is one narrower still if
// the triangle may be cut more often.
TEST(MeshlessContour, findsWhatNoEdgeCrosses)
{
  Mesh triangle{ Points(3, 3), Triangles(3, 1) };
  triangle.vertices << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  triangle.triangles << 0, 1, 2;
  for (const double width : { 0.1, 0.03, 0.01 })
  {
    const Vector3d center(0.31, 0.27, 0.0);
    const MeshlessContours contours =
      contoursOf(bump(center, width), triangle, { 0.5 }, 0.01 * width, 12);
    ASSERT_EQ(contours.sets.curves.size(), 1u) << width;
    EXPECT_NEAR(contours.sets.curves.front().length / (2.0 * Pi * radiusOf(0.5, width)), 1.0, 0.02);
  }
}

// The sphere around a vertex of an octahedron meets its faces in arcs: all points are on both.
TEST(MeshlessContour, liesOnTheMeshAndOnTheLevelSet)
{
  const Mesh mesh = sphereMesh(0);
  const Vector3d corner = mesh.vertices.col(0);
  const MeshlessContours contours = contoursOf(bump(corner, Width), mesh, { Level }, 1e-5, 12);
  ASSERT_EQ(contours.sets.curves.size(), 1u);
  const LevelSetCurve& curve = contours.sets.curves.front();
  EXPECT_TRUE(curve.closed);
  const double radius = radiusOf(Level, Width);
  // Faces meet the axes at 1; the corner is at distance 1 / sqrt(3) from their edges' planes.
  EXPECT_LE(largestDistance(curve,
              [&](const Vector3d& place)
              { return std::abs(place.cwiseAbs().sum() - 1.0) / std::sqrt(3.0); }),
    1e-12);
  EXPECT_LE(largestDistance(curve,
              [&](const Vector3d& place) { return std::abs((place - corner).norm() - radius); }),
    1e-5);
  // A face is seen from its corner under 60 degrees: four arcs.
  EXPECT_NEAR(curve.length, 4.0 * radius * Pi / 3.0, 1e-4);
}

// Larger values lie to the left of the way along the curve, seen against the normals, whichever way
// the triangles run; the normals are those of most of the triangles.
TEST(MeshlessContour, keepsLargerValuesToTheLeft)
{
  const Field field = bump(Center, Width);
  Mesh mesh = centeredSquare(7, 1.6, 0.3);
  for (int turned = 0; turned < 3; ++turned)
  {
    if (turned > 0) // some, then all
    {
      for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
      {
        if (turned == 2 ? i % 3 != 0 : i % 3 == 0)
        {
          mesh.triangles.col(i).reverseInPlace();
        }
      }
    }
    const LevelSetCurve curve = contoursOf(field, mesh, { Level }).sets.curves.front();
    for (std::size_t i = 0; i < curve.points.size(); ++i)
    {
      const Vector3d& place = curve.points[i].position;
      const Vector3d along = curve.points[(i + 1) % curve.points.size()].position - place;
      const Vector3d left = curve.points[i].normal.cross(along);
      EXPECT_GT(left.dot(Center - place), 0.0);
      EXPECT_NEAR(curve.points[i].normal.z(), turned == 2 ? -1.0 : 1.0, 1e-12);
    }
  }
}

// A line along an edge of the mesh whose vertices have the very level: each point once.
TEST(MeshlessContour, passesThroughVerticesOfTheVeryLevel)
{
  const MeshlessContours contours =
    contoursOf(linearField(Vector3d(1, 0, 0)), squareMesh(8, 0.0), { 0.5 });
  ASSERT_EQ(contours.sets.curves.size(), 1u);
  const LevelSetCurve& curve = contours.sets.curves.front();
  EXPECT_FALSE(curve.closed);
  EXPECT_DOUBLE_EQ(curve.length, 1.0);
  EXPECT_EQ(curve.points.size(), 9u);
}

// On a closed mesh curves close, on one with a boundary they are closed or end there.
TEST(MeshlessContour, endsAtTheBoundaryOnly)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    Random random(seed);
    const Points centers = 0.7 * Points::Random(3, 12);
    Values heights(12);
    std::generate(heights.begin(), heights.end(), [&] { return random.uniform(-1.0, 1.0); });
    const Field field = gaussians(centers, heights, 0.4);
    for (const LevelSetCurve& curve : contoursOf(field, sphereMesh(2), { 0.1, -0.2 }).sets.curves)
    {
      EXPECT_TRUE(curve.closed) << seed;
    }
    for (const LevelSetCurve& curve :
      contoursOf(field, centeredSquare(9, 1.5, 0.3), { 0.1, -0.2 }).sets.curves)
    {
      for (const LevelSetPoint* end : { &curve.points.front(), &curve.points.back() })
      {
        EXPECT_TRUE(curve.closed || end->position.cwiseAbs().maxCoeff() == 0.75) << seed;
      }
    }
  }
}

// Curves are the same to the bit with one thread and with several.
TEST(MeshlessContour, doesNotDependOnTheNumberOfThreads)
{
  const Field field = bump(Vector3d(1.0, 0.2, 0.1), Width);
  const Mesh mesh = torusMesh(60, true);
  const MeshlessContourParameters parameters{ { 0.2, 0.5, 0.8 }, 1e-5, 8 };
  const MeshlessContours one =
    traceMeshlessContours(field, mesh.vertices, mesh.triangles, parameters, { 1, {} });
  const MeshlessContours two =
    traceMeshlessContours(field, mesh.vertices, mesh.triangles, parameters, { 2, {} });
  ASSERT_EQ(one.sets.curves.size(), two.sets.curves.size());
  EXPECT_EQ(one.evaluations, two.evaluations);
  for (std::size_t i = 0; i < one.sets.curves.size(); ++i)
  {
    EXPECT_EQ(positionsOf(one.sets.curves[i].points), positionsOf(two.sets.curves[i].points));
  }
}

// Where the level set is not, u is not evaluated: of a mesh of 90,000 vertices at a few percent.
TEST(MeshlessContour, evaluatesNearTheLevelSetOnly)
{
  const Mesh mesh = centeredSquare(300, 4.0, 0.3);
  const MeshlessContours contours = contoursOf(bump(Center, Width), mesh, { Level });
  EXPECT_EQ(contours.sets.curves.size(), 1u);
  EXPECT_LT(contours.evaluatedVertices, mesh.vertices.cols() / 40);
  EXPECT_LT(contours.evaluations, static_cast<std::size_t>(mesh.vertices.cols()) / 10);
}

} // namespace
} // namespace SurfaceScalars
