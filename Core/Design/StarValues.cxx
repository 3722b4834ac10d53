#include "StarValues.h"

#include "NumberText.h"
#include "Require.h"
#include "StarSigns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double LeastDifference = 1e-4; // to a critical point, of the largest in its link
constexpr std::size_t Nobody = std::numeric_limits<std::size_t>::max();

/// What is asked of a vertex of a link.
struct SharedVertex
{
  double lower = -Infinite;       ///< its value must be above
  double upper = Infinite;        ///< and below
  std::size_t raisedBy = Nobody;  ///< the request of the value `lower`
  std::size_t loweredBy = Nobody; ///< the one of the value `upper`
  double lowestWanted = Infinite;
  double highestWanted = -Infinite;

  double value() const
  {
    const double middle = 0.5 * (this->lowestWanted + this->highestWanted);
    if (middle > this->lower && middle < this->upper)
    {
      return middle;
    }
    return std::isinf(this->upper) ? this->highestWanted
      : std::isinf(this->lower)    ? this->lowestWanted
                                   : 0.5 * (this->lower + this->upper);
  }
};

class Reconciliation
{
public:
  Reconciliation(
    const MeshTopology& mesh, const std::vector<StarRequest>& requests, const PlaceName& nameOf)
    : mesh_(mesh)
    , requests_(requests)
    , nameOf_(nameOf)
  {
    for (std::size_t i = 0; i < requests.size(); ++i)
    {
      this->requestAt_.emplace(requests[i].vertex, i);
    }
  }

  /// Decides on which side of a critical point's value each vertex of its link is.
  void place(std::size_t request);
  std::vector<ValueConstraint> values() const;

private:
  struct Forced
  {
    int sign = 0; ///< 0 = free
    std::size_t by = Nobody;
  };

  Forced forcedSign(std::size_t request, Index neighbor) const;
  std::vector<int> signsOf(std::size_t request) const;
  void bound(Index neighbor, std::size_t request, double difference);
  [[noreturn]] void refuse(std::size_t request, std::size_t other) const;

  const MeshTopology& mesh_;
  const std::vector<StarRequest>& requests_;
  const PlaceName& nameOf_;
  std::map<Index, std::size_t> requestAt_;
  std::map<Index, SharedVertex> shared_; ///< of links, critical ones excepted
};

void Reconciliation::refuse(std::size_t request, std::size_t other) const
{
  const auto describe = [&](std::size_t i)
  {
    const StarRequest& asked = this->requests_[i];
    return this->nameOf_(i) + ", a " + SurfaceScalars::nameOf(asked.type) + " of value " +
      textOf(asked.value);
  };
  throw InvalidInput("critical points that do not exclude each other",
    describe(request) + ", and " + describe(other) + ", which are neighbors or share neighbors",
    "Move one of them by an edge or two, change its value, or refine the mesh there.");
}

/// What is decided of a neighbor's side.
Reconciliation::Forced Reconciliation::forcedSign(std::size_t request, Index neighbor) const
{
  const StarRequest& asked = this->requests_[request];
  const auto critical = this->requestAt_.find(neighbor);
  if (critical != this->requestAt_.end())
  {
    const double value = this->requests_[critical->second].value;
    const bool isAbove = value > asked.value || (value == asked.value && neighbor > asked.vertex);
    return { isAbove ? 1 : -1, critical->second };
  }
  const auto shared = this->shared_.find(neighbor);
  if (shared != this->shared_.end() && shared->second.lower >= asked.value)
  {
    return { 1, shared->second.raisedBy };
  }
  if (shared != this->shared_.end() && shared->second.upper <= asked.value)
  {
    return { -1, shared->second.loweredBy };
  }
  return {};
}

std::vector<int> Reconciliation::signsOf(std::size_t request) const
{
  const StarRequest& asked = this->requests_[request];
  const bool isSaddle = asked.type == CriticalType::Saddle;
  std::vector<int> forced;
  std::size_t other = Nobody;
  for (const Index neighbor : this->mesh_.link(asked.vertex))
  {
    const auto [sign, by] = this->forcedSign(request, neighbor);
    forced.push_back(sign);
    other = by != Nobody ? by : other;
    if (!isSaddle)
    {
      const int needed = asked.type == CriticalType::Maximum ? -1 : 1;
      if (sign == -needed)
      {
        this->refuse(request, by);
      }
      forced.back() = needed;
    }
  }
  const bool isBoundary = this->mesh_.isBoundary(asked.vertex);
  const int changes = isBoundary ? asked.multiplicity + 1 : 2 * asked.multiplicity + 2;
  std::vector<int> signs =
    closestSigns(asked.differences, forced, !isBoundary, isSaddle ? changes : 0);
  if (signs.empty() && other != Nobody)
  {
    this->refuse(request, other);
  }
  require(!signs.empty(),
    "at least " + std::to_string(changes) + " neighbors of " + this->nameOf_(request) +
      ", a saddle of multiplicity " + std::to_string(asked.multiplicity),
    std::to_string(forced.size()), "Lower its multiplicity, or refine the mesh there.");
  return signs;
}

void Reconciliation::bound(Index neighbor, std::size_t request, double difference)
{
  if (this->requestAt_.count(neighbor) > 0)
  {
    return;
  }
  SharedVertex& vertex = this->shared_[neighbor];
  const double value = this->requests_[request].value;
  require(std::isfinite(difference) && value + difference != value,
    "values far enough apart to differ around each critical point",
    textOf(difference) + " between the value " + textOf(value) + " of " + this->nameOf_(request) +
      " and a neighbor",
    "Move the point, or choose values that differ by more beside their size.");
  if (difference > 0.0 && value > vertex.lower)
  {
    vertex.lower = value;
    vertex.raisedBy = request;
  }
  if (difference < 0.0 && value < vertex.upper)
  {
    vertex.upper = value;
    vertex.loweredBy = request;
  }
  vertex.lowestWanted = std::min(vertex.lowestWanted, value + difference);
  vertex.highestWanted = std::max(vertex.highestWanted, value + difference);
}

void Reconciliation::place(std::size_t request)
{
  const std::vector<double>& wanted = this->requests_[request].differences;
  const std::vector<int> signs = this->signsOf(request);
  const double largest = std::abs(*std::max_element(
    wanted.begin(), wanted.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const VertexRange link = this->mesh_.link(this->requests_[request].vertex);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const double size = std::max(signs[i] * wanted[i], LeastDifference * largest);
    this->bound(link.begin()[i], request, signs[i] * size);
  }
}

std::vector<ValueConstraint> Reconciliation::values() const
{
  std::vector<ValueConstraint> result;
  for (const StarRequest& asked : this->requests_)
  {
    result.push_back({ asked.vertex, asked.value });
  }
  for (const auto& [vertex, shared] : this->shared_)
  {
    result.push_back({ vertex, shared.value() });
  }
  return result;
}

} // namespace

std::vector<ValueConstraint> starValues(
  const MeshTopology& mesh, const std::vector<StarRequest>& requests, const PlaceName& nameOf)
{
  Reconciliation reconciliation(mesh, requests, nameOf);
  for (const bool areSaddles : { false, true })
  {
    for (std::size_t i = 0; i < requests.size(); ++i)
    {
      if ((requests[i].type == CriticalType::Saddle) == areSaddles)
      {
        reconciliation.place(i);
      }
    }
  }
  return reconciliation.values();
}

} // namespace SurfaceScalars
