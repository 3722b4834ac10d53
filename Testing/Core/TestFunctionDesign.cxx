#include "DesignRequests.h"
#include "MeshExamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

struct Way
{
  std::string name;
  DesignParameters parameters;
};

std::vector<Way> interpolatingWays()
{
  std::vector<Way> ways(6);
  ways[0].name = "Biharmonic";
  ways[1].name = "Harmonic";
  ways[1].parameters.energy = SmoothingEnergy::Harmonic;
  ways[2].name = "MassMatrix";
  ways[2].parameters.metric = DataMetric::MassMatrix;
  ways[3].name = "Cubic";
  ways[3].parameters.approach = DesignApproach::Meshless;
  ways[4].name = "Gaussian";
  ways[4].parameters.approach = DesignApproach::Meshless;
  ways[4].parameters.kernel = KernelType::Gaussian;
  ways[5].name = "OffsetCenters";
  ways[5].parameters.approach = DesignApproach::Meshless;
  ways[5].parameters.kernel = KernelType::Harmonic;
  return ways;
}

class FunctionDesignWays : public testing::TestWithParam<Way>
{
};
INSTANTIATE_TEST_SUITE_P(All, FunctionDesignWays, testing::ValuesIn(interpolatingWays()),
  [](const auto& way) { return way.param.name; });

// Sec. 3.1: whatever is asked for, on genus 0 to 3, is critical in the function, of its type and
// multiplicity, as a walk around each vertex finds; and what else is critical is listed.
TEST_P(FunctionDesignWays, keepWhatIsAskedFor)
{
  const std::array<TriangleMesh, 4> meshes{ subdividedSphere(4), gridMesh(Grid::Torus, 40, 24),
    plateWithHoles(2, 3), plateWithHoles(3, 3) };
  for (const TriangleMesh& coarse : meshes)
  {
    for (unsigned seed = 1; seed <= 10; ++seed)
    {
      const std::vector<CriticalRequest> requests = randomRequests(topologyOf(coarse), seed);
      const TriangleMesh mesh = refinedFor(coarse, requests);
      const DesignMesh design(mesh.points, trianglesOf(mesh));
      const DesignedFunction result = designFunction(design, requests, this->GetParam().parameters);
      ASSERT_EQ(metByWalking(mesh, result.values, requests), requests.size()) << seed;
      EXPECT_TRUE(result.missing.empty());
      EXPECT_EQ(std::count(result.prescribed.begin(), result.prescribed.end(), 1),
        static_cast<std::ptrdiff_t>(requests.size()));
      const CriticalCounts counts = countsOf(result.critical.points);
      EXPECT_EQ(
        int(counts.minima) - int(counts.saddles) + int(counts.maxima), mesh.eulerCharacteristic());
      for (const CriticalRequest& request : requests)
      {
        if (request.value)
        {
          EXPECT_EQ(result.values[request.vertex], *request.value);
        }
      }
    }
  }
}

/// The vertex at a place that is one.
Index vertexAt(const Points& vertices, const Vector3d& place)
{
  Eigen::Index result = 0;
  EXPECT_LT((vertices.colwise() - place).colwise().norm().minCoeff(&result), 1e-9);
  return static_cast<Index>(result);
}

// Symmetric requests on a symmetric mesh give a function that is symmetric to 1e-6 of its range.
TEST_P(FunctionDesignWays, keepSymmetry)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const DesignMesh design(mesh.points, trianglesOf(mesh));
  std::vector<CriticalRequest> requests;
  for (const double side : { -1.0, 1.0 })
  {
    requests.push_back({ vertexAt(mesh.points, { side, 0, 0 }), CriticalType::Maximum, 1, {}, {} });
    requests.push_back({ vertexAt(mesh.points, { 0, side, 0 }), CriticalType::Minimum, 1, {}, {} });
    requests.push_back({ vertexAt(mesh.points, { 0, 0, side }), CriticalType::Saddle, 1, {}, {} });
  }
  const DesignedFunction result = designFunction(design, requests, this->GetParam().parameters);
  EXPECT_TRUE(result.missing.empty());
  const double range = result.values.maxCoeff() - result.values.minCoeff();
  for (int axis = 0; axis < 3; ++axis)
  {
    Points mirrored = mesh.points;
    mirrored.row(axis) *= -1.0;
    double largest = 0.0;
    for (Eigen::Index i = 0; i < mirrored.cols(); i += 7)
    {
      largest = std::max(largest,
        std::abs(result.values[vertexAt(mesh.points, mirrored.col(i))] - result.values[i]));
    }
    EXPECT_LT(largest, 1e-6 * range) << axis;
  }
  // Nothing else is needed, 2 - 2 + 2 = 2, nor there, but for kernels that do not smooth.
  if (this->GetParam().parameters.kernel == KernelType::Cubic)
  {
    EXPECT_EQ(result.critical.points.size(), 6U);
  }
}

// Sec. 3.4: with the critical points and stars of a harmonic function the function of least
// harmonic energy is that function, and nothing is added.
TEST(FunctionDesign, importsTemplates)
{
  const Mesh mesh = torusMesh(60, true);
  const DesignMesh design(mesh.vertices, mesh.triangles);
  DesignParameters parameters;
  parameters.energy = SmoothingEnergy::Harmonic;
  std::vector<CriticalRequest> two(2);
  two[0] = { 10, CriticalType::Minimum, 1, -2.0, {} };
  two[1] = { 900, CriticalType::Maximum, 1, 3.0, {} };
  const Values harmonic = designFunction(design, two, parameters).values;
  const std::vector<CriticalRequest> imported =
    requestsOf(mesh.vertices, design.topology(), harmonic, 0.0);
  EXPECT_EQ(imported.size(), 4U);
  const DesignedFunction result = designFunction(design, imported, parameters);
  EXPECT_LT((result.values - harmonic).lpNorm<Eigen::Infinity>(), 1e-8);
  EXPECT_EQ(result.critical.points.size(), 4U);
  EXPECT_TRUE(result.missing.empty());

  // The same of its critical points alone, whose stars the first pass finds.
  std::vector<CriticalRequest> places = imported;
  for (CriticalRequest& request : places)
  {
    request.star.clear();
    request.value.reset();
  }
  const DesignedFunction found = designFunction(design, places, parameters);
  EXPECT_EQ(found.critical.points.size(), 4U);
  EXPECT_TRUE(found.missing.empty());
}

// Larger values of epsilon are closer to what is asked for; the largest keep all of it.
TEST(FunctionDesign, approachesWithEpsilon)
{
  const TriangleMesh coarse = subdividedSphere(4);
  const std::vector<CriticalRequest> requests = randomRequests(topologyOf(coarse), 4);
  const TriangleMesh mesh = refinedFor(coarse, requests);
  const DesignMesh design(mesh.points, trianglesOf(mesh));
  for (const auto approach : { DesignApproach::MeshBased, DesignApproach::Meshless })
  {
    DesignParameters parameters;
    parameters.approach = approach;
    const Values exact = designFunction(design, requests, parameters).values;
    parameters.constraints = DesignConstraints::LeastSquares;
    parameters.epsilonChoice = EpsilonChoice::Manual;
    double before = std::numeric_limits<double>::infinity();
    for (const double epsilon : { 1e3, 1e7, 1e11, 1e15 })
    {
      parameters.epsilon = epsilon;
      const DesignedFunction result = designFunction(design, requests, parameters);
      const double distance = (result.values - exact).norm();
      EXPECT_LT(distance, before);
      before = distance;
      EXPECT_EQ(result.epsilon, epsilon);
      EXPECT_EQ(result.curve.epsilons.size(), 0);
      if (epsilon == 1e15)
      {
        EXPECT_TRUE(result.missing.empty());
      }
    }
    parameters.epsilonChoice = EpsilonChoice::LCurve;
    const DesignedFunction chosen = designFunction(design, requests, parameters);
    EXPECT_GT(chosen.curve.epsilons.size(), 10);
    EXPECT_GT(chosen.epsilon, chosen.curve.epsilons.minCoeff());
    EXPECT_LE(chosen.epsilon, chosen.curve.epsilons.maxCoeff());
  }
}

// Neither the unit of length nor that of values matters.
TEST(FunctionDesign, hasNoUnit)
{
  const TriangleMesh coarse = plateWithHoles(1, 3);
  const std::vector<CriticalRequest> requests = randomRequests(topologyOf(coarse), 2);
  const TriangleMesh mesh = refinedFor(coarse, requests);
  for (const Way& way : interpolatingWays())
  {
    const Values values =
      designFunction(DesignMesh(mesh.points, trianglesOf(mesh)), requests, way.parameters).values;
    std::vector<CriticalRequest> scaled = requests;
    for (CriticalRequest& request : scaled)
    {
      request.value = 1000.0 * *request.value + 77.0;
    }
    const Values other =
      designFunction(DesignMesh(50.0 * mesh.points, trianglesOf(mesh)), scaled, way.parameters)
        .values;
    if (way.parameters.kernel != KernelType::Harmonic) // which has no constants
    {
      const Values expected = (1000.0 * values).array() + 77.0;
      EXPECT_LT(
        (expected - other).lpNorm<Eigen::Infinity>(), 1e-5 * (other.maxCoeff() - other.minCoeff()))
        << way.name;
    }
  }
}

} // namespace
} // namespace SurfaceScalars
