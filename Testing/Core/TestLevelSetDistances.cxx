#include "LevelSetCoverage.h"
#include "LevelSetDistortion.h"
#include "MeshExamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace SurfaceScalars::Truth
{
namespace
{

const Values None; ///< critical values

/// Greatest relative error of the distances.
double errorOf(const LevelSetDistortion& distortion, const std::function<double(double)>& exact)
{
  EXPECT_GT(distortion.distances.size(), 0);
  double error = 0.0;
  for (Eigen::Index i = 0; i < distortion.distances.size(); ++i)
  {
    const double truth = exact(distortion.isoValues[i]);
    error = std::max(error, std::abs(distortion.distances[i] - truth) / truth);
  }
  return error;
}

// On the unit sphere, level sets of the height are circles: along the surface they are an arc from
// each other, through space its chord.
TEST(LevelSetDistances, isAnArcOnTheSphere)
{
  const Values isoValues = Values::LinSpaced(12, -0.8, 0.8);
  const auto arc = [&](double height)
  { return std::asin(height + isoValues[1] - isoValues[0]) - std::asin(height); };
  const auto chord = [&](double height) { return 2.0 * std::sin(0.5 * arc(height)); };
  double bound = 0.04;
  for (const int levels : { 4, 5, 6 })
  {
    const TriangleMesh mesh = subdividedSphere(levels);
    const MeshTopology topology = topologyOf(mesh);
    const Values height = Vector3d(0.36, 0.48, 0.8).transpose() * mesh.points;
    EXPECT_LT(
      errorOf(geodesicDistortion(mesh.points, topology, height, isoValues, None), arc), bound);
    EXPECT_LT(
      errorOf(hausdorffDistortion(mesh.points, edgesOf(topology), height, isoValues, None), chord),
      4.0 * bound);
    bound /= 2.0;
  }
}

/// A flat annulus of radii 1 to 3. Vertices are moved along their circles by up to half an edge.
TriangleMesh annulusMesh(int rings)
{
  const int around = 7 * rings;
  TriangleMesh annulus = gridMesh(Grid::Cylinder, around, rings);
  Random random(3);
  for (Eigen::Index i = 0; i < annulus.points.cols(); ++i)
  {
    const double angle =
      2.0 * Pi * (static_cast<double>(i / (rings + 1)) + random.uniform(0.0, 0.5)) / around;
    const double radius = 1.0 + 2.0 * static_cast<double>(i % (rings + 1)) / rings;
    annulus.points.col(i) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
  }
  return annulus;
}

// On a flat annulus with the distance from its center, circles are as far from each other as their
// radii differ, whatever the triangles.
TEST(LevelSetDistances, isTheDifferenceOfRadii)
{
  const Values isoValues = Values::LinSpaced(9, 1.1, 2.9);
  const double step = isoValues[1] - isoValues[0];
  double bound = 0.04;
  for (const int rings : { 24, 48, 96 })
  {
    const TriangleMesh annulus = annulusMesh(rings);
    const Values radii = annulus.points.colwise().norm();
    EXPECT_LT(
      errorOf(geodesicDistortion(annulus.points, topologyOf(annulus), radii, isoValues, None),
        [step](double) { return step; }),
      bound);
    bound /= 2.0;
  }
}

// Thin triangles are no obstacle: a sphere drawn out to a needle, whose level sets are ellipses,
// closest at the flanks and farthest on the axis.
TEST(LevelSetDistances, standsThinTriangles)
{
  TriangleMesh mesh = subdividedSphere(4);
  const Values height = mesh.points.row(2).transpose();
  mesh.points.row(0) *= 1000.0;
  const Values isoValues = Values::LinSpaced(7, -0.6, 0.6);
  const MeshTopology topology = topologyOf(mesh);
  const Values distances =
    geodesicDistortion(mesh.points, topology, height, isoValues, None).distances;
  const Values straight =
    hausdorffDistortion(mesh.points, edgesOf(topology), height, isoValues, None).distances;
  for (Eigen::Index i = 0; i < distances.size(); ++i)
  {
    const auto halfAxis = [&](Eigen::Index level)
    { return 1000.0 * std::sqrt(1.0 - isoValues[level] * isoValues[level]); };
    EXPECT_GE(distances[i], 0.9 * std::abs(halfAxis(i + 1) - halfAxis(i)));
    EXPECT_LT(distances[i], straight[i] + 100.0);
  }
}

/// Half of a cylinder of radius 1 and height 1.
TriangleMesh halfCylinder(int around, int high)
{
  TriangleMesh mesh = gridMesh(Grid::Patch, around, high);
  for (int i = 0; i < mesh.points.cols(); ++i)
  {
    const double angle = Pi * (i / (high + 1)) / around;
    mesh.points.col(i) << std::cos(angle), std::sin(angle),
      static_cast<double>(i % (high + 1)) / high;
  }
  return mesh;
}

Values anglesOf(const TriangleMesh& mesh)
{
  return Values::NullaryExpr(mesh.points.cols(),
    [&](Eigen::Index i) { return std::atan2(mesh.points(1, i), mesh.points(0, i)); });
}

// With the angle on a cylinder, level sets are straight: along the surface the angle apart, which
// its triangles, wound up, reproduce but for the chords of their edges.
TEST(LevelSetDistances, isAnAngleOnTheCylinder)
{
  const TriangleMesh mesh = halfCylinder(120, 30);
  const Values isoValues = Values::LinSpaced(5, 0.2, 2.9);
  const double angle = isoValues[1] - isoValues[0];
  const LevelSetDistortion geodesic =
    geodesicDistortion(mesh.points, topologyOf(mesh), anglesOf(mesh), isoValues, None);
  EXPECT_LT(errorOf(geodesic, [angle](double) { return angle; }), 1e-3);
  const LevelSetDistortion straight =
    hausdorffDistortion(mesh.points, edgesOf(topologyOf(mesh)), anglesOf(mesh), isoValues, None);
  EXPECT_LT(errorOf(straight, [angle](double) { return 2.0 * std::sin(0.5 * angle); }), 2e-3);
}

// The paper's claim: the more level sets, the closer are the two distances, as far as there are
// vertices between level sets.
TEST(LevelSetDistances, bothDistancesGetCloser)
{
  const TriangleMesh mesh = halfCylinder(400, 127);
  const MeshTopology topology = topologyOf(mesh);
  const Values angles = anglesOf(mesh);
  double last = std::numeric_limits<double>::infinity();
  for (const int steps : { 2, 3, 4 })
  {
    const Values isoValues = dyadicIsoValues(angles, steps);
    const Values straight =
      hausdorffDistortion(mesh.points, edgesOf(topology), angles, isoValues, None).distances;
    const Values geodesic =
      geodesicDistortion(mesh.points, topology, angles, isoValues, None).distances;
    const double ratio = (geodesic.array() / straight.array() - 1.0).abs().maxCoeff();
    EXPECT_LT(ratio, 0.3 * last) << steps; // a quarter: arc and chord differ in third order
    last = ratio;
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
