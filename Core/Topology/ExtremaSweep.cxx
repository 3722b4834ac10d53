#include "ExtremaSweep.h"

#include "PitOrder.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <queue>

namespace SurfaceScalars
{
namespace
{

constexpr int NaturalSweeps = 4; // an even number; more take only narrow strips

/// One sweep upwards. Downwards is upwards in the reversed order.
class ExtremaSweep
{
public:
  /// @param pitOrder for pits, or null to visit the lowest of a pit first
  ExtremaSweep(const MeshTopology& mesh, const VertexOrder& order, std::vector<char> isFirst,
    PitOrder* pitOrder, const Execution& execution)
    : mesh_(mesh)
    , order_(order)
    , execution_(execution)
    , isReached_(std::move(isFirst))
  {
    this->visited_.reserve(order.size());
    for (Index place = 0; place < order.size(); ++place)
    {
      if (this->isReached_[order.vertexAt(place)] != 0) // otherwise it is in a pit
      {
        this->visit(place, place);
        const std::size_t first = this->visited_.size();
        this->fillPit(place);
        if (pitOrder && this->visited_.size() > first)
        {
          pitOrder->sort(order.vertexAt(place), this->visited_, first);
        }
      }
    }
  }

  /// The vertices in the order in which they were visited; to be taken once.
  std::vector<Index> takeVisited() { return std::move(this->visited_); }

  bool foundPits() const { return this->foundPits_; }

private:
  /// @param level up to here all vertices outside pits are visited
  void visit(Index place, Index level)
  {
    if (this->visited_.size() % 65536 == 0)
    {
      this->execution_.report(
        static_cast<double>(this->visited_.size()) / static_cast<double>(this->order_.size()));
    }
    const Index vertex = this->order_.vertexAt(place);
    this->visited_.push_back(vertex);
    for (const Index neighbor : this->mesh_.link(vertex))
    {
      if (this->isReached_[neighbor] == 0)
      {
        this->isReached_[neighbor] = 1;
        if (this->order_.placeOf(neighbor) < level)
        {
          this->pit_.push(this->order_.placeOf(neighbor));
        }
      }
    }
  }

  void fillPit(Index level)
  {
    while (!this->pit_.empty())
    {
      this->foundPits_ = true;
      const Index lowest = this->pit_.top();
      this->pit_.pop();
      this->visit(lowest, level);
    }
  }

  const MeshTopology& mesh_;
  const VertexOrder& order_;
  const Execution& execution_;
  std::vector<char> isReached_;
  std::vector<Index> visited_;
  std::priority_queue<Index, std::vector<Index>, std::greater<>> pit_; ///< places
  bool foundPits_ = false;
};

/// Flags of the vertices with that sign.
std::vector<char> withSign(const ExtremumSigns& signs, int sign)
{
  std::vector<char> flags(signs.size());
  std::transform(signs.begin(), signs.end(), flags.begin(),
    [=](signed char given) { return static_cast<char>(given == sign ? 1 : 0); });
  return flags;
}

} // namespace

VertexOrder orderWithExtrema(const MeshTopology& mesh, VertexOrder order,
  const ExtremumSigns& signs, const Execution& execution)
{
  int sign = 1;
  for (int done = 0; done < NaturalSweeps + 2; ++done)
  {
    std::unique_ptr<PitOrder> pitOrder;
    if (done >= NaturalSweeps)
    {
      pitOrder = std::make_unique<PitOrder>(mesh, withSign(signs, -sign));
    }
    ExtremaSweep sweep(mesh, order, withSign(signs, sign), pitOrder.get(),
      execution.part(done / (done + 1.0), (done + 1.0) / (done + 2.0)));
    if (done > 0 && !sweep.foundPits())
    {
      return sign > 0 ? std::move(order) : order.reversed();
    }
    std::vector<Index> visited = sweep.takeVisited();
    std::reverse(visited.begin(), visited.end());
    order = VertexOrder(std::move(visited));
    sign = -sign;
  }
  return order;
}

} // namespace SurfaceScalars
