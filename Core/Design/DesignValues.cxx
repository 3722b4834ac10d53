#include "DesignValues.h"

#include "StarTemplate.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// Of the values' range over the squared distance to the next critical point: how curved f is at
/// least, where it would be flat.
constexpr double LeastCurvature = 0.1;
constexpr double Rounding = 1e-9; // of the values' range: what solvers may add
/// Of the range, from its ends: where a saddle is chosen for which the first pass, which may
/// overshoot, has a value outside. A pass is not to be above all peaks.
constexpr double SaddleMargin = 0.05;

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

/// Of some values; empty without any.
struct ValueRange
{
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  void add(double value)
  {
    this->lowest = std::min(this->lowest, value);
    this->highest = std::max(this->highest, value);
  }
  bool isFlat() const { return this->lowest >= this->highest; }
};

/// The values of extrema without one: the ends of the range of given values, or beyond them where
/// others than such extrema are there.
DesignValues givenRange(const std::vector<CriticalRequest>& requests)
{
  ValueRange all;
  ValueRange notMinima;
  ValueRange notMaxima;
  for (const CriticalRequest& request : requests)
  {
    if (request.value)
    {
      all.add(*request.value);
      (request.type == CriticalType::Minimum ? notMaxima : notMinima).add(*request.value);
      if (request.type == CriticalType::Saddle)
      {
        notMaxima.add(*request.value);
      }
    }
  }
  if (all.lowest > all.highest)
  {
    return { 0.0, 1.0, {} };
  }
  const double size = std::max(std::abs(all.lowest), std::abs(all.highest));
  const double step = !all.isFlat() ? all.highest - all.lowest : size > 0.0 ? size : 1.0;
  return { all.lowest - (notMinima.lowest <= all.lowest ? step : 0.0),
    all.highest + (notMaxima.highest >= all.highest ? step : 0.0), {} };
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

/// What the first pass left of the values, and is to be asked for.
class SecondPass
{
public:
  SecondPass(const PointsRef& vertices, const MeshTopology& mesh,
    const std::vector<CriticalRequest>& requests, const DesignValues& chosen, Values field)
    : vertices_(vertices)
    , mesh_(mesh)
    , requests_(requests)
    , chosen_(chosen)
    , field_(std::move(field))
  {
    if (this->field_.size() > 0)
    {
      this->met_ = areMet(classifyVertices(mesh, this->field_), requests);
    }
  }

  StarRequest star(std::size_t request) const;

private:
  double value(std::size_t request) const;
  std::optional<std::vector<double>> metDifferences(std::size_t request, double value) const;
  std::vector<double> wantedDifferences(const CriticalRequest& request) const;

  const PointsRef& vertices_;
  const MeshTopology& mesh_;
  const std::vector<CriticalRequest>& requests_;
  const DesignValues& chosen_;
  Values field_;          ///< empty if all stars are given
  std::vector<char> met_; ///< requests that the field meets as it is
};

std::vector<double> SecondPass::wantedDifferences(const CriticalRequest& request) const
{
  const std::vector<Vector3d> offsets = offsetsFrom(this->vertices_, this->requests_, request);
  const double distance = distanceToNext(this->vertices_, offsets);
  const double curvature =
    LeastCurvature * (this->chosen_.highest - this->chosen_.lowest) / (distance * distance);
  return starTemplate(this->vertices_, this->mesh_, this->field_,
    { request.vertex, request.type, request.multiplicity, curvature, offsets });
}

double SecondPass::value(std::size_t request) const
{
  const auto& [lowest, highest, values] = this->chosen_;
  if (values[request])
  {
    return *values[request];
  }
  const double value = this->field_[this->requests_[request].vertex];
  const double margin = SaddleMargin * (highest - lowest);
  return value > lowest && value < highest ? value
                                           : std::clamp(value, lowest + margin, highest - margin);
}

/// Those of the field, if it is what is asked for by more than rounding errors.
std::optional<std::vector<double>> SecondPass::metDifferences(
  std::size_t request, double value) const
{
  const double least = Rounding * (this->chosen_.highest - this->chosen_.lowest);
  std::vector<double> result;
  bool isMet = this->met_[request] != 0 && value == this->field_[this->requests_[request].vertex];
  for (const Index neighbor : this->mesh_.link(this->requests_[request].vertex))
  {
    result.push_back(this->field_[neighbor] - value);
    isMet = isMet && std::abs(result.back()) > least;
  }
  return isMet ? std::make_optional(result) : std::nullopt;
}

StarRequest SecondPass::star(std::size_t request) const
{
  const CriticalRequest& asked = this->requests_[request];
  const double value = this->value(request);
  StarRequest result{ asked.vertex, asked.type, asked.multiplicity, value, asked.star };
  if (isFree(asked))
  {
    const auto met = this->metDifferences(request, value);
    result.differences = met ? *met : this->wantedDifferences(asked);
    return result;
  }
  for (double& difference : result.differences)
  {
    difference -= value;
  }
  return result;
}

} // namespace

std::vector<char> areMet(const VertexTypes& types, const std::vector<CriticalRequest>& requests)
{
  std::vector<char> result;
  for (const CriticalRequest& request : requests)
  {
    const bool isSame = types.types[request.vertex] == request.type;
    const auto multiplicity = static_cast<int>(types.multiplicities[request.vertex]);
    result.push_back(
      isSame && (request.type != CriticalType::Saddle || multiplicity == request.multiplicity));
  }
  return result;
}

DesignValues designValues(const MeshTopology& mesh, const std::vector<CriticalRequest>& requests)
{
  DesignValues result = givenRange(requests);
  std::vector<ValueRange> known(mesh.componentCount());
  for (const CriticalRequest& request : requests)
  {
    result.values.push_back(request.value);
    if (!request.value && request.type != CriticalType::Saddle)
    {
      result.values.back() = request.type == CriticalType::Minimum ? result.lowest : result.highest;
    }
    if (result.values.back())
    {
      known[mesh.component(request.vertex)].add(*result.values.back());
    }
  }
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    if (!result.values[i] && known[mesh.component(requests[i].vertex)].isFlat())
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
  const SecondPass second(vertices, mesh, requests, chosen,
    isTemplate ? Values() : extension(knownValues(mesh, requests, chosen), execution));
  std::vector<StarRequest> stars;
  for (std::size_t i = 0; i < requests.size(); ++i)
  {
    stars.push_back(second.star(i));
  }
  return starValues(mesh, stars, nameOf);
}

} // namespace SurfaceScalars
