#include "Error.h"
#include "FunctionDesign.h"
#include "MeshExamples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;
using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const TriangleMesh& mesh, const std::vector<CriticalRequest>& requests,
  const DesignParameters& parameters = {})
{
  try
  {
    designFunction(DesignMesh(mesh.points, trianglesOf(mesh)), requests, parameters);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "taken";
}

CriticalRequest asked(Index vertex, CriticalType type, int multiplicity = 1)
{
  return { vertex, type, multiplicity, {}, {} };
}

CriticalRequest asked(Index vertex, CriticalType type, int multiplicity, double value)
{
  return { vertex, type, multiplicity, value, {} };
}

/// The least difference between a requested vertex and its neighbors.
double leastDifference(
  const MeshTopology& mesh, const Values& values, const std::vector<CriticalRequest>& requests)
{
  double least = INFINITY;
  for (const CriticalRequest& request : requests)
  {
    for (const Index neighbor : mesh.link(request.vertex))
    {
      least = std::min(least, std::abs(values[neighbor] - values[request.vertex]));
    }
  }
  return least;
}

constexpr auto Minimum = CriticalType::Minimum;
constexpr auto Saddle = CriticalType::Saddle;
constexpr auto Maximum = CriticalType::Maximum;

TEST(FunctionDesignInput, refusesImpossibleRequests)
{
  const TriangleMesh mesh = subdividedSphere(3);
  const MeshTopology topology = topologyOf(mesh);
  const Index next = *topology.link(20).begin();

  EXPECT_THAT(refusal(mesh, {}), HasSubstr("at least one critical point"));
  EXPECT_THAT(refusal(mesh, { asked(20, Maximum), asked(7, Minimum), asked(20, Maximum) }),
    AllOf(HasSubstr("critical point 0 and critical point 2"), HasSubstr("both at point 20")));
  EXPECT_THAT(refusal(mesh, { asked(100000, Maximum) }), HasSubstr("100000 of critical point 0"));
  EXPECT_THAT(refusal(mesh, { asked(20, CriticalType::Uncertain) }),
    AllOf(HasSubstr("critical point 0"), HasSubstr("uncertain point")));
  EXPECT_THAT(refusal(mesh, { asked(20, Saddle, 0) }), HasSubstr("0 of critical point 0"));
  EXPECT_THAT(refusal(mesh, { asked(20, Saddle, 3) }),
    AllOf(HasSubstr("at least 8 neighbors of critical point 0"), HasSubstr("multiplicity 3")));
  EXPECT_THAT(refusal(mesh, { asked(20, Maximum, 1, NAN) }), HasSubstr("nan of critical point 0"));
  CriticalRequest partial = asked(20, Maximum, 1, 1.0);
  partial.star = { 0.5, 0.2 };
  EXPECT_THAT(refusal(mesh, { partial }), HasSubstr("2 values of neighbors"));

  // Next to each other: two maxima, and a maximum below a minimum.
  EXPECT_THAT(refusal(mesh, { asked(20, Maximum), asked(next, Maximum) }),
    AllOf(HasSubstr("critical point 0"), HasSubstr("critical point 1"), HasSubstr("neighbors")));
  EXPECT_THAT(refusal(mesh, { asked(20, Maximum, 1, 1.0), asked(next, Minimum, 1, 2.0) }),
    AllOf(HasSubstr("critical point 0"), HasSubstr("critical point 1"), HasSubstr("of value 2")));
  EXPECT_EQ(refusal(mesh, { asked(20, Maximum, 1, 2.0), asked(next, Minimum, 1, 1.0) }), "taken");

  // More than dense systems have room for.
  const TriangleMesh fine = subdividedSphere(5);
  std::vector<CriticalRequest> many;
  for (Index vertex = 0; vertex < 500; ++vertex)
  {
    many.push_back(asked(vertex, Saddle));
  }
  EXPECT_THAT(refusal(fine, many), HasSubstr("at most 3000 vertices, found 500 with 3"));
}

// One point alone has nothing around it to take a shape from.
TEST(FunctionDesignInput, makesOnePointCritical)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const DesignMesh design(mesh.points, trianglesOf(mesh));
  for (const auto type : { Minimum, Saddle, Maximum })
  {
    const std::vector<CriticalRequest> requests{ asked(77, type) };
    const Values values = designFunction(design, requests, {}).values;
    EXPECT_GT(leastDifference(design.topology(), values, requests), 1e-9);
    EXPECT_GT(values.maxCoeff() - values.minCoeff(), 1e-5);
  }
}

TEST(FunctionDesignInput, namesComponentsWithoutRequests)
{
  const TriangleMesh mesh = besideEachOther(subdividedSphere(2), subdividedSphere(2));
  EXPECT_THAT(refusal(mesh, { asked(0, Minimum), asked(30, Maximum) }),
    AllOf(
      HasSubstr("each of the 2 connected components"), HasSubstr("none on the one of point 66")));
  EXPECT_EQ(refusal(mesh, { asked(0, Minimum), asked(30, Maximum), asked(70, Saddle) }), "taken");
}

TEST(FunctionDesignInput, refusesParameters)
{
  const TriangleMesh mesh = subdividedSphere(2);
  const std::vector<CriticalRequest> requests{ asked(0, Minimum), asked(30, Maximum) };
  DesignParameters parameters;
  parameters.epsilon = 0.0;
  EXPECT_THAT(refusal(mesh, requests, parameters), HasSubstr("Epsilon"));
  parameters.epsilon = 1e5;
  parameters.kernelWidth = -1.0;
  EXPECT_THAT(refusal(mesh, requests, parameters), HasSubstr("KernelWidth"));
  parameters.kernelWidth = 0.0;
  parameters.approach = DesignApproach::Meshless;
  parameters.constraints = DesignConstraints::LeastSquares;
  parameters.kernel = KernelType::Harmonic;
  EXPECT_THAT(refusal(mesh, requests, parameters), HasSubstr("another Kernel than Harmonic"));
  // A Gaussian so wide that its system is singular.
  parameters.constraints = DesignConstraints::Interpolating;
  parameters.kernel = KernelType::Gaussian;
  parameters.kernelWidth = 1e3;
  EXPECT_THAT(refusal(mesh, requests, parameters), HasSubstr("Gaussian kernels"));

  // Values that cannot differ around their points.
  EXPECT_THAT(refusal(mesh, { asked(0, Minimum, 1, 1e17), asked(30, Maximum, 1, 1e17 + 64) }),
    HasSubstr("differ around each critical point"));
  EXPECT_THAT(refusal(mesh, { asked(0, Minimum, 1, -1.7e308), asked(30, Maximum, 1, 1.7e308) }),
    HasSubstr("Choose another unit"));
}

// One point, one type, values that say nothing: a function all the same, in which what is asked for
// is more than ties and rounding errors, though the first pass is constant.
TEST(FunctionDesignInput, takesLittle)
{
  const TriangleMesh mesh = plateWithHoles(1, 2);
  const DesignMesh design(mesh.points, trianglesOf(mesh));
  for (const auto approach : { DesignApproach::MeshBased, DesignApproach::Meshless })
  {
    DesignParameters parameters;
    parameters.approach = approach;
    for (const auto type : { Minimum, Saddle, Maximum })
    {
      for (const std::size_t count : { 1U, 2U, 4U })
      {
        std::vector<CriticalRequest> requests{ asked(200, Saddle) };
        for (std::size_t i = 0; i < count; ++i)
        {
          requests.push_back(asked(static_cast<Index>(30 + 30 * i), type));
        }
        const DesignedFunction result = designFunction(design, requests, parameters);
        EXPECT_TRUE(result.missing.empty());
        EXPECT_GT(leastDifference(design.topology(), result.values, requests), 1e-9);
      }
    }
  }
}

// Four centers are interpolated by the linear polynomial alone: least squares has nothing to
// choose.
TEST(FunctionDesignInput, takesTetrahedra)
{
  const TriangleMesh mesh{ (Points(3, 4) << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1).finished(),
    { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } } };
  DesignParameters parameters;
  parameters.approach = DesignApproach::Meshless;
  parameters.constraints = DesignConstraints::LeastSquares;
  const DesignMesh design(mesh.points, trianglesOf(mesh));
  EXPECT_TRUE(designFunction(design, { asked(0, Maximum) }, parameters).missing.empty());
  parameters.kernel = KernelType::Gaussian;
  for (const double width : { 1e-200, 1e200 })
  {
    parameters.kernelWidth = width;
    try
    {
      EXPECT_TRUE(designFunction(design, { asked(0, Maximum) }, parameters).values.allFinite());
    }
    catch (const Error&)
    {
    }
  }
}

// An abort is heard in the first pass, and what was asked for before remains known.
TEST(FunctionDesignInput, hearsAborts)
{
  const TriangleMesh mesh = subdividedSphere(4);
  const DesignMesh design(mesh.points, trianglesOf(mesh));
  const std::vector<CriticalRequest> requests{ asked(0, Minimum), asked(30, Maximum),
    asked(700, Saddle) };
  for (const double until : { 0.0, 0.1, 0.3, 0.5, 0.8 })
  {
    const Execution execution{ 0, [&](double fraction) { return fraction < until; } };
    EXPECT_THROW(designFunction(design, requests, {}, execution), Aborted);
  }
  EXPECT_TRUE(designFunction(design, requests, {}).missing.empty());
}

} // namespace
} // namespace SurfaceScalars
