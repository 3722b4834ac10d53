#include "Error.h"
#include "MeshExamples.h"
#include "MeshlessApproximation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

MeshlessApproximation approximated(const TriangleMesh& mesh, const Values& values,
  const ApproximationParameters& parameters = {}, const Execution& execution = {})
{
  const MeshTopology topology = topologyOf(mesh);
  return approximateMeshless(surfaceDomain(mesh.points, topology), values, parameters, execution);
}

std::string refusal(
  const TriangleMesh& mesh, const Values& values, const ApproximationParameters& parameters = {})
{
  try
  {
    approximated(mesh, values, parameters);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "taken";
}

Values hills(const Points& points)
{
  return (3.0 * points.row(0)).array().sin() + (2.0 * points.row(1)).array().cos() +
    0.3 * points.row(2).array();
}

// Parameters out of range are refused with what they were.
TEST(MeshlessApproximationInput, refusesParameters)
{
  const TriangleMesh mesh = octahedralSphere(6);
  const Values values = hills(mesh.points);
  ApproximationParameters parameters;
  for (const double fraction : { 0.0, -1.0, 1.5, std::nan("") })
  {
    parameters.sampleFraction = fraction;
    EXPECT_THAT(refusal(mesh, values, parameters), HasSubstr("SampleFraction above 0, at most 1"));
  }
  parameters = {};
  parameters.persistenceThreshold = 1.5;
  EXPECT_THAT(
    refusal(mesh, values, parameters), AllOf(HasSubstr("PersistenceThreshold"), HasSubstr("1.5")));
  parameters = {};
  parameters.kernel = KernelType::Harmonic;
  EXPECT_THAT(refusal(mesh, values, parameters), HasSubstr("Harmonic"));
  parameters = {};
  parameters.kernelWidth = -1.0;
  EXPECT_THAT(refusal(mesh, values, parameters), HasSubstr("KernelWidth"));
  parameters = {};
  parameters.regularization = -1.0;
  EXPECT_THAT(refusal(mesh, values, parameters), HasSubstr("Regularization"));
  parameters = {};
  parameters.centerSelection = CenterSelection::LevelSets;
  parameters.coverageTolerance = 0.0;
  EXPECT_THAT(refusal(mesh, values, parameters), HasSubstr("CoverageTolerance"));
}

// So are values that are not finite, and another number of them.
TEST(MeshlessApproximationInput, refusesValues)
{
  TriangleMesh mesh = octahedralSphere(4);
  Values values = hills(mesh.points);
  EXPECT_THAT(refusal(mesh, values.head(7)), HasSubstr("7 values for 66 points"));
  values[5] = std::nan("");
  EXPECT_THAT(refusal(mesh, values), HasSubstr("NaN"));
  values = hills(mesh.points);
  mesh.points(1, 3) = INFINITY;
  EXPECT_THAT(refusal(mesh, values), HasSubstr("NaN or infinity"));
  mesh = octahedralSphere(4);
  for (const double scale : { 2e300, 1e307 })
  {
    EXPECT_THAT(refusal(mesh, scale / values.lpNorm<Eigen::Infinity>() * values),
      AllOf(HasSubstr("values of 1e+300 at most"), HasSubstr("power of ten")));
  }
}

// A constant has no range, is reproduced to the bit, and has no critical points that take centers,
// however many vertices ties by index make critical.
TEST(MeshlessApproximationInput, takesConstants)
{
  for (const TriangleMesh& mesh : { octahedralSphere(8), gridMesh(Grid::Torus, 12, 9) })
  {
    for (const CenterSelection selection : { CenterSelection::Greedy, CenterSelection::LevelSets })
    {
      ApproximationParameters parameters;
      parameters.centerSelection = selection;
      parameters.sampleFraction = 0.1;
      const Values values = Values::Constant(mesh.points.cols(), 1.0 / 3.0);
      const MeshlessApproximation result = approximated(mesh, values, parameters);
      EXPECT_EQ(result.values, values);
      EXPECT_EQ(result.largestError, 0.0);
      EXPECT_TRUE(result.persistent.empty());
      EXPECT_TRUE(result.critical.points.empty());
      EXPECT_EQ(result.starCount, 0);
      EXPECT_THAT(remarksOn(result), ElementsAre(HasSubstr("is 0.33333")));
    }
  }
}

// So is what arithmetic makes of a constant.
TEST(MeshlessApproximationInput, takesConstantsButForRounding)
{
  const TriangleMesh mesh = octahedralSphere(20);
  Values values = Values::Constant(mesh.points.cols(), 0.3);
  for (Eigen::Index i = 0; i < values.size(); i += 2)
  {
    values[i] = std::nextafter(0.3, 1.0);
  }
  const MeshlessApproximation result = approximated(mesh, values);
  EXPECT_TRUE(result.persistent.empty());
  EXPECT_LT(result.largestError, 1e-12);
}

// A plateau, which no level set meets, gets its share of centers.
TEST(MeshlessApproximationInput, takesPlateaus)
{
  const TriangleMesh mesh = gridMesh(Grid::Torus, 60, 40);
  const Values values = hills(mesh.points).cwiseMax(0.5);
  ApproximationParameters parameters;
  parameters.persistenceThreshold = 0.1;
  parameters.sampleFraction = 0.1;
  parameters.centerSelection = CenterSelection::LevelSets;
  const MeshlessApproximation result = approximated(mesh, values, parameters);
  EXPECT_EQ(result.model.centers.cols(), result.askedCount);
  EXPECT_LT(result.largestError, 0.2 * (values.maxCoeff() - 0.5));
}

// Meshes of four to a dozen vertices: all become centers.
TEST(MeshlessApproximationInput, takesSmallMeshes)
{
  const TriangleMesh tetrahedron{ (Points(3, 4) << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished(),
    { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } } };
  const TriangleMesh triangle{ (Points(3, 3) << 0, 1, 0, 0, 0, 1, 0, 0, 0).finished(),
    { { 0, 1, 2 } } };
  for (const TriangleMesh& mesh : { tetrahedron, triangle, octahedralSphere(1) })
  {
    for (const CenterSelection selection : { CenterSelection::Greedy, CenterSelection::LevelSets })
    {
      ApproximationParameters parameters;
      parameters.centerSelection = selection;
      const Values values = hills(mesh.points);
      const MeshlessApproximation result = approximated(mesh, values, parameters);
      EXPECT_LE(result.largestError, 1e-13);
      parameters.levelSetConstraints = LevelSetConstraints::LeastSquares;
      EXPECT_LE(approximated(mesh, values, parameters).largestError, 1e-13);
    }
  }
}

// Boundaries, several components and all kinds of meshes keep their critical points.
TEST(MeshlessApproximationInput, takesAllKindsOfMeshes)
{
  for (const NamedMesh& one : meshesOfAllKinds())
  {
    const TriangleMesh mesh = subdivided(one.mesh);
    ApproximationParameters parameters;
    parameters.sampleFraction = 0.1;
    parameters.persistenceThreshold = 0.05;
    const MeshlessApproximation result = approximated(mesh, hills(mesh.points), parameters);
    EXPECT_TRUE(result.lost.empty()) << one.name;
  }
  TriangleMesh far = octahedralSphere(6);
  far.points.row(0).array() += 3.0;
  const TriangleMesh both = besideEachOther(octahedralSphere(6), far);
  const MeshlessApproximation result = approximated(both, hills(both.points));
  EXPECT_TRUE(result.lost.empty());
  EXPECT_GE(result.persistent.size(), 4U);
}

// Two components at the same place: one center each place, so that where f is not the same on both
// u misses one by half of the difference at least. Critical points that are lost are told.
TEST(MeshlessApproximationInput, takesDuplicatePlaces)
{
  const TriangleMesh sphere = octahedralSphere(6);
  TriangleMesh twice = besideEachOther(sphere, sphere);
  twice.points.rightCols(sphere.points.cols()) = sphere.points;
  Values values(twice.points.cols());
  values << hills(sphere.points), hills(sphere.points);
  ApproximationParameters parameters;
  parameters.sampleFraction = 0.3;
  EXPECT_LT(approximated(twice, values, parameters).largestError, 0.1);
  values.tail(sphere.points.cols()) *= -1.0;
  const MeshlessApproximation result = approximated(twice, values, parameters);
  EXPECT_GE(result.largestError, 0.5);
  EXPECT_FALSE(result.lost.empty());
  EXPECT_THAT(remarksOn(result).back(), HasSubstr("critical points are lost"));
}

// A Gaussian as wide as the surface cannot be solved: refused with the condition and what to do;
// regularized, taken with a remark that states the condition.
TEST(MeshlessApproximationInput, refusesIllConditionedKernels)
{
  const TriangleMesh mesh = octahedralSphere(12);
  const Values values = hills(mesh.points);
  ApproximationParameters parameters;
  parameters.sampleFraction = 0.2;
  parameters.kernel = KernelType::Gaussian;
  parameters.kernelWidth = 2.0;
  EXPECT_THAT(refusal(mesh, values, parameters),
    AllOf(HasSubstr("condition"), HasSubstr("width 2"), HasSubstr("Lower KernelWidth")));
  parameters.regularization = 1e-8;
  const MeshlessApproximation result = approximated(mesh, values, parameters);
  EXPECT_LT(result.largestError, 0.01);
  EXPECT_THAT(remarksOn(result),
    testing::Contains(AllOf(HasSubstr("Regularization is 1e-08"), HasSubstr("condition"))));
}

// Spikes at the centers are remarked on, not taken for an approximation; a width that is chosen is
// none of them.
TEST(MeshlessApproximationInput, remarksOnNarrowKernels)
{
  const TriangleMesh mesh = octahedralSphere(12);
  ApproximationParameters parameters;
  parameters.sampleFraction = 0.5;
  parameters.kernel = KernelType::Gaussian;
  EXPECT_THAT(remarksOn(approximated(mesh, hills(mesh.points), parameters)), IsEmpty());
  parameters.kernelWidth = 0.01;
  EXPECT_THAT(remarksOn(approximated(mesh, hills(mesh.points), parameters)),
    testing::Contains(AllOf(HasSubstr("KernelWidth 0.01"), HasSubstr("too narrow"))));
}

// So wide a kernel that a regularization which lets it interpolate does not for least squares: the
// sentence says what does, and that is so.
TEST(MeshlessApproximationInput, refusesIllConditionedLeastSquares)
{
  const TriangleMesh mesh = octahedralSphere(12);
  const Values values =
    (5.0 * mesh.points.row(0)).array().sin() * (4.0 * mesh.points.row(1)).array().cos();
  ApproximationParameters parameters;
  parameters.sampleFraction = 0.1;
  parameters.levelSetConstraints = LevelSetConstraints::LeastSquares;
  parameters.kernel = KernelType::Gaussian;
  parameters.kernelWidth = 5.0;
  parameters.regularization = 1e-10;
  EXPECT_THAT(refusal(mesh, values, parameters),
    AllOf(HasSubstr("Gaussian kernel of width 5"), HasSubstr("1e-10"), HasSubstr("condition"),
      HasSubstr("Lower KernelWidth, raise Regularization a hundredfold")));
  parameters.regularization = 1e-8;
  EXPECT_EQ(refusal(mesh, values, parameters), "taken");
}

// Noise has more critical points than a dense system can interpolate: refused with their number and
// the property that leaves them out.
TEST(MeshlessApproximationInput, refusesTooManyStars)
{
  const TriangleMesh mesh = octahedralSphere(50);
  Values values = hills(mesh.points);
  addNoise(values, 1.0, 1);
  EXPECT_THAT(refusal(mesh, values),
    AllOf(HasSubstr("at most 6000 vertices"), HasSubstr("Raise PersistenceThreshold")));
}

// What was asked for and could not be given is told.
TEST(MeshlessApproximationInput, remarks)
{
  MeshlessApproximation result;
  result.model.centers.resize(3, 6000);
  result.starCount = 100;
  result.askedCount = 6000;
  EXPECT_THAT(remarksOn(result), IsEmpty());
  result.askedCount = 28000;
  EXPECT_THAT(remarksOn(result), ElementsAre(AllOf(HasSubstr("28000"), HasSubstr("6000"))));
  result.askedCount = 6000;
  result.starCount = 1501;
  EXPECT_THAT(remarksOn(result),
    ElementsAre(AllOf(HasSubstr("1501 of 6000 centers"), HasSubstr("PersistenceThreshold"))));
}

// Progress never falls and ends at 1, also where rounds find nothing to add; wherever an abort
// comes, it is heard.
TEST(MeshlessApproximationInput, reportsAndAborts)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = hills(mesh.points);
  for (const LevelSetConstraints constraints : { LevelSetConstraints::Interpolating,
         LevelSetConstraints::LeastSquares, LevelSetConstraints::Minimax })
  {
    ApproximationParameters parameters;
    parameters.sampleFraction = 0.2;
    parameters.centerSelection = constraints == LevelSetConstraints::LeastSquares
      ? CenterSelection::LevelSets
      : CenterSelection::Greedy;
    parameters.levelSetConstraints = constraints;
    for (const Values& f :
      { values, Values(mesh.points.row(0)), Values(Values::Constant(values.size(), 7.5)) })
    {
      std::vector<double> told;
      approximated(mesh, f, parameters,
        { 2,
          [&](double fraction)
          {
            told.push_back(fraction);
            return true;
          } });
      EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
      EXPECT_EQ(told.back(), 1.0);
    }
    for (const double limit : { 0.0, 0.3, 0.6, 0.9 })
    {
      const Execution execution{ 2, [=](double fraction) { return fraction < limit; } };
      EXPECT_THROW(approximated(mesh, values, parameters, execution), Aborted) << limit;
    }
  }
}

} // namespace
} // namespace SurfaceScalars
