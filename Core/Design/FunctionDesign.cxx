#include "FunctionDesign.h"

#include "DesignChecks.h"
#include "DesignCleanUp.h"
#include "DesignValues.h"
#include "LeastEnergy.h"
#include "RadialDesign.h"

#include <cmath>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

// The shares of the whole that end with the two passes and the clean-up.
constexpr double FirstShare = 0.4;
constexpr double SecondShare = 0.9;
constexpr double CleanShare = 0.95;

using Constraints = std::vector<ValueConstraint>;

ValueExtension firstPass(const DesignMesh& mesh, const DesignParameters& parameters)
{
  if (parameters.approach == DesignApproach::Meshless)
  {
    return [&mesh](const Constraints& known, const Execution& execution)
    { return RadialDesign(mesh, KernelType::Cubic, 0.0).through(known, execution); };
  }
  return [&mesh, energy = parameters.energy, metric = parameters.metric](
           const Constraints& known, const Execution& execution)
  {
    GreensFunctions& functions = mesh.greensFunctions(energy, metric, execution.part(0.0, 0.6));
    return leastEnergyThrough(functions,
      energyConstraints(functions, known, execution.part(0.6, 0.9), mesh.nameOf()),
      execution.part(0.9, 1.0));
  };
}

/// What the second pass makes.
struct Solution
{
  Values values;
  double epsilon = 0.0;
  ParameterCurve curve;
};

/// Chooses epsilon. @param curveOf makes the curve
template <class CurveOf>
Solution withEpsilon(const DesignParameters& parameters, const CurveOf& curveOf)
{
  Solution solution;
  solution.epsilon = parameters.epsilon;
  if (parameters.epsilonChoice != EpsilonChoice::Manual)
  {
    solution.curve = curveOf();
  }
  if (solution.curve.epsilons.size() > 0)
  {
    solution.epsilon = chooseEpsilon(solution.curve, parameters.epsilonChoice);
  }
  return solution;
}

Solution solveOnMesh(const DesignMesh& mesh, const Constraints& constraints,
  const DesignParameters& parameters, const Execution& execution)
{
  GreensFunctions& functions =
    mesh.greensFunctions(parameters.energy, parameters.metric, execution.part(0.0, 0.3));
  const EnergyConstraints known =
    energyConstraints(functions, constraints, execution.part(0.3, 0.9), mesh.nameOf());
  if (parameters.constraints == DesignConstraints::Interpolating)
  {
    return { leastEnergyThrough(functions, known, execution.part(0.9, 1.0)), 0.0, {} };
  }
  const LeastEnergyNear near(
    functions, known, mesh.metric(parameters.metric, execution), execution.part(0.9, 0.95));
  const double area = mesh.area(execution);
  const double unit =
    parameters.energy == SmoothingEnergy::Biharmonic ? 1.0 / (area * area) : 1.0 / area;
  Solution solution = withEpsilon(parameters, [&]() { return near.curve(unit); });
  solution.values = near.solve(solution.epsilon * unit);
  return solution;
}

Solution solveMeshless(const DesignMesh& mesh, const Constraints& constraints,
  const DesignParameters& parameters, const Execution& execution)
{
  const RadialDesign radial(mesh, parameters.kernel, parameters.kernelWidth);
  if (parameters.constraints == DesignConstraints::Interpolating)
  {
    return { radial.through(constraints, execution), 0.0, {} };
  }
  Solution solution =
    withEpsilon(parameters, [&]() { return radial.curve(constraints, execution.part(0.0, 0.5)); });
  solution.values = radial.near(constraints, solution.epsilon, execution.part(0.5, 1.0));
  return solution;
}

void measure(DesignedFunction& result, const DesignMesh& mesh,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  const MeshTopology& topology = mesh.topology();
  const VertexTypes types = classifyVertices(topology, result.values);
  result.critical = meshCriticalPoints(mesh.vertices(), topology, result.values, execution);
  const std::vector<char> met = areMet(types, requests);
  std::vector<char> isAsked(topology.vertexCount(), 0);
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    isAsked[requests[i].vertex] = met[i];
    if (met[i] == 0)
    {
      result.missing.push_back(i);
    }
  }
  for (const CriticalPoint& point : result.critical.points)
  {
    result.prescribed.push_back(isAsked[point.input]);
  }
}

} // namespace

Index neededLinkSize(const MeshTopology& mesh, const CriticalRequest& request)
{
  if (request.type != CriticalType::Saddle)
  {
    return 1;
  }
  const auto multiplicity = static_cast<Index>(request.multiplicity);
  return mesh.isBoundary(request.vertex) ? multiplicity + 2 : 2 * multiplicity + 2;
}

std::vector<CriticalRequest> requestsOf(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& templateValues, double persistenceThreshold, const Execution& execution)
{
  auto [points, pairs] = meshCriticalPoints(vertices, mesh, templateValues, execution);
  const double range = templateValues.maxCoeff() - templateValues.minCoeff();
  removeBelow(points, pairs, persistenceThreshold * range);
  std::vector<CriticalRequest> result;
  for (const CriticalPoint& point : points)
  {
    CriticalRequest request{ static_cast<Index>(point.input), point.type, point.multiplicity,
      point.value, {} };
    for (const Index neighbor : mesh.link(request.vertex))
    {
      request.star.push_back(templateValues[neighbor]);
    }
    result.push_back(std::move(request));
  }
  return result;
}

DesignedFunction designFunction(const DesignMesh& mesh,
  const std::vector<CriticalRequest>& requests, const DesignParameters& parameters,
  const Execution& execution, const PlaceName& nameOf)
{
  const PlaceName name = nameOf
    ? nameOf
    : PlaceName([](std::size_t i) { return "critical point " + std::to_string(i); });
  checkDesign(parameters);
  checkRequests(mesh, requests, name);
  const Constraints constraints = constraintsOf(mesh.vertices(), mesh.topology(), requests,
    firstPass(mesh, parameters), execution.part(0.0, FirstShare), name);

  const Execution second = execution.part(FirstShare, SecondShare);
  Solution solution = parameters.approach == DesignApproach::MeshBased
    ? solveOnMesh(mesh, constraints, parameters, second)
    : solveMeshless(mesh, constraints, parameters, second);
  if (parameters.cleanUp)
  {
    solution.values =
      withoutUnneeded(mesh, solution.values, requests, execution.part(SecondShare, CleanShare));
  }
  DesignedFunction result;
  result.values = std::move(solution.values);
  result.epsilon = solution.epsilon;
  result.curve = std::move(solution.curve);
  measure(result, mesh, requests, execution.part(CleanShare, 1.0));
  return result;
}

} // namespace SurfaceScalars
