#include "MorseSweep.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace SurfaceScalars
{
namespace
{

class MorseSweep
{
public:
  MorseSweep(const MeshTopology& mesh, const VertexOrder& order,
    const std::vector<MorsePoint>& points, const MorseNetwork& network)
    : mesh_(mesh)
    , order_(order)
    , precedence_(network.precedence)
    , isInNetwork_(network.isInNetwork)
    , isCritical_(mesh.vertexCount(), 0)
    , isInside_(mesh.vertexCount(), 0)
  {
    for (const MorsePoint& point : points)
    {
      this->isCritical_[point.vertex] = 1;
      if (point.type == CriticalType::Minimum)
      {
        this->waiting_.push(order.placeOf(point.vertex));
      }
    }
  }

  /// @returns the vertices in the order in which they were added
  std::vector<Index> grow(const Execution& execution);

private:
  bool isNext(Index vertex) const;
  bool isRegular(Index vertex) const;

  const MeshTopology& mesh_;
  const VertexOrder& order_;
  const Precedence& precedence_;
  const std::vector<char>& isInNetwork_;
  std::vector<char> isCritical_;
  std::vector<char> isInside_;
  std::priority_queue<Index, std::vector<Index>, std::greater<>> waiting_; ///< places
};

/// How many runs of its link have the property; 0 if all of it has.
template <class Property>
Index runsOf(const MeshTopology& mesh, Index vertex, const Property& isSuch)
{
  const VertexRange path = mesh.linkPath(vertex);
  Index result = 0;
  for (const Index* next = path.begin() + 1; next != path.end(); ++next)
  {
    result += !isSuch(next[-1]) && isSuch(*next) ? 1 : 0;
  }
  return result;
}

/// Whether the region can grow over it and remain what it is, and the disks beside the network,
/// too.
bool MorseSweep::isRegular(Index vertex) const
{
  const auto isInside = [&](Index v) { return this->isInside_[v] != 0; };
  const auto isInDisk = [&](Index v) { return !isInside(v) && this->isInNetwork_[v] == 0; };
  return runsOf(this->mesh_, vertex, isInside) == 1 &&
    (this->isInNetwork_[vertex] != 0 || runsOf(this->mesh_, vertex, isInDisk) == 1);
}

bool MorseSweep::isNext(Index vertex) const
{
  if (this->isInside_[vertex] != 0)
  {
    return false;
  }
  const std::vector<Index>& before = this->precedence_.before(vertex);
  const bool isWaiting = std::any_of(
    before.begin(), before.end(), [&](Index first) { return this->isInside_[first] == 0; });
  return !isWaiting && (this->isCritical_[vertex] != 0 || this->isRegular(vertex));
}

std::vector<Index> MorseSweep::grow(const Execution& execution)
{
  std::vector<Index> result;
  while (!this->waiting_.empty())
  {
    const Index vertex = this->order_.vertexAt(this->waiting_.top());
    this->waiting_.pop();
    if (!this->isNext(vertex)) // it comes again with its next neighbor
    {
      continue;
    }
    if (result.size() % 65536 == 0)
    {
      execution.report(static_cast<double>(result.size()) / this->mesh_.vertexCount());
    }
    this->isInside_[vertex] = 1;
    result.push_back(vertex);
    for (const Index neighbor : this->mesh_.link(vertex))
    {
      if (this->isNext(neighbor))
      {
        this->waiting_.push(this->order_.placeOf(neighbor));
      }
    }
  }
  return result;
}

} // namespace

std::optional<VertexOrder> sweepWithPoints(const MeshTopology& mesh,
  const std::vector<MorsePoint>& points, const MorseNetwork& network, const Execution& execution)
{
  const VertexOrder order =
    orderByValue(network.heights, ExtremumSigns(mesh.vertexCount(), 0), execution.part(0.0, 0.3));
  std::vector<Index> ascending =
    MorseSweep(mesh, order, points, network).grow(execution.part(0.3, 1.0));
  if (ascending.size() != mesh.vertexCount())
  {
    return std::nullopt;
  }
  return VertexOrder(std::move(ascending));
}

} // namespace SurfaceScalars
