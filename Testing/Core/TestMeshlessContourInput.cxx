#include "Error.h"
#include "FieldTruth.h"
#include "ModelExamples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

std::string refusal(const Mesh& mesh, const MeshlessContourParameters& parameters)
{
  try
  {
    traceMeshlessContours(bump(Vector3d::Zero(), 1.0), mesh.vertices, mesh.triangles, parameters);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "accepted";
}

bool mentions(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// What cannot be worked with is refused in one sentence that says what was expected and found.
TEST(MeshlessContourInput, isRefusedWithASentence)
{
  const Mesh mesh = centeredSquare(4, 1.0, 0.2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(mentions(refusal(mesh, { { nan }, 0.0, 8 }), "iso-values"));
  EXPECT_TRUE(mentions(refusal(mesh, { { 0.5 }, -1.0, 8 }), "Tolerance of 0"));
  EXPECT_TRUE(mentions(refusal(mesh, { { 0.5 }, nan, 8 }), "Tolerance of 0"));
  EXPECT_TRUE(mentions(refusal(mesh, { { 0.5 }, 0.0, -1 }), "MaximumRefinement from 0 to 20"));
  EXPECT_TRUE(mentions(refusal(mesh, { { 0.5 }, 0.0, 21 }), "21"));
  Mesh broken = mesh;
  broken.vertices(0, 3) = nan;
  EXPECT_TRUE(mentions(refusal(broken, { { 0.5 }, 0.0, 8 }), "finite positions"));
  broken = mesh;
  broken.triangles(1, 5) = 1000;
  EXPECT_TRUE(mentions(refusal(broken, { { 0.5 }, 0.0, 8 }), "1000"));
  broken.triangles.resize(3, 0);
  EXPECT_TRUE(mentions(refusal(broken, { { 0.5 }, 0.0, 8 }), "triangles"));
  EXPECT_EQ(refusal(mesh, { {}, 0.0, 8 }), "accepted");
}

// Iso-values come out ascending, once each, those outside of u's range without curves.
TEST(MeshlessContourInput, mayListIsoValuesInAnyOrder)
{
  const LevelSets sets = contoursOf(
    bump(Vector3d::Zero(), 0.5), centeredSquare(5, 2.0, 0.2), { 0.7, 3.0, 0.3, 0.7, -1.0 })
                           .sets;
  EXPECT_EQ(sets.isoValues, (std::vector<double>{ -1.0, 0.3, 0.7, 3.0 }));
  EXPECT_EQ(sets.componentCounts, (std::vector<int>{ 0, 1, 1, 0 }));
}

// A constant is nowhere crossed, at its own value neither, and that is known at once; so is where a
// kernel has no support.
TEST(MeshlessContourInput, mayBeConstant)
{
  const Mesh mesh = centeredSquare(5, 2.0, 0.2);
  const MeshlessContours flat =
    contoursOf(linearField(Vector3d::Zero(), 3.0), mesh, { 3.0, 2.0 }, 0.0, 20);
  EXPECT_TRUE(flat.sets.curves.empty());
  EXPECT_LT(flat.evaluations, 2000u);
  const MeshlessContours far = contoursOf(bump(Vector3d(50, 0, 0), 0.5), mesh, { 0.0 }, 0.0, 20);
  EXPECT_TRUE(far.sets.curves.empty());
}

// Where refinement ends before the tolerance is reached, the largest deviation says so.
TEST(MeshlessContourInput, mayNotLetTheToleranceBeReached)
{
  const Field field = bump(Vector3d(0.01, 0.02, 0.0), 0.8);
  const Mesh mesh = centeredSquare(5, 2.0, 0.2);
  EXPECT_GT(contoursOf(field, mesh, { 0.5 }, 1e-6, 2).largestDeviation, 1e-6);
  EXPECT_LE(contoursOf(field, mesh, { 0.5 }, 1e-6, 14).largestDeviation, 1e-6);
  // An automatic one is a thousandth of the median edge.
  EXPECT_NEAR(contoursOf(field, mesh, { 0.5 }).tolerance / 0.4e-3, 1.0, 0.3);
}

// Triangles without area lie between others: curves pass them and close.
TEST(MeshlessContourInput, mayHaveTrianglesWithoutArea)
{
  Mesh mesh = centeredSquare(6, 2.0, 0.0);
  // A vertex on the diagonal of two triangles, which become three and one without area.
  const auto added = static_cast<Index>(mesh.vertices.cols());
  const Eigen::Index count = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, added + 1);
  mesh.triangles.conservativeResize(3, count + 2);
  const Eigen::Index cut = 2 * (6 * 3 + 2);
  const Index a = mesh.triangles(0, cut);
  const Index b = mesh.triangles(1, cut);
  const Index c = mesh.triangles(2, cut);
  mesh.vertices.col(added) = 0.7 * mesh.vertices.col(a) + 0.3 * mesh.vertices.col(c);
  mesh.triangles.col(cut) << a, b, added;
  mesh.triangles.col(count) << b, c, added;
  mesh.triangles.col(count + 1) << a, added, c;
  const Vector3d center = mesh.vertices.col(added) + Vector3d(0.2, 0.1, 0.0);
  const LevelSets sets =
    contoursOf(bump(center, 0.6), mesh, { std::exp(-0.25 * 0.25 / 0.36) }, 1e-4, 12).sets;
  ASSERT_EQ(sets.curves.size(), 1u);
  EXPECT_TRUE(sets.curves.front().closed);
  EXPECT_NEAR(sets.curves.front().length, 2.0 * Pi * 0.25, 1e-2);
}

// Three half planes that meet in a line: the curves of each end there.
TEST(MeshlessContourInput, mayHaveEdgesOfThreeTriangles)
{
  Mesh mesh{ Points(3, 5), Triangles(3, 3) };
  mesh.vertices << 0, 0, 1, -1, 0, 0, 1, 0.5, 0.5, 0.5, 0, 0, 0, 0, 1;
  mesh.triangles << 0, 0, 0, 1, 1, 1, 2, 3, 4;
  const LevelSets sets = contoursOf(linearField(Vector3d(0, 1, 0)), mesh, { 0.4 }).sets;
  ASSERT_EQ(sets.curves.size(), 3u);
  for (const LevelSetCurve& curve : sets.curves)
  {
    EXPECT_FALSE(curve.closed);
    EXPECT_NEAR(curve.length, 0.8, 1e-12);
  }
}

// Two meshes beside each other give the curves of each.
TEST(MeshlessContourInput, mayHaveSeveralComponents)
{
  const Mesh one = sphereMesh(2);
  Mesh two{ Points(3, 2 * one.vertices.cols()), Triangles(3, 2 * one.triangles.cols()) };
  two.vertices << one.vertices, one.vertices.colwise() + Vector3d(3, 0, 0);
  two.triangles << one.triangles,
    (one.triangles.array() + static_cast<Index>(one.vertices.cols())).matrix();
  const LevelSets sets = contoursOf(linearField(Vector3d(0, 0, 1)), two, { 0.3 }).sets;
  ASSERT_EQ(sets.curves.size(), 2u);
  EXPECT_NEAR(sets.curves[0].length, sets.curves[1].length, 1e-9);
}

// A model far from the mesh works; how much of the curves is far from every center is said.
TEST(MeshlessContourInput, mayBeOutsideOfTheModel)
{
  Points centers = 0.1 * squareGrid(3, 1.0);
  const Field field = gaussians(centers, Values::Constant(9, 0.2), 2.0);
  EXPECT_EQ(contoursOf(field, centeredSquare(5, 0.2, 0.0), { 1.75 }).farShare, 0.0);
  const MeshlessContours far = contoursOf(field, centeredSquare(8, 4.0, 0.0), { 0.9 });
  EXPECT_GT(far.farShare, 0.99);
  EXPECT_GT(far.farDistance, 0.1);
}

// Local schemes jump a little where their neighborhoods change: work stays bounded, curves close.
TEST(MeshlessContourInput, mayBeALocalScheme)
{
  const FieldInput input = torusInput(3000, 5);
  for (const Scheme scheme : { Scheme::LocalRBF, Scheme::ExplicitMLS, Scheme::ParameterizedMLS })
  {
    const Field field = Field::fit(input.points, input.values, parametersOf(scheme));
    const double level = 0.5 * (input.values.minCoeff() + input.values.maxCoeff());
    const MeshlessContours contours = contoursOf(field, torusMesh(40, true), { level });
    EXPECT_FALSE(contours.sets.curves.empty());
    EXPECT_LT(contours.evaluations, 200000u) << static_cast<int>(scheme);
    for (const LevelSetCurve& curve : contours.sets.curves)
    {
      EXPECT_TRUE(curve.closed);
    }
  }
}

// A jump across the level at an edge that neighbors cut again and again does not keep it from
// ending; progress never falls.
TEST(MeshlessContourInput, mayJumpAnywhere)
{
  for (const unsigned seed : { 1U, 2U, 3U, 4U, 5U, 6U })
  {
    FieldModel model;
    model.centers = randomPlaces(1500, 1.0, seed);
    model.centers.row(2).setZero();
    model.coefficients = (9.0 * model.centers.row(0).transpose()).array().sin() *
      (8.0 * model.centers.row(1).transpose()).array().cos();
    model.lowest = -1.0;
    model.highest = 1.0;
    for (const Scheme scheme : { Scheme::LocalRBF, Scheme::ExplicitMLS })
    {
      model.parameters.scheme = scheme;
      model.parameters.neighborCount = 24;
      model.parameters.kernelWidth = scheme == Scheme::ExplicitMLS ? 0.1 : 0.0;
      const Mesh mesh = centeredSquare(40, 1.9, 0.1);
      double last = 0.0;
      const auto rises = [&](double done) { return std::exchange(last, done) <= done; };
      const MeshlessContours contours = traceMeshlessContours(
        Field(model), mesh.vertices, mesh.triangles, { { 0.0, 0.3 }, 0.0, 8 }, { 0, rises });
      EXPECT_LT(contours.evaluations, 2000000U) << seed;
    }
  }
}

// Within a second of being asked to, it stops: here at once.
TEST(MeshlessContourInput, mayBeAborted)
{
  const Mesh mesh = centeredSquare(50, 2.0, 0.2);
  EXPECT_THROW(traceMeshlessContours(bump(Vector3d::Zero(), 0.5), mesh.vertices, mesh.triangles,
                 { { 0.5 }, 1e-9, 20 }, { 1, [](double done) { return done < 0.3; } }),
    Aborted);
}

} // namespace
} // namespace SurfaceScalars
