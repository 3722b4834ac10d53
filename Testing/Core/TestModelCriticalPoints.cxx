// Critical points of functions of space on meshes, off the vertices.

#include "CriticalScore.h"
#include "Error.h"
#include "ModelCases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// Through values of a function at random places of that square.
Field planarField(const std::function<double(const Vector3d&)>& function, int count)
{
  Points centers = randomPlane(count, 5);
  centers *= 2.0;
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  return Field::fit(centers, valuesOf(function, centers), parameters);
}

double bump(const Vector3d& p)
{
  return p.x() * std::exp(-p.squaredNorm());
}

void expectSharp(const ModelRun& run, const std::string& name)
{
  EXPECT_LE(run.largestResidual(), 1e-10) << name;
  EXPECT_LE(run.mostSteps(), 10) << name;
}

} // namespace

// On the sphere, the tori of genus 1 to 3: every critical point that Lagrange's equations have on
// the exact surface is found, none twice, with its type, to a tangential gradient of 1e-10 in at
// most 10 steps; the indices sum to Euler's characteristic.
TEST(ModelCriticalPoints, findsAllOnSmoothSurfaces)
{
  const std::vector<std::pair<ClosedSurface, Mesh>> cases{ { unitSphere(), sphereMesh(4) },
    { closedTorus(), torusMesh(80, true) },
    { doubleTorus(), asMesh(implicitMesh(doubleTorus().implicit, 1.3, 40)) },
    { tripleTorus(), asMesh(implicitMesh(tripleTorus().implicit, 1.8, 60)) } };
  for (const auto& [surface, mesh] : cases)
  {
    const Field u = fewCenters(surface, 60, KernelType::Cubic, 0.0, 3);
    const std::vector<CriticalPoint> exact = criticalPoints(surface, asFunction(u));
    const ModelRun run(mesh.vertices, topologyOf(mesh), u);
    const CriticalScore score = scoreCriticalPoints(run.refined(), exact, unambiguousRadius(exact));
    EXPECT_EQ(score.rightCount, score.exactCount) << surface.name;
    EXPECT_EQ(score.foundCount, score.exactCount) << surface.name;
    EXPECT_EQ(run.refined().size(), run.result.points.size()) << surface.name;
    EXPECT_EQ(run.candidates.points.size(),
      run.result.points.size() + run.result.merged + run.result.vanished)
      << surface.name;
    EXPECT_EQ(run.sum, surface.eulerCharacteristic) << surface.name;
    expectSharp(run, surface.name);
  }
}

// Places converge to those of the exact surface with at least the third power of the edge length:
// the slope of the surface model does.
TEST(ModelCriticalPoints, convergeWithTheMesh)
{
  const Field u = fewCenters(closedTorus(), 60, KernelType::Gaussian, 0.7, 3);
  const std::vector<CriticalPoint> exact = criticalPoints(closedTorus(), asFunction(u));
  std::vector<double> errors;
  for (const int around : { 60, 120, 240 })
  {
    const Mesh mesh = torusMesh(around, false);
    const ModelRun run(mesh.vertices, topologyOf(mesh), u);
    const CriticalScore score = scoreCriticalPoints(run.refined(), exact, unambiguousRadius(exact));
    ASSERT_EQ(score.rightCount, score.exactCount) << around;
    errors.push_back(score.rootMeanSquareError());
  }
  EXPECT_GT(std::log2(errors[0] / errors[2]) / 2.0, 3.0);
}

// A planar mesh is its own smooth surface: refined points are the zeros of the gradient in the
// plane, to rounding, however coarse the mesh. Critical vertices of the boundary remain, and count
// half.
TEST(ModelCriticalPoints, areExactInThePlane)
{
  const Field u = planarField(bump, 150);
  const std::vector<CriticalPoint> exact = planarCriticalPoints(asFunction(u));
  for (const int size : { 25, 60 })
  {
    const Mesh mesh = planarSquare(size);
    const MeshTopology topology = topologyOf(mesh);
    const ModelRun run(mesh.vertices, topology, u);
    // Farther from the boundary than two edges.
    const auto isInside = [&](const Vector3d& p)
    { return p.cwiseAbs().maxCoeff() < 2.0 - 8.0 / size; };
    const CriticalScore score = scoreCriticalPoints(run.refined(), exact, 1e-7, isInside);
    EXPECT_EQ(score.rightCount, score.exactCount) << size;
    EXPECT_EQ(score.foundCount, score.exactCount) << size;
    EXPECT_GE(score.exactCount, 2) << size;
    EXPECT_LT(score.errorMaximum, 1e-8) << size;
    EXPECT_EQ(run.sum, 1.0) << size;
    expectSharp(run, std::to_string(size));
    for (const ModelCriticalPoint& point : run.result.points)
    {
      const auto origin = static_cast<Index>(point.origin);
      EXPECT_TRUE(
        point.isRefined() || topology.isBoundary(origin) || !isInside(point.point.position));
      EXPECT_FALSE(point.isRefined() && topology.isBoundary(origin));
    }
  }
}

// Triangles along a valley make minima and saddles that the function does not have: these vanish in
// pairs, and the sum of the indices stays.
TEST(ModelCriticalPoints, leaveOutWhatTrianglesMade)
{
  const Mesh mesh = torusMesh(160, true);
  const MeshTopology topology = topologyOf(mesh);
  std::size_t pairs = 0;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const Field u = fewCenters(closedTorus(), 100, KernelType::Cubic, 0.0, seed);
    const std::vector<CriticalPoint> exact = criticalPoints(closedTorus(), asFunction(u));
    const ModelRun run(mesh.vertices, topology, u);
    const CriticalScore score = scoreCriticalPoints(run.refined(), exact, unambiguousRadius(exact));
    EXPECT_EQ(score.foundCount, score.exactCount) << seed;
    EXPECT_EQ(score.rightCount, score.exactCount) << seed;
    EXPECT_EQ(run.sum, 0.0) << seed;
    pairs += run.result.merged + run.result.vanished;
  }
  EXPECT_GT(pairs, 3U);
}

// Re (x + i y)^3 has a saddle of multiplicity 2, which a sum of radial functions close to it has as
// two of multiplicity 1: whatever of it is found, it counts -2.
TEST(ModelCriticalPoints, countSaddlesOfHigherMultiplicity)
{
  const Field u = planarField(planarSaddle(2).value, 200);
  for (const int size : { 20, 40, 80 })
  {
    const Mesh mesh = planarSquare(size);
    const ModelRun run(mesh.vertices, topologyOf(mesh), u);
    int sum = 0;
    for (const ModelCriticalPoint& point : run.result.points)
    {
      sum += point.point.position.norm() < 1.0 ? indexOf(point.point) : 0;
    }
    EXPECT_EQ(sum, -2) << size;
    EXPECT_EQ(run.sum, 1.0) << size;
  }
}

// Components do not see each other: two spheres have the points of each.
TEST(ModelCriticalPoints, haveComponentsOfTheirOwn)
{
  TriangleMesh far = subdividedSphere(4);
  far.points.row(0).array() += 2.001; // the spheres nearly touch
  const Mesh mesh = asMesh(besideEachOther(subdividedSphere(4), far));
  const Field u = fewCenters(unitSphere(), 60, KernelType::Cubic, 0.0, 3);
  const ModelRun run(mesh.vertices, topologyOf(mesh), u);
  const Mesh sphere = sphereMesh(4);
  const ModelRun alone(sphere.vertices, topologyOf(sphere), u);
  EXPECT_EQ(run.sum, 4.0);
  for (const ModelCriticalPoint& point : alone.result.points)
  {
    const auto isSame = [&](const ModelCriticalPoint& other)
    { return (other.point.position - point.point.position).norm() < 1e-9; };
    EXPECT_TRUE(std::any_of(run.result.points.begin(), run.result.points.end(), isSame));
  }
}

// Of a constant, a minimum and a maximum remain, as ties and rounding have them: nothing is
// refined.
TEST(ModelCriticalPoints, ofConstantsRemainVertices)
{
  const Field u = Field::fit(randomSphere(50, 1), Values::Constant(50, 3.0), {});
  const Mesh mesh = sphereMesh(3);
  const ModelRun run(mesh.vertices, topologyOf(mesh), u);
  EXPECT_EQ(run.result.gradientScale, 0.0);
  EXPECT_TRUE(run.refined().empty());
  EXPECT_EQ(run.result.points.size(), 2U);
  EXPECT_EQ(run.sum, 2.0);
}

// Every kernel and scheme gives indices that sum to Euler's characteristic. Where u has a tip at a
// center, its critical point remains a vertex; elsewhere it is refined.
TEST(ModelCriticalPoints, existForEveryField)
{
  const Mesh mesh = torusMesh(60, true);
  const MeshTopology topology = topologyOf(mesh);
  const Points centers = closedTorus().sample(400, 3);
  const Values values = valuesOf(saddleWithLogarithm(), centers);
  const std::set<KernelType> withTips{ KernelType::Exponential, KernelType::Linear };
  for (int kernel = 0; kernel <= static_cast<int>(KernelType::Wu); ++kernel)
  {
    FieldParameters parameters;
    parameters.scheme = Scheme::GlobalRBF;
    parameters.kernel = static_cast<KernelType>(kernel);
    parameters.kernelWidth = kernel == 0 ? 0.2 : 0.6;
    const ModelRun run(mesh.vertices, topology, Field::fit(centers, values, parameters));
    EXPECT_EQ(run.sum, 0.0) << nameOf(parameters.kernel);
    EXPECT_LE(run.largestResidual(), 1e-10) << nameOf(parameters.kernel);
    if (withTips.count(parameters.kernel) == 0)
    {
      EXPECT_GE(run.refined().size(), 8U) << nameOf(parameters.kernel);
    }
  }
  for (const Scheme scheme :
    { Scheme::ExplicitMLS, Scheme::ParameterizedMLS, Scheme::LocalRBF, Scheme::Hybrid })
  {
    FieldParameters parameters;
    parameters.scheme = scheme;
    const ModelRun run(mesh.vertices, topology, Field::fit(centers, values, parameters));
    EXPECT_EQ(run.sum, 0.0) << static_cast<int>(scheme);
    EXPECT_LE(run.largestResidual(), 1e-10) << static_cast<int>(scheme);
  }
}

// Noise on the vertices moves the surface, not the promises.
TEST(ModelCriticalPoints, bearNoiseOfTheSurface)
{
  Mesh mesh = sphereMesh(4);
  addNoise(mesh.vertices, 0.1 * meanEdge(mesh.vertices, mesh.triangles), 1);
  const Field u = fewCenters(unitSphere(), 60, KernelType::Cubic, 0.0, 3);
  const ModelRun run(mesh.vertices, topologyOf(mesh), u);
  EXPECT_EQ(run.sum, 2.0);
  EXPECT_GE(run.refined().size(), 4U);
  EXPECT_LE(run.largestResidual(), 1e-10);
}

// On a cube the smooth surface rounds edges and corners: still no candidate takes more than 10
// steps, found or not, most are found, and what is not has a reason.
TEST(ModelCriticalPoints, bearCreases)
{
  Mesh cube = sphereMesh(4);
  for (auto vertex : cube.vertices.colwise())
  {
    vertex /= vertex.cwiseAbs().maxCoeff();
  }
  std::size_t candidates = 0;
  std::size_t left = 0;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const Field u = fewCenters(unitSphere(), 60, KernelType::Cubic, 0.0, seed);
    const ModelRun run(cube.vertices, topologyOf(cube), u);
    EXPECT_EQ(run.sum, 2.0) << seed;
    expectSharp(run, std::to_string(seed));
    EXPECT_EQ(run.countOf(RefinementEnd::OnBoundary), 0U) << seed;
    EXPECT_EQ(run.countOf(RefinementEnd::NoDerivative), 0U) << seed;
    candidates += run.candidates.points.size();
    left += run.result.points.size() - run.refined().size();
  }
  EXPECT_GT(candidates, 30U);
  EXPECT_LE(left, candidates / 10);
}

// Meshes that sample no surface at all, collapsed onto a line or a few places or thrown about, give
// finite places whose indices sum to Euler's characteristic.
TEST(ModelCriticalPoints, bearMeshesWithoutASurface)
{
  const Field u = fewCenters(unitSphere(), 60, KernelType::Cubic, 0.0, 3);
  const Mesh sphere = sphereMesh(3);
  const MeshTopology topology = topologyOf(sphere);
  Points onALine = sphere.vertices;
  onALine.bottomRows<2>().setZero();
  const Points atFewPlaces = sphere.vertices.array().round();
  Points thrown = sphere.vertices;
  addNoise(thrown, 1.0, 1);
  for (const Points& vertices : { onALine, atFewPlaces, thrown })
  {
    const ModelRun run(vertices, topology, u);
    EXPECT_EQ(run.sum, 2.0);
    EXPECT_LE(run.largestResidual(), 1e-10);
    for (const ModelCriticalPoint& point : run.result.points)
    {
      EXPECT_TRUE(point.point.position.allFinite());
      EXPECT_TRUE(std::isfinite(point.point.residual));
    }
  }
}

// The number of threads changes nothing; an abort is heard.
TEST(ModelCriticalPoints, doNotDependOnThreads)
{
  const Mesh mesh = torusMesh(80, true);
  const MeshTopology topology = topologyOf(mesh);
  const Field u = fewCenters(closedTorus(), 150, KernelType::Cubic, 0.0, 1);
  const Values values = u.evaluate(mesh.vertices, {}).values;
  const MeshCriticalPoints candidates = meshCriticalPoints(mesh.vertices, topology, values);
  std::vector<Points> places;
  for (const int threads : { 1, 2, 5 })
  {
    const ModelCriticalPoints result =
      refineOnModel(mesh.vertices, topology, values, u, candidates, { threads, {} });
    places.emplace_back(3, static_cast<Eigen::Index>(result.points.size()));
    for (std::size_t i = 0; i < result.points.size(); ++i)
    {
      places.back().col(static_cast<Eigen::Index>(i)) = result.points[i].point.position;
    }
    EXPECT_EQ(places.back(), places.front()) << threads;
  }
  const Execution aborted{ 0, [](double) { return false; } };
  EXPECT_THROW(refineOnModel(mesh.vertices, topology, values, u, candidates, aborted), Aborted);
}

// Other numbers of places or values than vertices are refused.
TEST(ModelCriticalPoints, needOneValuePerVertex)
{
  const Mesh mesh = sphereMesh(2);
  const MeshTopology topology = topologyOf(mesh);
  const Field u = fewCenters(unitSphere(), 60, KernelType::Cubic, 0.0, 3);
  EXPECT_THROW(refineOnModel(mesh.vertices, topology, Values::Zero(3), u, {}), InvalidInput);
  EXPECT_THROW(
    refineOnModel(mesh.vertices.leftCols(3), topology, Values::Zero(mesh.vertices.cols()), u, {}),
    InvalidInput);
}

} // namespace SurfaceScalars::Truth
