#include "DesignValues.h"

#include "StarTemplate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

/// Of the values' range over the squared distance to the next critical point: how curved f is at
/// least, where it would be flat.
constexpr double LeastCurvature = 0.1;

/// Offsets to all others from one.
std::vector<Vector3d> offsetsFrom(const PointsRef& vertices,
  const std::vector<CriticalRequest>& requests, const CriticalRequest& request)
{
  std::vector<Vector3d> result;
  for (const CriticalRequest& other : requests)
  {
    const Vector3d offset = vertices.col(other.vertex) - vertices.col(request.vertex);
    if (offset.squaredNorm() > 0.0)
    {
      result.push_back(offset);
    }
  }
  return result;
}

double distanceToNext(const PointsRef& vertices, const std::vector<Vector3d>& offsets)
{
  double result = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).norm();
  for (const Vector3d& offset : offsets)
  {
    result = std::min(result, offset.norm());
  }
  return result;
}

bool isFree(const CriticalRequest& request)
{
  return request.star.empty();
}

/// Values of requests and stars that are known before the first pass.
std::vector<ValueConstraint> knownValues(const MeshTopology& mesh,
  const std::vector<CriticalRequest>& requests, const DesignValues& chosen)
{
  std::vector<ValueConstraint> result;
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    if (chosen.values[i])
    {
      result.push_back({ requests[i].vertex, *chosen.values[i] });
    }
    const VertexRange link = mesh.link(requests[i].vertex);
    for (std::size_t j = 0; j < requests[i].star.size(); ++j)
    {
      result.push_back({ link.begin()[j], requests[i].star[j] });
    }
  }
  return result;
}

std::vector<double> differencesOf(const CriticalRequest& request)
{
  std::vector<double> result = request.star;
  for (double& value : result)
  {
    value -= *request.value;
  }
  return result;
}

} // namespace

DesignValues designValues(const MeshTopology& mesh, const std::vector<CriticalRequest>& requests)
{
  DesignValues result{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity(), {} };
  bool isLowestMinimum = true;
  bool isHighestMaximum = true;
  for (const CriticalRequest& request : requests)
  {
    if (request.value && *request.value <= result.lowest)
    {
      isLowestMinimum = request.type == CriticalType::Minimum;
      result.lowest = *request.value;
    }
    if (request.value && *request.value >= result.highest)
    {
      isHighestMaximum = request.type == CriticalType::Maximum;
      result.highest = *request.value;
    }
  }
  if (result.lowest > result.highest) // none is given
  {
    result.lowest = 0.0;
    result.highest = 1.0;
  }
  else
  {
    const double range = result.highest - result.lowest;
    const double step = range > 0.0 ? range : std::max(1.0, std::abs(range));
    result.lowest -= isLowestMinimum ? 0.0 : step;
    result.highest += isHighestMaximum ? 0.0 : step;
  }

  std::vector<char> isKnown(mesh.componentCount(), 0);
  for (const CriticalRequest& request : requests)
  {
    result.values.push_back(request.value);
    if (!request.value && request.type != CriticalType::Saddle)
    {
      result.values.back() = request.type == CriticalType::Minimum ? result.lowest : result.highest;
    }
    isKnown[mesh.component(request.vertex)] |= result.values.back() ? 1 : 0;
  }
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    if (isKnown[mesh.component(requests[i].vertex)] == 0)
    {
      result.values[i] = 0.5 * (result.lowest + result.highest);
    }
  }
  return result;
}

std::vector<ValueConstraint> constraintsOf(const PointsRef& vertices, const MeshTopology& mesh,
  const std::vector<CriticalRequest>& requests, const ValueExtension& extension,
  const Execution& execution, const PlaceName& nameOf)
{
  const DesignValues chosen = designValues(mesh, requests);
  const bool isTemplate = std::none_of(requests.begin(), requests.end(), isFree);
  const Values field =
    isTemplate ? Values() : extension(knownValues(mesh, requests, chosen), execution);

  std::vector<StarRequest> stars;
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    const CriticalRequest& request = requests[i];
    const double value = chosen.values[i] ? *chosen.values[i] : field[request.vertex];
    StarRequest star{ request.vertex, request.type, request.multiplicity, value, {} };
    if (isFree(request))
    {
      const std::vector<Vector3d> offsets = offsetsFrom(vertices, requests, request);
      const double distance = distanceToNext(vertices, offsets);
      const double curvature =
        LeastCurvature * (chosen.highest - chosen.lowest) / (distance * distance);
      star.differences = starTemplate(vertices, mesh, field,
        { request.vertex, request.type, request.multiplicity, curvature, offsets });
    }
    else
    {
      star.differences = differencesOf(request);
    }
    stars.push_back(std::move(star));
  }
  return starValues(mesh, stars, nameOf);
}

} // namespace SurfaceScalars
