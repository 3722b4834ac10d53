#include "DesignCleanUp.h"

#include "DesignValues.h"
#include "EvenChanges.h"
#include "ExtremalVertices.h"
#include "MonotoneFit.h"
#include "MorseNetwork.h"
#include "MorseSweep.h"
#include "TopologicalSimplification.h"

#include <algorithm>
#include <optional>
#include <utility>

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

/// The extrema, and saddles that cancel those that are not needed.
Values withNeededExtrema(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  const ExtremalVertices needed = neededExtrema(mesh, values, requests, execution.part(0.0, 0.5));
  return keepExtrema(
    mesh.topology(), values, needed.minima, needed.maxima, execution.part(0.5, 1.0), mesh.nameOf());
}

/// Tried one after the other: the fewer detours paths make, the less they are in each other's way.
constexpr PathCosts Attempts[] = { { 1.0, false }, { 1.0, true }, { 0.3, false }, { 0.3, true },
  { 0.1, false }, { 0.1, true }, { 0.0, false }, { 0.0, true } };

/// An order near that of the values in which the points and no others are critical: by descending
/// paths or, where these find no room, by ascending ones; none if neither do.
std::optional<VertexOrder> orderWithPoints(const DesignMesh& mesh, const Values& values,
  const std::vector<MorsePoint>& points, const Execution& execution)
{
  const std::vector<MorsePoint> pointsBelow = upsideDown(points);
  const Values valuesBelow = -values;
  for (const PathCosts& costs : Attempts)
  {
    for (const bool isUpwards : { true, false })
    {
      const Values& f = isUpwards ? values : valuesBelow;
      const std::vector<MorsePoint>& ofF = isUpwards ? points : pointsBelow;
      const Execution still = execution.part(0.0, 0.0); // nobody knows how many attempts
      const std::optional<MorseNetwork> network = morseNetwork(mesh, f, ofF, costs, still);
      std::optional<VertexOrder> order =
        network ? sweepWithPoints(mesh.topology(), ofF, *network, still) : std::nullopt;
      if (order)
      {
        return isUpwards ? *std::move(order) : order->reversed();
      }
    }
  }
  return std::nullopt;
}

/// A function with the needed critical points and no others; none if there is no room for it.
std::optional<Values> withNeededPoints(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  const MeshTopology& topology = mesh.topology();
  const std::vector<MorsePoint> points =
    morsePoints(mesh, values, requests, execution.part(0.0, 0.2));
  if (points.empty())
  {
    return std::nullopt;
  }
  const std::optional<VertexOrder> order =
    orderWithPoints(mesh, values, points, execution.part(0.2, 0.8));
  if (!order)
  {
    return std::nullopt;
  }
  ExtremumSigns isKept(topology.vertexCount(), 0);
  for (const MorsePoint& point : points)
  {
    isKept[point.vertex] = 1;
  }
  return withEvenChanges(topology, values,
    fitMonotone(topology, *order, values, isKept, execution.part(0.8, 0.9)), isKept,
    execution.part(0.9, 1.0));
}

} // namespace

Values withoutUnneeded(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  const MeshTopology& topology = mesh.topology();
  if (topology.isClosed())
  {
    std::optional<Values> exact =
      withNeededPoints(mesh, values, requests, execution.part(0.0, 0.5));
    if (exact)
    {
      return *std::move(exact);
    }
  }
  Values result = withNeededExtrema(mesh, values, requests, execution.part(0.5, 0.9));
  const std::vector<char> before = areMet(classifyVertices(topology, values), requests);
  const std::vector<char> after =
    areMet(classifyVertices(topology, result, execution.part(0.9, 1.0)), requests);
  const bool isKept = std::equal(before.begin(), before.end(), after.begin(),
    [](char was, char is) { return is != 0 || was == 0; });
  return isKept ? result : values;
}

} // namespace SurfaceScalars
