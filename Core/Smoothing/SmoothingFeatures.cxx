#include "SmoothingFeatures.h"

#include "Require.h"
#include "ValueOrder.h"

#include <algorithm>
#include <iterator>
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
      removeUpToDelta(points, thresholds, parameters.delta * data.range);
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

ExtremalVertices extremaOf(
  const MeshTopology& mesh, const ValuesRef& function, const Execution& execution)
{
  const std::vector<CriticalType> types = classifyVertices(mesh, function, execution).types;
  ExtremalVertices result;
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    if (types[vertex] == CriticalType::Minimum)
    {
      result.minima.push_back(vertex);
    }
    else if (types[vertex] == CriticalType::Maximum)
    {
      result.maxima.push_back(vertex);
    }
  }
  return result;
}

/// Those that are in both, ascending.
ExtremalVertices common(const ExtremalVertices& a, const ExtremalVertices& b)
{
  ExtremalVertices result;
  std::set_intersection(a.minima.begin(), a.minima.end(), b.minima.begin(), b.minima.end(),
    std::back_inserter(result.minima));
  std::set_intersection(a.maxima.begin(), a.maxima.end(), b.maxima.begin(), b.maxima.end(),
    std::back_inserter(result.maxima));
  return result;
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

/// The extrema among the points whose persistence is more than rounding.
ExtremalVertices extremaBeyondRounding(std::vector<CriticalPoint> points, double range)
{
  removeIf(
    points, [&](const CriticalPoint& point) { return point.persistence <= Rounding * range; });
  return extremaOf(points);
}

/// The chosen extrema of the smooth function that have a counterpart in the input.
ExtremalVertices chosenExtrema(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution)
{
  const SmoothingMesh& mesh = data.mesh;
  const ExtremalVertices chosen = extremaBeyondRounding(
    chosenPoints(data, data.smooth, parameters, execution.part(0.0, 0.4)), data.range);
  const ExtremalVertices ofInput = extremaBeyondRounding(
    meshCriticalPoints(mesh.vertices(), mesh.topology(), data.input, execution.part(0.4, 0.8))
      .points,
    data.range);
  return common(chosen,
    extremaWithCounterpart(mesh.topology(), data.smooth, ofInput, execution.part(0.8, 1.0)));
}

/// Takes those that are asked for out of the vertices.
std::vector<Index> takeAsked(std::vector<Index>& vertices, std::vector<char>& asked)
{
  const auto end = std::stable_partition(
    vertices.begin(), vertices.end(), [&](Index vertex) { return asked[vertex] != 0; });
  std::vector<Index> result(vertices.begin(), end);
  vertices.erase(vertices.begin(), end);
  for (const Index vertex : result)
  {
    asked[vertex] = 0;
  }
  return result;
}

/// The extrema of the smooth function at vertices asked for; for other extrema of the input that
/// are asked for the lowest, or the highest, that is left in their component.
ExtremalVertices askedExtrema(const SmoothingData& data, const Execution& execution)
{
  const MeshTopology& topology = data.mesh.topology();
  std::vector<char> asked = data.asked;
  ExtremalVertices others = extremaOf(topology, data.smooth, execution.part(0.0, 0.3));
  ExtremalVertices result{ takeAsked(others.minima, asked), takeAsked(others.maxima, asked) };
  const ValueOrder isBelow{ data.smooth.data() };
  std::sort(others.minima.begin(), others.minima.end(), isBelow);
  std::sort(others.maxima.rbegin(), others.maxima.rend(), isBelow);
  const ExtremalVertices taken =
    takenExtrema(topology, data.input, others, asked, execution.part(0.3, 1.0));
  result.minima.insert(result.minima.end(), taken.minima.begin(), taken.minima.end());
  result.maxima.insert(result.maxima.end(), taken.maxima.begin(), taken.maxima.end());
  return result;
}

} // namespace

std::vector<char> askedOfInput(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution)
{
  if (parameters.constraints == ConstraintChoice::MaskArray)
  {
    return parameters.mask;
  }
  std::vector<char> result;
  if (parameters.constraints == ConstraintChoice::DeltaSimplified)
  {
    result.assign(data.mesh.topology().vertexCount(), 0);
    for (const Index vertex : verticesOf(chosenPoints(data, data.input, parameters, execution)))
    {
      result[vertex] = 1;
    }
  }
  return result;
}

ExtremalVertices extremaToKeep(
  const SmoothingData& data, const SmoothingParameters& parameters, const Execution& execution)
{
  ExtremalVertices result =
    data.asked.empty() ? chosenExtrema(data, parameters, execution) : askedExtrema(data, execution);
  addComponentExtrema(result, data.mesh.topology(), data.smooth);
  return result;
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
  require(!vertices.empty(), "at least one chosen critical point",
    "none above Delta or PersistenceThreshold",
    "Lower Delta or PersistenceThreshold, or choose other Constraints.");
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
