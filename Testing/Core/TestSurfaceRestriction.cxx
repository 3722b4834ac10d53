// Functions of space restricted to charts of a mesh, and Newton's method there.

#include "MeshChart.h"
#include "ModelCases.h"
#include "SurfaceNewton.h"
#include "SurfaceRestriction.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace SurfaceScalars::Truth
{
namespace
{

/// Heights of all vertices within half the radius over a chart, less those of the vertices.
double largestMisfit(const MeshChart& chart, const Points& vertices)
{
  double largest = 0.0;
  for (const auto vertex : vertices.colwise())
  {
    const Vector2d st = chart.fit().flatten(vertex);
    const Vector3d lifted = chart.fit().lift(st);
    if ((vertex - chart.fit().center()).norm() < 0.5 * chart.radius())
    {
      largest = std::max(largest, (lifted - vertex).norm());
    }
  }
  return largest;
}

} // namespace

// (5): gradient and Hessian of g(s, t) = u(r(s, t)) are those of its differences.
TEST(SurfaceRestriction, isTheChainRule)
{
  const Field u = fewCenters(closedTorus(), 100, KernelType::Multiquadric, 0.4, 1);
  const auto approximation = u.approximation();
  const Mesh mesh = torusMesh(60, true);
  const MeshTopology topology = topologyOf(mesh);
  const Values values = mesh.vertices.row(0);
  MeshChart chart(mesh.vertices, topology, values);
  for (Index vertex = 0; vertex < 200; vertex += 17)
  {
    ASSERT_TRUE(chart.center(vertex));
    const LocalFit& surface = chart.fit();
    const auto jetAt = [&](const Vector2d& st)
    {
      return restrictedTo(surface, st,
        approximation->jet(surface.lift(st) - u.cloud().origin(), Derivatives::Hessian));
    };
    const Vector2d st = 0.3 * chart.radius() * Vector2d(0.6, -0.8);
    const LocalFit::Jet jet = jetAt(st);
    const double step = 1e-4 * chart.radius();
    for (int axis = 0; axis < 2; ++axis)
    {
      const Vector2d shift = step * Vector2d::Unit(axis);
      const LocalFit::Jet after = jetAt(st + shift);
      const LocalFit::Jet before = jetAt(st - shift);
      EXPECT_NEAR(jet.gradient[axis], (after.value - before.value) / (2.0 * step), 1e-5);
      const Vector2d column = (after.gradient - before.gradient) / (2.0 * step);
      EXPECT_LT((jet.hessian.col(axis) - column).norm(), 1e-5 * jet.hessian.norm());
    }
  }
}

// The height z on the unit sphere: H_u = 0, so that H_g is <grad u, n> times the second fundamental
// form, -I at the top, where grad u is parallel to n and z is critical; on the equator <grad u, n>
// = 0, which the paper asks for, and z is not critical.
TEST(SurfaceRestriction, isCurvedLikeTheSurface)
{
  const Mesh mesh = sphereMesh(5);
  const MeshTopology topology = topologyOf(mesh);
  FieldJet height;
  height.gradient = Vector3d::UnitZ();
  height.hessian.setZero();
  const Values values = mesh.vertices.row(0);
  MeshChart chart(mesh.vertices, topology, values);
  Eigen::Index top = 0;
  mesh.vertices.row(2).maxCoeff(&top);
  ASSERT_TRUE(chart.center(static_cast<Index>(top)));
  const LocalFit::Jet atTop = restrictedTo(chart.fit(), Vector2d::Zero(), height);
  EXPECT_LT(atTop.gradient.norm(), 1e-10);
  EXPECT_LT((atTop.hessian + Eigen::Matrix2d::Identity()).norm(), 1e-3);
  EXPECT_EQ(typeOf(atTop.hessian), CriticalType::Maximum);

  Eigen::Index side = 0;
  mesh.vertices.row(0).maxCoeff(&side);
  ASSERT_TRUE(chart.center(static_cast<Index>(side)));
  const Vector3d normal = chart.fit().normal(Vector2d::Zero());
  EXPECT_LT(std::abs(normal.dot(height.gradient)), 1e-10);
  const LocalFit::Jet atSide = restrictedTo(chart.fit(), Vector2d::Zero(), height);
  EXPECT_NEAR(atSide.gradient.norm(), 1.0, 1e-10);
}

// The signs of the eigenvalues are the type, in whatever axes; a zero among them tells none.
TEST(SurfaceRestriction, tellsTypesBySigns)
{
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  const auto typeWith = [&](double low, double high)
  { return typeOf(turn * Vector2d(low, high).asDiagonal() * turn.transpose()); };
  EXPECT_EQ(typeWith(1e-3, 5.0), CriticalType::Minimum);
  EXPECT_EQ(typeWith(-1e-3, 5.0), CriticalType::Saddle);
  EXPECT_EQ(typeWith(-5.0, -1e-3), CriticalType::Maximum);
  EXPECT_EQ(typeWith(0.0, 5.0), CriticalType::Uncertain);
  EXPECT_EQ(typeWith(0.0, 0.0), CriticalType::Uncertain);
}

// A planar mesh is its own chart, turned and moved as it may be.
TEST(MeshChart, ofAPlaneIsThePlane)
{
  Mesh mesh = squareMesh(12, 0.3);
  const Eigen::AngleAxisd turn(0.8, Vector3d(1, 2, 3).normalized());
  mesh.vertices = (turn.toRotationMatrix() * mesh.vertices).colwise() + Vector3d(5, -3, 2);
  const MeshTopology topology = topologyOf(mesh);
  const Values values = mesh.vertices.row(0);
  MeshChart chart(mesh.vertices, topology, values);
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    ASSERT_TRUE(chart.center(vertex));
    EXPECT_LT(largestMisfit(chart, mesh.vertices), 1e-13);
    EXPECT_LT(chart.fit().height(Vector2d(0.1, 0.1)).hessian.norm(), 1e-10);
  }
}

// The distance of charts from the surface falls with at least the fourth power of the edge length.
TEST(MeshChart, convergesToTheSurface)
{
  std::vector<double> errors;
  for (const int around : { 80, 160 })
  {
    const Mesh mesh = torusMesh(around, true);
    const MeshTopology topology = topologyOf(mesh);
    const Values values = mesh.vertices.row(0);
    MeshChart chart(mesh.vertices, topology, values);
    double largest = 0.0;
    for (Index vertex = 0; vertex < topology.vertexCount(); vertex += 7)
    {
      ASSERT_TRUE(chart.center(vertex));
      for (const Vector2d& st : { Vector2d(0.2, 0.1), Vector2d(-0.1, 0.2), Vector2d(0.0, 0.0) })
      {
        largest = std::max(largest, std::abs(torusDistance(chart.fit().lift(st * chart.radius()))));
      }
    }
    errors.push_back(largest);
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 4.0);
}

// The two sides of a plate thinner than its edges are two surfaces: neighbors are those along
// edges.
TEST(MeshChart, doesNotMixTheSidesOfAPlate)
{
  Mesh mesh = torusMesh(120, false);
  mesh.vertices.row(2) *= 0.02;
  const MeshTopology topology = topologyOf(mesh);
  const Values values = mesh.vertices.row(0);
  MeshChart chart(mesh.vertices, topology, values);
  Eigen::Index top = 0;
  mesh.vertices.row(2).maxCoeff(&top);
  ASSERT_TRUE(chart.center(static_cast<Index>(top)));
  EXPECT_NEAR(chart.fit().lift(Vector2d::Zero()).z(), mesh.vertices(2, top), 1e-4);
  EXPECT_GT(std::abs(chart.fit().normal(Vector2d::Zero()).z()), 0.999);
}

// Inside a boundary vertex' triangles a place is on the mesh, beyond its edges it is not.
TEST(MeshChart, endsAtTheBoundary)
{
  const int size = 10;
  const Mesh mesh = squareMesh(size, 0.0);
  const MeshTopology topology = topologyOf(mesh);
  const Values values = mesh.vertices.row(0);
  MeshChart chart(mesh.vertices, topology, values);
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    ASSERT_TRUE(chart.center(vertex));
    for (int direction = 0; direction < 16; ++direction)
    {
      const double angle = (direction + 0.5) * Pi / 8.0;
      const Vector3d place =
        mesh.vertices.col(vertex) + 0.3 / size * Vector3d(std::cos(angle), std::sin(angle), 0.0);
      const bool isInside = place.head<2>().minCoeff() >= 0.0 && place.head<2>().maxCoeff() <= 1.0;
      EXPECT_EQ(chart.covers(place), isInside);
      EXPECT_EQ(chart.nearestVertex(place), vertex);
    }
  }
}

// Newton's method roughly squares the residual with each step near a critical point.
TEST(SurfaceNewton, convergesQuadratically)
{
  const Mesh mesh = torusMesh(80, false);
  const MeshTopology topology = topologyOf(mesh);
  const Field u = fewCenters(closedTorus(), 60, KernelType::Gaussian, 0.7, 3);
  const Values values = u.evaluate(mesh.vertices, {}).values;
  const double scale = gradientScale(mesh.vertices, mesh.triangles, values);
  SurfaceNewton newton(mesh.vertices, topology, values, u, 1e-10 * scale);
  int count = 0;
  for (const CriticalPoint& point : meshCriticalPoints(mesh.vertices, topology, values).points)
  {
    ASSERT_TRUE(newton.enter(static_cast<Index>(point.input)));
    const SurfaceSearch search = newton.search(point.position, point.type, { 10, true });
    ASSERT_TRUE(search.isCritical && search.isOnMesh);
    const std::size_t last = search.residuals.size() - 1;
    if (last >= 2)
    {
      const double before = search.residuals[last - 1] / scale;
      EXPECT_LT(search.residuals[last] / scale, 50.0 * before * before + 1e-13);
      ++count;
    }
    EXPECT_GE(search.evaluations, static_cast<int>(last) + 1);
  }
  EXPECT_GT(count, 4);
}

// The scale is the slope of a linear function in the plane, and zero of a constant.
TEST(SurfaceNewton, isJudgedByTheSlopeOfTheFunction)
{
  const Mesh mesh = squareMesh(9, 0.3);
  const Values slope = mesh.vertices.transpose() * Vector3d(3.0, 4.0, 0.0);
  EXPECT_NEAR(gradientScale(mesh.vertices, mesh.triangles, slope), 5.0, 1e-12);
  EXPECT_EQ(gradientScale(mesh.vertices, mesh.triangles, Values::Constant(slope.size(), 7.0)), 0.0);
}

} // namespace SurfaceScalars::Truth
