#include "SmoothingFeatures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double Rounding = 1e-9; // of the range: what solvers may add

template <class Condition>
void removeIf(std::vector<CriticalPoint>& points, const Condition& condition)
{
  points.erase(std::remove_if(points.begin(), points.end(), condition), points.end());
}

/// The critical points of a function that the parameters choose.
std::vector<CriticalPoint> chosenPoints(const SmoothingData& data, const ValuesRef& function,
  const SmoothingParameters& parameters, const Execution& execution)
{
  const MeshTopology& topology = data.mesh.topology();
  auto [points, pairs] =
    meshCriticalPoints(data.mesh.vertices(), topology, function, execution.part(0.0, 0.8));
  switch (parameters.constraints)
  {
    case ConstraintChoice::AllCriticalPoints:
      break;
    case ConstraintChoice::DeltaSimplified:
    {
      const VertexTypes types = classifyVertices(topology, function, execution.part(0.8, 0.9));
      const Values thresholds =
        deltaThresholds(topology, function, types, execution.part(0.9, 1.0));
      const double delta = parameters.delta * data.range;
      removeIf(points,
        [&](const CriticalPoint& point)
        { return delta > 0.0 && thresholds[static_cast<Eigen::Index>(point.input)] <= delta; });
      break;
    }
    case ConstraintChoice::Persistent:
      removeBelow(points, pairs, parameters.persistenceThreshold * data.range);
      break;
    case ConstraintChoice::MaskArray:
      removeIf(
        points, [&](const CriticalPoint& point) { return parameters.mask[point.input] == 0; });
      break;
  }
  return std::move(points);
}

/// Adds the lowest and the highest vertex of each component, ties by index.
void addComponentExtrema(
  ExtremalVertices& extrema, const MeshTopology& topology, const Values& function)
{
  constexpr Index None = std::numeric_limits<Index>::max();
  std::vector<Index> lowest(topology.componentCount(), None);
  std::vector<Index> highest(topology.componentCount(), None);
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    Index& low = lowest[topology.component(vertex)];
    Index& high = highest[topology.component(vertex)];
    low = low == None || function[vertex] < function[low] ? vertex : low;
    high = high == None || function[vertex] >= function[high] ? vertex : high;
  }
  const auto add = [](std::vector<Index>& to, const std::vector<Index>& some)
  {
    to.insert(to.end(), some.begin(), some.end());
    std::sort(to.begin(), to.end());
    to.erase(std::unique(to.begin(), to.end()), to.end());
  };
  add(extrema.minima, lowest);
  add(extrema.maxima, highest);
}

std::vector<Index> markedVertices(const std::vector<char>& mask)
{
  std::vector<Index> result;
  for (std::size_t vertex = 0; vertex < mask.size(); ++vertex)
  {
    if (mask[vertex] != 0)
    {
      result.push_back(static_cast<Index>(vertex));
    }
  }
  return result;
}

std::vector<Index> verticesOf(const std::vector<CriticalPoint>& points)
{
  std::vector<Index> result;
  result.reserve(points.size());
  for (const CriticalPoint& point : points)
  {
    result.push_back(static_cast<Index>(point.input));
  }
  return result;
}

/// The first vertex of steps to the first neighbor.
template <class Order>
Index endOfSteps(const MeshTopology& mesh, Index vertex, const Order& isBefore)
{
  for (Index last = vertex;; last = vertex)
  {
    for (const Index neighbor : mesh.link(last))
    {
      vertex = isBefore(neighbor, vertex) ? neighbor : vertex;
    }
    if (vertex == last)
    {
      return vertex;
    }
  }
}

/// To the ends of their steps, but for those that share one and those that would not be near.
template <class Order, class Nearness>
std::vector<Index> movedAlong(const MeshTopology& mesh, const std::vector<Index>& vertices,
  const Order& isBefore, const Nearness& isNear)
{
  std::map<Index, int> arrivals;
  for (const Index vertex : vertices)
  {
    ++arrivals[endOfSteps(mesh, vertex, isBefore)];
  }
  std::vector<Index> result;
  for (const Index vertex : vertices)
  {
    const Index end = endOfSteps(mesh, vertex, isBefore);
    result.push_back(arrivals[end] == 1 && isNear(vertex, end) ? end : vertex);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Whether no two of the vertices are neighbors.
bool areApart(const MeshTopology& mesh, const std::vector<Index>& vertices)
{
  std::vector<char> isOne(mesh.vertexCount(), 0);
  for (const Index vertex : vertices)
  {
    isOne[vertex] = 1;
  }
  return std::none_of(vertices.begin(), vertices.end(),
    [&](Index vertex)
    {
      const VertexRange link = mesh.link(vertex);
      return std::any_of(
        link.begin(), link.end(), [&](Index neighbor) { return isOne[neighbor] != 0; });
    });
}

} // namespace

ExtremalVertices extremaOf(const std::vector<CriticalPoint>& points)
{
  ExtremalVertices result;
  for (const CriticalPoint& point : points)
  {
    if (point.type == CriticalType::Minimum)
    {
      result.minima.push_back(static_cast<Index>(point.input));
    }
    else if (point.type == CriticalType::Maximum)
    {
      result.maxima.push_back(static_cast<Index>(point.input));
    }
  }
  return result;
}

ExtremalVertices extremaToKeep(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution)
{
  std::vector<CriticalPoint> points = chosenPoints(data, data.smooth, parameters, execution);
  removeIf(
    points, [&](const CriticalPoint& point) { return point.persistence <= Rounding * data.range; });
  ExtremalVertices result = extremaOf(points);
  addComponentExtrema(result, data.mesh.topology(), data.smooth);
  return result;
}

ExtremalVertices placed(const SmoothingData& data, const ExtremalVertices& extrema,
  const Values& further, double tolerance)
{
  const MeshTopology& topology = data.mesh.topology();
  const auto isBelow = [&](Index a, Index b)
  { return further[a] < further[b] || (further[a] == further[b] && a < b); };
  const auto isAbove = [&](Index a, Index b) { return isBelow(b, a); };
  const auto isNear = [&](Index a, Index b)
  { return std::abs(data.smooth[a] - data.smooth[b]) <= tolerance; };
  const ExtremalVertices moved{ movedAlong(topology, extrema.minima, isBelow, isNear),
    movedAlong(topology, extrema.maxima, isAbove, isNear) };
  return areApart(topology, moved.minima) && areApart(topology, moved.maxima) ? moved : extrema;
}

std::vector<ValueConstraint> constraintsOf(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution)
{
  const bool areOfSmooth =
    parameters.smoothedStars && parameters.constraints == ConstraintChoice::Persistent;
  const Values function = areOfSmooth ? data.smooth : Values(data.input);
  const std::vector<Index> vertices = parameters.constraints == ConstraintChoice::MaskArray
    ? markedVertices(parameters.mask)
    : verticesOf(chosenPoints(data, function, parameters, execution));
  const MeshTopology& topology = data.mesh.topology();
  std::vector<char> isConstrained(topology.vertexCount(), 0);
  Values values = data.smooth.size() > 0 ? data.smooth : Values(data.input);
  for (const Index vertex : vertices)
  {
    isConstrained[vertex] = 1;
    values[vertex] = function[vertex];
    if (parameters.includeOneStars)
    {
      for (const Index neighbor : topology.link(vertex))
      {
        isConstrained[neighbor] = 1;
      }
    }
  }
  std::vector<ValueConstraint> result;
  for (const Index vertex : markedVertices(isConstrained))
  {
    result.push_back({ vertex, values[vertex] });
  }
  return result;
}

} // namespace SurfaceScalars
