#include "NormalOrientation.h"

#include "Orientation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t PointsPerBlock = 1024;

struct WeightedEdge
{
  float weight;
  Index from;
  Index to;

  bool operator<(const WeightedEdge& other) const
  {
    return std::tie(this->weight, this->from, this->to) <
      std::tie(other.weight, other.from, other.to);
  }
};

/// Every edge of the graph once, the smoothest first.
std::vector<WeightedEdge> sortedEdges(const NeighborGraph& graph, const Points& normals)
{
  std::vector<WeightedEdge> edges;
  for (Index from = 0; from < graph.pointCount(); ++from)
  {
    for (const Index to : graph.neighbors(from))
    {
      if (from < to || !graph.isEdge(to, from))
      {
        const double agreement = std::abs(normals.col(from).dot(normals.col(to)));
        edges.push_back({ static_cast<float>(1.0 - agreement), from, to });
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Sets of points, each with its sign relative to the root of its set.
class SignedSets
{
public:
  explicit SignedSets(Index count)
    : parents_(count)
    , isFlipped_(count, 0)
  {
    std::iota(this->parents_.begin(), this->parents_.end(), Index(0));
  }

  struct Root
  {
    Index index;
    bool isFlipped; ///< the point, against the root
  };

  Root find(Index point)
  {
    bool isFlipped = false;
    while (this->parents_[point] != point)
    {
      // Halves the path: the parent of the point becomes its grandparent.
      const Index parent = this->parents_[point];
      this->isFlipped_[point] ^= this->isFlipped_[parent];
      this->parents_[point] = this->parents_[parent];
      isFlipped ^= this->isFlipped_[point] != 0;
      point = this->parents_[point];
    }
    return { point, isFlipped };
  }

  /// @param isFlipped whether the two points are to have different signs
  void join(const Root& a, const Root& b, bool isFlipped)
  {
    this->parents_[b.index] = a.index;
    this->isFlipped_[b.index] = a.isFlipped ^ b.isFlipped ^ isFlipped ? 1 : 0;
  }

private:
  std::vector<Index> parents_;
  std::vector<char> isFlipped_; ///< against the parent; 0 at roots
};

/// Turns each component as most of its points want it.
void orientComponents(const NeighborGraph& graph, SignedSets& sets, Points& normals)
{
  std::vector<int> votes(graph.pointCount(), 0);
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    votes[sets.find(i).index] += isOutwards(graph.points().col(i), normals.col(i)) ? 1 : -1;
  }
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    if (votes[sets.find(i).index] < 0)
    {
      normals.col(i) = -normals.col(i);
    }
  }
}

} // namespace

Points estimateNormals(const NeighborGraph& graph, const FitSize& size, const Execution& execution)
{
  const Values noValues; // only the surface is wanted
  Points normals(3, graph.pointCount());
  const std::size_t count = graph.pointCount();
  parallelForEach((count + PointsPerBlock - 1) / PointsPerBlock, execution,
    [&](std::size_t block, const Poll& poll)
    {
      PolynomialNeighborhood polynomials(graph, noValues, size, 2);
      const std::size_t end = std::min(count, (block + 1) * PointsPerBlock);
      for (std::size_t i = block * PointsPerBlock; i < end; ++i)
      {
        poll(); // a large radius makes even one point slow
        const auto column = static_cast<Eigen::Index>(i);
        const bool fitted = polynomials.center(graph.points().col(column));
        normals.col(column) =
          fitted ? polynomials.fit().normal(Vector2d::Zero()) : Vector3d(Vector3d::Zero());
      }
    });
  return normals;
}

void orientNormals(const NeighborGraph& graph, Points& normals, const Execution& execution)
{
  const std::vector<WeightedEdge> edges = sortedEdges(graph, normals);
  execution.report(0.6);
  SignedSets sets(graph.pointCount());
  for (const WeightedEdge& edge : edges)
  {
    const SignedSets::Root from = sets.find(edge.from);
    const SignedSets::Root to = sets.find(edge.to);
    if (from.index != to.index)
    {
      sets.join(from, to, normals.col(edge.from).dot(normals.col(edge.to)) < 0.0);
    }
  }
  for (Index i = 0; i < graph.pointCount(); ++i)
  {
    if (sets.find(i).isFlipped)
    {
      normals.col(i) = -normals.col(i);
    }
  }
  execution.report(0.9);
  orientComponents(graph, sets, normals);
  execution.report(1.0);
}

} // namespace SurfaceScalars
