#include "NetworkPaths.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
// Costs in diagonals of the mesh:
constexpr double SaddleToll = 20.0; // of a step in the star of a saddle, half of it around that,
constexpr double MaximumToll = 5.0; // and so on
constexpr double SideToll = 5.0;    // of one beside the network
constexpr double LeastToll = 0.3;

bool contains(const VertexRange& link, Index vertex)
{
  return std::find(link.begin(), link.end(), vertex) != link.end();
}

} // namespace

/// Dijkstra's algorithm, of which the caller says where it may go and when it ends.
class NetworkPaths::Search
{
public:
  explicit Search(const NetworkPaths& paths)
    : paths_(paths)
    , costs_(paths.values_.size(), Infinity)
    , previous_(paths.values_.size())
  {
    std::iota(this->previous_.begin(), this->previous_.end(), Index(0));
  }

  void start(Index from, Index vertex)
  {
    this->costs_[vertex] = this->paths_.stepCost(from, vertex);
    this->previous_[vertex] = from;
    this->waiting_.push({ this->costs_[vertex], vertex });
  }

  /// @param mayStep from one vertex to another
  /// @param isLast whether the search ends at a vertex
  template <class MayStep, class IsLast>
  void run(const MayStep& mayStep, const IsLast& isLast)
  {
    while (!this->waiting_.empty())
    {
      const auto [cost, vertex] = this->waiting_.top();
      this->waiting_.pop();
      if (cost > this->costs_[vertex])
      {
        continue;
      }
      this->reached_.push_back(vertex);
      if (isLast(vertex))
      {
        return;
      }
      for (const Index next : this->paths_.mesh_.topology().link(vertex))
      {
        if (cost < this->costs_[next] && mayStep(vertex, next))
        {
          const double sum = cost + this->paths_.stepCost(vertex, next);
          if (sum < this->costs_[next])
          {
            this->costs_[next] = sum;
            this->previous_[next] = vertex;
            this->waiting_.push({ sum, next });
          }
        }
      }
    }
  }

  std::vector<double>& costs() { return this->costs_; }
  std::vector<Index>& previous() { return this->previous_; }
  const std::vector<Index>& reached() const { return this->reached_; } ///< by cost

private:
  using Entry = std::pair<double, Index>;

  const NetworkPaths& paths_;
  std::vector<double> costs_;
  std::vector<Index> previous_;
  std::vector<Index> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting_;
};

NetworkPaths::NetworkPaths(const DesignMesh& mesh, const Values& values,
  const std::vector<MorsePoint>& points, const Precedence& stars, const PathCosts& costs)
  : mesh_(mesh)
  , values_(values)
  , stars_(stars)
  , leastSideToll_(costs.keepsAway ? LeastToll : 0.5 * SideToll)
  , isCritical_(values.size(), 0)
  , tolls_(values.size(), 0.0)
  , cutLocus_(mesh.topology())
{
  const Points& vertices = mesh.vertices();
  const double diagonal = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).norm();
  const double range = values.maxCoeff() - values.minCoeff();
  this->unitLength_ = 1.0 / diagonal;
  this->unitRise_ = range > 0.0 ? costs.rise / range : 0.0;
  for (const MorsePoint& point : points)
  {
    this->isCritical_[point.vertex] = 1;
    if (point.type != CriticalType::Minimum)
    {
      const bool isSaddle = point.type == CriticalType::Saddle;
      this->addTolls(
        { point.vertex }, isSaddle ? SaddleToll : MaximumToll, LeastToll, this->tolls_);
    }
  }
}

bool NetworkPaths::isOnNetwork(Index vertex) const
{
  return (*this->isInNetwork_)[vertex] != 0;
}

/// Whether a way may lead there: not to what must wait for a saddle that is to be higher.
bool NetworkPaths::isFree(Index vertex) const
{
  const std::vector<Index>& before = this->stars_.before(vertex);
  return !this->isOnNetwork(vertex) && this->isCritical_[vertex] == 0 &&
    !contains(this->mesh_.topology().link(this->saddle_), vertex) &&
    std::all_of(
      before.begin(), before.end(), [&](Index point) { return this->isOnNetwork(point); });
}

double NetworkPaths::stepCost(Index from, Index to) const
{
  const Points& vertices = this->mesh_.vertices();
  return this->tolls_[to] + this->sideTolls_[to] +
    this->unitLength_ * (vertices.col(to) - vertices.col(from)).norm() +
    this->unitRise_ * std::max(0.0, this->values_[to] - this->values_[from]);
}

/// Adds a toll to the vertices of rings around some: the further away, and the fewer vertices
/// nearer to them they are next to, the less.
void NetworkPaths::addTolls(const std::vector<Index>& centers, double toll, double leastToll,
  std::vector<double>& tolls) const
{
  std::vector<int> ringOf(tolls.size(), 0);
  std::vector<Index> ring = centers;
  std::for_each(ring.begin(), ring.end(), [&](Index center) { ringOf[center] = 1; });
  for (int number = 2; toll > leastToll; ++number, toll /= 2)
  {
    std::vector<Index> next;
    for (const Index vertex : ring)
    {
      for (const Index neighbor : this->mesh_.topology().link(vertex))
      {
        if (ringOf[neighbor] == 0)
        {
          ringOf[neighbor] = number;
          next.push_back(neighbor);
        }
        tolls[neighbor] += ringOf[neighbor] == number ? toll : 0.0;
      }
    }
    ring = std::move(next);
  }
}

/// Of the last step onto the network; infinite where that is no descent.
double NetworkPaths::endCost(Index vertex, Index end) const
{
  const std::vector<Index>& before = this->stars_.before(end);
  if (end == this->saddle_ ||
    (this->isCritical_[end] != 0 &&
      std::find(before.begin(), before.end(), vertex) != before.end()))
  {
    return Infinity;
  }
  return this->unitRise_ *
    (std::max(0.0, this->values_[end] - this->values_[vertex]) +
      std::max(0.0, this->values_[end] - this->values_[this->saddle_]));
}

/// Makes the tree span what no way may lead to.
void NetworkPaths::spanRest(std::vector<Index> reached)
{
  std::vector<char> isSpanned(this->previous_.size(), 0);
  for (const Index vertex : reached)
  {
    isSpanned[vertex] = 1;
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const Index next : this->mesh_.topology().link(reached[i]))
    {
      if (isSpanned[next] == 0 && !this->isOnNetwork(next))
      {
        isSpanned[next] = 1;
        this->previous_[next] = reached[i];
        reached.push_back(next);
      }
    }
  }
}

void NetworkPaths::search(Index saddle, const std::vector<Index>& sector,
  const std::vector<char>& isInNetwork, const std::vector<Index>& obstacles,
  const Execution& execution)
{
  this->saddle_ = saddle;
  this->isInNetwork_ = &isInNetwork;
  std::vector<Index> network;
  for (Index vertex = 0; vertex < isInNetwork.size(); ++vertex)
  {
    if (isInNetwork[vertex] != 0 && vertex != saddle)
    {
      network.push_back(vertex);
    }
  }
  this->sideTolls_.assign(isInNetwork.size(), 0.0);
  this->addTolls(network, SideToll, this->leastSideToll_, this->sideTolls_);
  Search ways(*this);
  for (const Index neighbor : sector)
  {
    ways.start(saddle, neighbor);
  }
  ways.run([&](Index, Index to) { return this->isFree(to); }, [](Index) { return false; });
  execution.report(0.0);
  this->costs_ = std::move(ways.costs());
  this->previous_ = std::move(ways.previous());
  this->spanRest(ways.reached());
  this->cutLocus_.find(isInNetwork, this->previous_, obstacles);
  this->collectCrossings();
}

/// Of each chain the cheapest onto the network, and the cheapest within the tree, either way.
void NetworkPaths::collectCrossings()
{
  this->crossings_.clear();
  for (const std::vector<MeshEdge>& chain : this->cutLocus_.chains())
  {
    Crossing onto{ {}, Infinity };
    Crossing within{ {}, Infinity };
    for (MeshEdge edge : chain)
    {
      if (this->isOnNetwork(edge.from))
      {
        std::swap(edge.from, edge.to);
      }
      const bool isOnto = this->isOnNetwork(edge.to);
      const double cost = this->costs_[edge.from] +
        (isOnto ? this->endCost(edge.from, edge.to) : this->costs_[edge.to]);
      Crossing& best = isOnto ? onto : within;
      if (cost < best.cost)
      {
        best = { edge, cost };
      }
    }
    const Crossing back{ { within.edge.to, within.edge.from }, within.cost };
    for (const Crossing& crossing : { onto, within, back })
    {
      if (crossing.cost < Infinity)
      {
        this->crossings_.push_back(crossing);
      }
    }
  }
  std::stable_sort(this->crossings_.begin(), this->crossings_.end(),
    [](const Crossing& a, const Crossing& b) { return a.cost < b.cost; });
}

/// From the saddle on.
std::vector<Index> NetworkPaths::wayTo(Index vertex) const
{
  std::vector<Index> result;
  for (; vertex != this->saddle_; vertex = this->previous_[vertex])
  {
    result.push_back(vertex);
  }
  std::reverse(result.begin(), result.end());
  return result;
}

NetworkPath NetworkPaths::path(const Crossing& crossing, bool isNarrow)
{
  const auto [from, to] = crossing.edge;
  NetworkPath result{ this->wayTo(from), to };
  if (this->isOnNetwork(to))
  {
    return result;
  }
  std::unordered_set<Index> taken(result.vertices.begin(), result.vertices.end());
  for (const Index vertex : result.vertices)
  {
    const VertexRange link = this->mesh_.topology().link(vertex);
    taken.insert(link.begin(), link.end());
  }
  const auto isBarred = [&](Index one, Index other) {
    return isNarrow && this->cutLocus_.isCrossed({ one, other });
  };
  const auto findEnd = [&](Index vertex)
  {
    for (const Index end : this->mesh_.topology().link(vertex))
    {
      if (this->isOnNetwork(end) && !isBarred(vertex, end) && this->endCost(vertex, end) < Infinity)
      {
        result.end = end;
        return true;
      }
    }
    return false;
  };
  const std::vector<double> sideTolls = this->sideTolls_;
  this->addTolls(result.vertices, SideToll, this->leastSideToll_, this->sideTolls_);
  Search back(*this);
  back.start(from, to);
  back.run([&](Index one, Index other)
    { return this->isFree(other) && taken.count(other) == 0 && !isBarred(one, other); },
    findEnd);
  this->sideTolls_ = sideTolls;
  if (back.reached().empty() || result.end == to)
  {
    return {};
  }
  std::vector<Index> rest;
  for (Index vertex = back.reached().back(); vertex != from; vertex = back.previous()[vertex])
  {
    rest.push_back(vertex);
  }
  result.vertices.insert(result.vertices.end(), rest.rbegin(), rest.rend());
  return result;
}

} // namespace SurfaceScalars
