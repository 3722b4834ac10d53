#include "MorseComplex.h"

#include "NumberText.h"
#include "Require.h"
#include "TopologicalSimplification.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace SurfaceScalars
{
namespace
{

/// The steepest paths of one direction; upwards are those of -f, ties the other way round.
class SteepestPaths
{
public:
  SteepestPaths(
    const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values, bool ascending)
    : vertices_(vertices)
    , mesh_(mesh)
    , values_(values)
    , ascending_(ascending)
  {
  }

  /// From a vertex, one for each component of its lower link.
  std::vector<std::vector<Index>> pathsFrom(Index vertex) const
  {
    std::vector<std::vector<Index>> paths;
    for (const Index start : this->startsAround(vertex))
    {
      std::vector<Index> path{ vertex };
      for (Index next = start; next != path.back(); next = this->successor(next))
      {
        path.push_back(next);
      }
      paths.push_back(std::move(path));
    }
    return paths;
  }

private:
  bool isLower(Index a, Index b) const
  {
    const ValueOrder isBelow{ this->values_.data() };
    return this->ascending_ ? isBelow(b, a) : isBelow(a, b);
  }

  double slope(Index from, Index to) const
  {
    const double difference = std::abs(this->values_[from] - this->values_[to]);
    return difference > 0.0
      ? difference / (this->vertices_.col(from) - this->vertices_.col(to)).norm()
      : 0.0;
  }

  /// Whether the way from a vertex to `a` is to be preferred to the way to `b`, both lower.
  bool isSteeper(Index from, Index a, Index b) const
  {
    const double toA = this->slope(from, a);
    const double toB = this->slope(from, b);
    return toA > toB || (toA == toB && this->isLower(a, b));
  }

  /// The vertex itself if none is lower.
  Index successor(Index vertex) const
  {
    Index steepest = vertex;
    for (const Index neighbor : this->mesh_.link(vertex))
    {
      if (this->isLower(neighbor, vertex) &&
        (steepest == vertex || this->isSteeper(vertex, neighbor, steepest)))
      {
        steepest = neighbor;
      }
    }
    return steepest;
  }

  /// The steepest way into each component of the lower link of a saddle.
  std::vector<Index> startsAround(Index saddle) const
  {
    std::vector<Index> starts;
    const VertexRange link = this->mesh_.link(saddle);
    bool wasLower = false;
    for (const Index neighbor : link)
    {
      const bool isLower = this->isLower(neighbor, saddle);
      if (isLower && !wasLower)
      {
        starts.push_back(neighbor);
      }
      else if (isLower && this->isSteeper(saddle, neighbor, starts.back()))
      {
        starts.back() = neighbor;
      }
      wasLower = isLower;
    }
    const bool isClosed = !this->mesh_.isBoundary(saddle);
    if (isClosed && wasLower && this->isLower(*link.begin(), saddle)) // these two are neighbors
    {
      if (this->isSteeper(saddle, starts.back(), starts.front()))
      {
        starts.front() = starts.back();
      }
      starts.pop_back();
    }
    return starts;
  }

  const PointsRef& vertices_;
  const MeshTopology& mesh_;
  const ValuesRef& values_;
  bool ascending_;
};

std::size_t nodeAt(const std::vector<CriticalPoint>& nodes, Index vertex)
{
  const auto found = std::lower_bound(nodes.begin(), nodes.end(), vertex,
    [](const CriticalPoint& node, Index wanted) { return node.input < wanted; });
  return static_cast<std::size_t>(found - nodes.begin());
}

std::vector<Separatrix> separatricesFrom(std::size_t saddle,
  const std::vector<CriticalPoint>& nodes, const SteepestPaths& down, const SteepestPaths& up)
{
  std::vector<Separatrix> separatrices;
  for (const bool ascending : { false, true })
  {
    for (std::vector<Index>& path :
      (ascending ? up : down).pathsFrom(static_cast<Index>(nodes[saddle].input)))
    {
      const std::size_t extremum = nodeAt(nodes, path.back());
      separatrices.push_back({ saddle, extremum, ascending,
        std::abs(nodes[saddle].value - nodes[extremum].value), std::move(path) });
    }
  }
  return separatrices;
}

std::vector<Separatrix> allSeparatrices(const PointsRef& vertices, const MeshTopology& mesh,
  const MorseComplex& complex, const Execution& execution)
{
  const ValuesRef values(complex.values);
  const SteepestPaths down(vertices, mesh, values, false);
  const SteepestPaths up(vertices, mesh, values, true);
  std::vector<std::vector<Separatrix>> ofNodes(complex.nodes.size());
  parallelFor(ofNodes.size(), 256, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t node = begin; node < end; ++node)
      {
        if (complex.nodes[node].type == CriticalType::Saddle)
        {
          ofNodes[node] = separatricesFrom(node, complex.nodes, down, up);
        }
      }
    });
  std::vector<Separatrix> separatrices;
  for (std::vector<Separatrix>& some : ofNodes)
  {
    std::move(some.begin(), some.end(), std::back_inserter(separatrices));
  }
  return separatrices;
}

/// f without the extrema of less persistence.
Values withoutLesser(const MeshTopology& mesh, const ValuesRef& values,
  const std::vector<CriticalPoint>& points, double threshold, const Execution& execution)
{
  std::vector<Index> minima;
  std::vector<Index> maxima;
  for (const CriticalPoint& point : points)
  {
    if (point.type != CriticalType::Saddle && point.persistence >= threshold)
    {
      (point.type == CriticalType::Minimum ? minima : maxima)
        .push_back(static_cast<Index>(point.input));
    }
  }
  return keepExtrema(mesh, values, minima, maxima, execution);
}

} // namespace

MorseComplex morseComplex(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, double threshold, const Execution& execution)
{
  MorseComplex complex;
  complex.values = values;
  complex.nodes = meshCriticalPoints(vertices, mesh, values, execution.part(0.0, 0.4)).points;
  const double range = values.maxCoeff() - values.minCoeff();
  require(threshold >= 0.0 && threshold <= range,
    "a persistence threshold from 0 to f's range, " + textOf(range), textOf(threshold),
    "Choose another threshold.");
  if (threshold > 0.0)
  {
    complex.values =
      withoutLesser(mesh, values, complex.nodes, threshold, execution.part(0.4, 0.6));
    complex.nodes =
      meshCriticalPoints(vertices, mesh, complex.values, execution.part(0.6, 0.8)).points;
  }
  complex.separatrices = allSeparatrices(vertices, mesh, complex, execution.part(0.8, 1.0));
  return complex;
}

} // namespace SurfaceScalars
