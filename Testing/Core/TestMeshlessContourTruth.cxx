#include "FieldTruth.h"
#include "ModelExamples.h"
#include "Polyline.h"
#include "UniformContour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

struct Model
{
  Mesh mesh;
  std::unique_ptr<Field> field;
  double level;
};

/// Random values at random centers, more and more of them, on meshes of a few triangles; the level
/// is anywhere or close to an extremum.
Model randomModel(unsigned seed, KernelType kernel)
{
  Random random(31 * seed + static_cast<unsigned>(kernel));
  Model model{ seed % 3 == 0 ? centeredSquare(2, 1.0, 0.3) : sphereMesh(seed % 3 == 1 ? 0 : 1), {},
    0.0 };
  const int count = 10 + static_cast<int>(seed * 7 % 70);
  const Points centers = randomPlaces(count, seed % 3 == 0 ? 0.7 : 1.1, seed);
  Values values(count);
  for (double& value : values)
  {
    value = random.uniform(-1.0, 1.0);
  }
  FieldParameters parameters = parametersOf(Scheme::GlobalRBF, kernel);
  parameters.kernelWidth = RadialKernel(kernel, 1.0).dependsOnWidth()
    ? std::isfinite(RadialKernel(kernel, 1.0).support()) ? 1.0 : 0.35
    : 0.0;
  model.field = std::make_unique<Field>(Field::fit(centers, values, parameters));
  const Values atVertices = model.field->evaluate(model.mesh.vertices, {}).values;
  model.level = seed % 2 == 0 ? 0.3 * random.uniform(-1.0, 1.0)
                              : atVertices.minCoeff() + 0.02 * random.uniform();
  return model;
}

double distanceToCurves(const Vector3d& place, const std::vector<LevelSetCurve>& curves)
{
  double least = std::numeric_limits<double>::infinity();
  for (const LevelSetCurve& curve : curves)
  {
    const std::size_t count = curve.points.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
    {
      least = std::min(least,
        distanceToSegment(place, curve.points[i].position, curve.points[(i + 1) % count].position));
    }
  }
  return least;
}

class MeshlessContourTruth : public testing::TestWithParam<KernelType>
{
};
INSTANTIATE_TEST_SUITE_P(All, MeshlessContourTruth, testing::ValuesIn(interpolatingKernels()),
  [](const auto& kernel) { return nameOf(kernel.param); });

// Every component wider than the finest subdivision is found: all that marching through every
// triangle of that subdivision finds, of 14 models of each of 9 kernels, many finer than the mesh.
// And what is found is on the level set.
TEST_P(MeshlessContourTruth, findsAllThatIsWiderThanTheFinestSubdivision)
{
  constexpr int Refinement = 4;
  int count = 0;
  for (unsigned seed = 1; seed <= 14; ++seed)
  {
    const Model model = randomModel(seed, GetParam());
    const MeshlessContours contours =
      contoursOf(*model.field, model.mesh, { model.level }, 0.0, Refinement);
    const Mesh finest = subdivided(model.mesh, Refinement);
    const double edge = longestEdge(finest);
    for (const UniformComponent& component :
      uniformContour(finest, model.field->evaluate(finest.vertices, {}).values, model.level))
    {
      if (component.extent().norm() > edge)
      {
        for (const auto& [from, to] : component.segments)
        {
          ASSERT_LE(distanceToCurves(from, contours.sets.curves), 0.5 * edge) << "seed " << seed;
          ++count;
        }
      }
    }
    for (const LevelSetCurve& curve : contours.sets.curves)
    {
      for (const LevelSetPoint& point : curve.points)
      {
        EXPECT_LE(point.residual, 1e-9);
      }
    }
  }
  EXPECT_GT(count, 500);
}

// Curves are within the tolerance of the model's level set on the mesh, and the level set of them:
// both Hausdorff distances, against marching through triangles whose edges are 128 times shorter.
TEST_P(MeshlessContourTruth, staysWithinTheToleranceOfTheLevelSet)
{
  constexpr int Refinement = 7;
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    const Model model = randomModel(3 * seed, GetParam());
    const MeshlessContours contours = contoursOf(*model.field, model.mesh, { model.level }, 2e-3);
    const Mesh finest = subdivided(model.mesh, Refinement);
    std::vector<std::pair<Vector3d, Vector3d>> exact;
    for (const UniformComponent& component :
      uniformContour(finest, model.field->evaluate(finest.vertices, {}).values, model.level))
    {
      if (component.extent().norm() > longestEdge(finest))
      {
        for (const auto& [from, to] : component.segments)
        {
          ASSERT_LE(distanceToCurves(from, contours.sets.curves), 1.05 * contours.tolerance)
            << "seed " << seed;
          exact.emplace_back(from, to);
        }
      }
    }
    for (const LevelSetCurve& curve : contours.sets.curves)
    {
      const double off = largestDistance(curve,
        [&](const Vector3d& place)
        {
          double least = std::numeric_limits<double>::infinity();
          for (const auto& [from, to] : exact)
          {
            least = std::min(least, distanceToSegment(place, from, to));
          }
          return least;
        });
      EXPECT_TRUE(off <= 1.05 * contours.tolerance || curve.length < longestEdge(finest))
        << "seed " << seed << ": " << off << " of " << contours.tolerance;
    }
  }
}

// On slivers, too, whose corners lie all but along a line: the level sets of a bump in the plane
// are circles, from which no segment's middle is farther than the tolerance.
TEST(MeshlessContour, staysWithinTheToleranceOnSlivers)
{
  constexpr double tolerance = 1e-4;
  int segments = 0;
  for (unsigned seed = 1; seed <= 1000; ++seed)
  {
    Random random(seed);
    Mesh sliver{ Points(3, 3), Triangles(3, 1) };
    const double height = 0.02 + 0.3 * random.uniform();
    sliver.vertices << 0.0, 1.0, random.uniform(), 0.0, 0.0, height, 0.0, 0.0, 0.0;
    sliver.triangles << 0, 1, 2;
    const double x = random.uniform(-0.5, 1.5);
    const Vector3d center(x, random.uniform(-0.5, 0.5), 0.0);
    const Vector3d inside(0.3 + 0.4 * random.uniform(), 0.3 * height, 0.0);
    const double radius = (inside - center).norm();
    const MeshlessContours contours =
      contoursOf(bump(center, 1.0), sliver, { std::exp(-radius * radius) }, tolerance, 12);
    for (const LevelSetCurve& curve : contours.sets.curves)
    {
      for (std::size_t i = 1; i < curve.points.size(); ++i)
      {
        const Vector3d middle = 0.5 * (curve.points[i - 1].position + curve.points[i].position);
        ASSERT_NEAR((middle - center).norm(), radius, 1.01 * tolerance) << "seed " << seed;
        ++segments;
      }
    }
  }
  EXPECT_GT(segments, 20000);
}

// Kernels narrower than blocks of triangles, on a plane and on a slope that a Taylor polynomial far
// from the centers takes for all there is: all components that marching through the triangles
// finds.
TEST(MeshlessContour, findsWhatNarrowKernelsMake)
{
  const Mesh mesh = centeredSquare(100, 1.9, 0.1);
  const Mesh finer = subdivided(mesh, 1);
  for (const KernelType kernel :
    { KernelType::Gaussian, KernelType::Exponential, KernelType::Wendland, KernelType::Wu })
  {
    for (const double slope : { 0.0, 0.3 })
    {
      FieldModel model = termsInThePlane(30, 0.05, Values::LinSpaced(30, -1.0, 1.0), kernel);
      model.tail << 0.0, slope, 0.5 * slope, 0.0;
      const Field field(model);
      EXPECT_EQ(contoursOf(field, mesh, { 0.05 }).sets.curves.size(),
        uniformContour(finer, field.evaluate(finer.vertices, {}).values, 0.05).size())
        << nameOf(kernel) << ", slope " << slope;
    }
  }
}

} // namespace
} // namespace SurfaceScalars
