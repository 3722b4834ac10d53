#include "DesignCleanUp.h"

#include "DesignValues.h"
#include "ExtremalVertices.h"
#include "TopologicalSimplification.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

/// Extrema that must remain, and those of saddles that are asked for.
ExtremalVertices neededExtrema(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  std::vector<char> isAsked(mesh.topology().vertexCount(), 0);
  for (const CriticalRequest& request : requests)
  {
    isAsked[request.vertex] = 1;
  }
  const auto [points, pairs] =
    meshCriticalPoints(mesh.vertices(), mesh.topology(), values, execution);
  std::vector<char> isNeeded(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    isNeeded[i] = isAsked[points[i].input];
  }
  for (const CriticalPair& pair : pairs)
  {
    isNeeded[pair.extremum] |= isAsked[points[pair.saddle].input];
  }
  std::vector<CriticalPoint> needed;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (isNeeded[i] != 0)
    {
      needed.push_back(points[i]);
    }
  }
  ExtremalVertices result = extremaOf(needed);
  addComponentExtrema(result, mesh.topology(), values);
  return result;
}

} // namespace

Values withoutUnneeded(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  const ExtremalVertices needed = neededExtrema(mesh, values, requests, execution.part(0.0, 0.4));
  const MeshTopology& topology = mesh.topology();
  Values result = keepExtrema(
    topology, values, needed.minima, needed.maxima, execution.part(0.4, 0.8), mesh.nameOf());
  const std::vector<char> before = areMet(classifyVertices(topology, values), requests);
  const std::vector<char> after =
    areMet(classifyVertices(topology, result, execution.part(0.9, 1.0)), requests);
  const bool isKept = std::equal(before.begin(), before.end(), after.begin(),
    [](char was, char is) { return is != 0 || was == 0; });
  return isKept ? result : values;
}

} // namespace SurfaceScalars
