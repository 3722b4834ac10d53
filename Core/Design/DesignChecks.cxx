#include "DesignChecks.h"

#include "NumberText.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace SurfaceScalars
{
namespace
{

/// Vertices with a value: the systems are dense, their decompositions take seconds.
constexpr std::size_t MostConstraints = 3000;

void checkRequest(const MeshTopology& mesh, const CriticalRequest& request, const std::string& name)
{
  require(request.vertex < mesh.vertexCount(),
    "vertices below " + std::to_string(mesh.vertexCount()),
    std::to_string(request.vertex) + " of " + name, "Choose existing vertices.");
  require(request.type == CriticalType::Minimum || request.type == CriticalType::Saddle ||
      request.type == CriticalType::Maximum,
    "minima, saddles and maxima", "the type of " + name + ", " + nameOf(request.type),
    "Choose one of the three types.");
  require(!request.value || std::isfinite(*request.value), "finite values",
    textOf(request.value.value_or(0.0)) + " of " + name, "Correct the value.");
  const bool isSaddle = request.type == CriticalType::Saddle;
  require(!isSaddle || request.multiplicity >= 1, "saddles of multiplicity 1 or more",
    std::to_string(request.multiplicity) + " of " + name, "Correct the multiplicity.");
  const Index found = mesh.link(request.vertex).size();
  const Index needed = neededLinkSize(mesh, request);
  require(found >= needed,
    "at least " + std::to_string(needed) + " neighbors of " + name + ", a saddle of multiplicity " +
      std::to_string(request.multiplicity),
    std::to_string(found), "Refine its star, or lower the multiplicity.");
  const bool isWhole = request.star.empty() || (request.star.size() == found && request.value);
  require(isWhole &&
      std::all_of(request.star.begin(), request.star.end(),
        [](double value) { return std::isfinite(value); }),
    "finite values of " + name + " and its " + std::to_string(found) + " neighbors, or no star",
    std::to_string(request.star.size()) + " values of neighbors", "Correct the star.");
}

/// Differences and their multiples have to be finite.
void checkRange(const std::vector<CriticalRequest>& requests)
{
  double largest = 0.0;
  for (const CriticalRequest& request : requests)
  {
    largest = std::max(largest, std::abs(request.value.value_or(0.0)));
  }
  constexpr double most = 1e300;
  require(largest <= most, "values of at most " + textOf(most) + " in magnitude", textOf(largest),
    "Choose another unit.");
}

void checkComponents(const DesignMesh& mesh, const std::vector<CriticalRequest>& requests)
{
  const MeshTopology& topology = mesh.topology();
  std::vector<char> isAsked(topology.componentCount(), 0);
  for (const CriticalRequest& request : requests)
  {
    isAsked[topology.component(request.vertex)] = 1;
  }
  Index vertex = 0;
  while (vertex < topology.vertexCount() && isAsked[topology.component(vertex)] != 0)
  {
    ++vertex;
  }
  require(vertex == topology.vertexCount(),
    "critical points on each of the " + std::to_string(topology.componentCount()) +
      " connected components",
    "none on the one of point " + std::to_string(nameOfVertex(vertex, mesh.nameOf())),
    "Choose a point there, or take one component with Connectivity and Threshold.");
}

} // namespace

void checkDesign(const DesignParameters& parameters)
{
  require(parameters.epsilon > 0.0 && std::isfinite(parameters.epsilon), "Epsilon above 0",
    textOf(parameters.epsilon), "Choose one such as 1e5; larger values stay closer to the points.");
  require(parameters.kernelWidth >= 0.0 && std::isfinite(parameters.kernelWidth),
    "KernelWidth above 0, or 0 for an automatic one", textOf(parameters.kernelWidth),
    "Choose a length.");
  require(parameters.approach != DesignApproach::Meshless ||
      parameters.constraints != DesignConstraints::LeastSquares ||
      parameters.kernel != KernelType::Harmonic,
    "another Kernel than Harmonic for LeastSquares, as its system is not symmetric", "Harmonic",
    "Choose the Cubic Kernel or Interpolating constraints.");
}

void checkRequests(
  const DesignMesh& mesh, const std::vector<CriticalRequest>& requests, const PlaceName& nameOf)
{
  const MeshTopology& topology = mesh.topology();
  require(!requests.empty(), "at least one critical point", "none",
    "Choose points with a CriticalType, or a template function.");
  std::map<Index, std::size_t> known;
  std::size_t constraintCount = 0;
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    checkRequest(topology, requests[i], nameOf(i));
    const auto [same, isNew] = known.emplace(requests[i].vertex, i);
    require(isNew, "critical points at different vertices",
      nameOf(same->second) + " and " + nameOf(i) + " both at point " +
        std::to_string(nameOfVertex(requests[i].vertex, mesh.nameOf())),
      "Remove one of them, or move it by an edge or more.");
    constraintCount += 1 + topology.link(requests[i].vertex).size();
  }
  require(constraintCount <= MostConstraints,
    "critical points that have, with their neighbors, at most " + std::to_string(MostConstraints) +
      " vertices",
    std::to_string(requests.size()) + " with " + std::to_string(constraintCount),
    "Raise PersistenceThreshold, or choose fewer points.");
  checkRange(requests);
  checkComponents(mesh, requests);
}

} // namespace SurfaceScalars
