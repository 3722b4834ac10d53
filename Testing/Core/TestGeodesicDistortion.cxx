// Distances between level sets along surfaces, against exact ones.

#include "CrossedCells.h"
#include "LevelSetDistortion.h"
#include "MeshExamples.h"
#include "Polyline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

LevelSetDistortion geodesic(const Mesh& mesh, const Values& values, const Values& isoValues)
{
  const MeshTopology topology(static_cast<Index>(mesh.vertices.cols()), mesh.triangles);
  return geodesicDistortion(mesh.vertices, topology, values, isoValues, Values());
}

using Segment = std::array<Vector3d, 2>;

/// Of the curve that f, linear on triangles, makes of a value.
std::vector<Segment> segmentsOf(const Mesh& mesh, const Values& values, double isoValue)
{
  std::vector<Segment> segments;
  for (Eigen::Index triangle = 0; triangle < mesh.triangles.cols(); ++triangle)
  {
    std::vector<Vector3d> ends;
    for (const int i : { 0, 1, 2 })
    {
      const Index from = mesh.triangles(i, triangle);
      const Index to = mesh.triangles((i + 1) % 3, triangle);
      if ((values[from] < isoValue) != (values[to] < isoValue))
      {
        ends.push_back(
          crossingOf(mesh.vertices, values, std::min(from, to), std::max(from, to), isoValue));
      }
    }
    if (ends.size() == 2)
    {
      segments.push_back({ ends[0], ends[1] });
    }
  }
  return segments;
}

/// The greatest distance in space of an end of a segment to the others, over all pairs.
double farthest(const std::vector<Segment>& from, const std::vector<Segment>& to)
{
  double greatest = 0.0;
  for (const Segment& segment : from)
  {
    for (const Vector3d& end : segment)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const Segment& other : to)
      {
        least = std::min(least, distanceToSegment(end, other[0], other[1]));
      }
      greatest = std::max(greatest, least);
    }
  }
  return greatest;
}

// On a flat mesh where nothing has to bend, the distances are those in the plane, to rounding,
// however irregular its triangles and however far apart the level sets. Of stretched ones the
// farthest place may be missed, where the front that points to it is ahead; no way is too long.
TEST(GeodesicDistortion, isStraightInThePlane)
{
  for (const double stretch : { 1.0, 4.0 })
  {
    for (const double shake : { 0.0, 0.24 })
    {
      Mesh mesh = squareMesh(40, shake);
      mesh.vertices.row(0) *= stretch;
      const Values radii =
        (mesh.vertices.colwise() - Vector3d(0.5 * stretch, 0.5, 0.0)).colwise().norm();
      for (const int count : { 6, 12, 40 })
      {
        const LevelSetDistortion distortion =
          geodesic(mesh, radii, Values::LinSpaced(count, 0.2, 0.45));
        ASSERT_EQ(distortion.distances.size(), count - 1);
        for (Eigen::Index i = 0; i < distortion.distances.size(); ++i)
        {
          const auto one = segmentsOf(mesh, radii, distortion.isoValues[i]);
          const auto other = segmentsOf(mesh, radii, distortion.nextIsoValues[i]);
          const double exact = std::max(farthest(one, other), farthest(other, one));
          const double ratio = distortion.distances[i] / exact;
          EXPECT_LT(ratio, 1.0 + 1e-9) << stretch << ", " << shake << ", " << count << ", " << i;
          EXPECT_GT(ratio, stretch > 1.0 ? 0.98 : 1.0 - 1e-9) << shake << ", " << count;
        }
      }
    }
  }
}

/// Greatest relative error of the distances. @param exact by the values at both ends
double errorOf(
  const LevelSetDistortion& distortion, const std::function<double(double, double)>& exact)
{
  EXPECT_GT(distortion.distances.size(), 0);
  double error = 0.0;
  for (Eigen::Index i = 0; i < distortion.distances.size(); ++i)
  {
    const double truth = exact(distortion.isoValues[i], distortion.nextIsoValues[i]);
    error = std::max(error, std::abs(distortion.distances[i] / truth - 1.0));
  }
  return error;
}

/// The unit sphere; vertices are moved by up to `shake` of an edge, and triangles are stretched up
/// to `stretch` to 1.
Mesh uneven(int levels, double shake, double stretch)
{
  Mesh mesh = sphereMesh(levels);
  Random random(4);
  const double edge = 0.5 * Pi * std::pow(0.5, levels);
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i)
  {
    const Vector3d step(
      random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    Vector3d place = (mesh.vertices.col(i) + shake * edge * step).normalized();
    place.x() *= stretch;
    mesh.vertices.col(i) = place.normalized();
  }
  return mesh;
}

// On the unit sphere, level sets of the height are an arc apart. What is left is that f and the
// surface are linear on triangles, whose error falls with the square of their edges.
TEST(GeodesicDistortion, isAnArcOnTheSphere)
{
  struct Case
  {
    double shake;
    double stretch;
    double bound;
  };
  const Values isoValues = Values::LinSpaced(40, -0.8, 0.8);
  const auto arc = [](double lower, double upper) { return std::asin(upper) - std::asin(lower); };
  for (const Case& shape : { Case{ 0.0, 1.0, 0.02 }, Case{ 0.2, 1.0, 0.03 }, Case{ 0.0, 4.0, 0.12 },
         Case{ 0.2, 4.0, 0.16 } })
  {
    double bound = shape.bound;
    for (const int levels : { 5, 6 })
    {
      const Mesh mesh = uneven(levels, shape.shake, shape.stretch);
      const Values height = Vector3d(0.36, 0.48, 0.8).transpose() * mesh.vertices;
      const double error = errorOf(geodesic(mesh, height, isoValues), arc);
      EXPECT_LT(error, bound) << shape.shake << ", " << shape.stretch << ", " << levels;
      bound /= 3.0;
    }
  }
}

/// What a condition on their middles leaves of the triangles, and their corners.
Mesh partOf(const Mesh& mesh, const std::function<bool(const Vector3d&)>& isKept)
{
  Mesh part{ Points(3, mesh.vertices.cols()), Triangles(3, mesh.triangles.cols()) };
  std::vector<Index> numbers(static_cast<std::size_t>(mesh.vertices.cols()), 0);
  Index vertices = 0;
  Eigen::Index triangles = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
  {
    if (!isKept(mesh.vertices(Eigen::all, mesh.triangles.col(i)).rowwise().mean()))
    {
      continue;
    }
    for (const int corner : { 0, 1, 2 })
    {
      Index& number = numbers[mesh.triangles(corner, i)];
      if (number == 0)
      {
        part.vertices.col(vertices) = mesh.vertices.col(mesh.triangles(corner, i));
        number = ++vertices;
      }
      part.triangles(corner, triangles) = number - 1;
    }
    ++triangles;
  }
  part.vertices.conservativeResize(3, vertices);
  part.triangles.conservativeResize(3, triangles);
  return part;
}

// Around the inner corner of an L, where straight lines leave the surface, ways bend: as long as
// both parts, not as short as a line through the gap.
TEST(GeodesicDistortion, bendsAroundCorners)
{
  const Mesh mesh = partOf(
    squareMesh(60, 0.2), [](const Vector3d& place) { return place.x() < 0.5 || place.y() < 0.5; });
  const Values values = mesh.vertices.row(0) - mesh.vertices.row(1);
  const LevelSetDistortion distortion = geodesic(mesh, values, Eigen::Vector2d(-0.4, 0.4));
  ASSERT_EQ(distortion.distances.size(), 1);
  // From (0.5, 0.9) by (0.5, 0.5) to (0.7, 0.3), the nearest of x - y = 0.4.
  EXPECT_NEAR(distortion.distances[0], 0.4 + std::sqrt(0.08), 0.01);
}

} // namespace
} // namespace SurfaceScalars::Truth
