#pragma once

#include "FunctionDesign.h"
#include "LinkWalk.h"
#include "Meshes.h"
#include "Sampling.h"
#include "StarRefinement.h"

#include <algorithm>
#include <array>
#include <vector>

/// Critical points to ask for, and whether they are there.
namespace SurfaceScalars::Truth
{

/// 2 to 20 critical points of random types and multiplicities up to 3, none of which share
/// neighbors; with random values or without.
inline std::vector<CriticalRequest> randomRequests(const MeshTopology& mesh, unsigned seed)
{
  Random random(seed);
  const auto below = [&](double count) { return static_cast<Index>(random.uniform() * count); };
  constexpr std::array<CriticalType, 3> types{ CriticalType::Minimum, CriticalType::Saddle,
    CriticalType::Maximum };
  std::vector<CriticalRequest> result(2 + below(19));
  std::vector<char> isTaken(mesh.vertexCount(), 0);
  for (CriticalRequest& request : result)
  {
    do
    {
      request.vertex = below(mesh.vertexCount());
    } while (isTaken[request.vertex] != 0);
    for (const Index neighbor : mesh.link(request.vertex))
    {
      isTaken[neighbor] = 1;
      for (const Index next : mesh.link(neighbor))
      {
        isTaken[next] = 1;
      }
    }
    request.type = types[below(3)];
    request.multiplicity =
      request.type == CriticalType::Saddle ? 1 + static_cast<int>(below(3)) : 1;
    if (seed % 2 == 0)
    {
      request.value = random.uniform(-3.0, 7.0);
    }
  }
  return result;
}

/// The mesh with neighbors enough for these requests.
inline TriangleMesh refinedFor(
  const TriangleMesh& mesh, const std::vector<CriticalRequest>& requests)
{
  const MeshTopology topology = topologyOf(mesh);
  std::vector<NeededLink> needed;
  for (const CriticalRequest& request : requests)
  {
    needed.push_back({ request.vertex, neededLinkSize(topology, request) });
  }
  const RefinedMesh refined = refineStars(mesh.points, topology, needed);
  TriangleMesh result{ refined.vertices, {} };
  for (const auto corners : refined.triangles.colwise())
  {
    result.triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
  }
  return result;
}

/// How many requests are what a walk around their vertices finds.
inline std::size_t metByWalking(
  const TriangleMesh& mesh, const Values& values, const std::vector<CriticalRequest>& requests)
{
  const std::vector<VertexType> types = typesByWalking(orderedLinks(mesh), values);
  return static_cast<std::size_t>(std::count_if(requests.begin(), requests.end(),
    [&](const CriticalRequest& request) {
      return types[request.vertex] == VertexType{ request.type, request.multiplicity };
    }));
}

} // namespace SurfaceScalars::Truth
