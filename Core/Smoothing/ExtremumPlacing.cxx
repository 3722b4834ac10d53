#include "ExtremumPlacing.h"

#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

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

/// The ends of their steps, but for those that share one and those that would not be near.
template <class Order, class Nearness>
std::vector<Index> movedAlong(const MeshTopology& mesh, const std::vector<Index>& vertices,
  const Order& isBefore, const Nearness& isNear)
{
  std::vector<Index> result;
  std::map<Index, int> arrivals;
  for (const Index vertex : vertices)
  {
    result.push_back(endOfSteps(mesh, vertex, isBefore));
    ++arrivals[result.back()];
  }
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    result[i] =
      arrivals[result[i]] == 1 && isNear(vertices[i], result[i]) ? result[i] : vertices[i];
  }
  return result;
}

/// How many of the extrema are at each vertex.
class Occupation
{
public:
  Occupation(const MeshTopology& mesh, const ExtremalVertices& extrema)
    : mesh_(mesh)
    , minima_(mesh.vertexCount(), 0)
    , maxima_(mesh.vertexCount(), 0)
  {
    count(extrema.minima, this->minima_);
    count(extrema.maxima, this->maxima_);
  }

  /// Takes minima back to where they were that share their vertex or have a minimum next to them.
  bool undoMinima(std::vector<Index>& moved, const std::vector<Index>& before)
  {
    return this->undo(moved, before, this->minima_, this->maxima_);
  }

  bool undoMaxima(std::vector<Index>& moved, const std::vector<Index>& before)
  {
    return this->undo(moved, before, this->maxima_, this->minima_);
  }

private:
  static void count(const std::vector<Index>& vertices, std::vector<int>& counts)
  {
    for (const Index vertex : vertices)
    {
      ++counts[vertex];
    }
  }

  bool undo(std::vector<Index>& moved, const std::vector<Index>& before, std::vector<int>& same,
    const std::vector<int>& others) const
  {
    bool isUndone = false;
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      const VertexRange link = this->mesh_.link(moved[i]);
      const bool isAlone = same[moved[i]] == 1 && others[moved[i]] == 0 &&
        std::none_of(link.begin(), link.end(), [&](Index neighbor) { return same[neighbor] != 0; });
      if (moved[i] != before[i] && !isAlone)
      {
        --same[moved[i]];
        moved[i] = before[i];
        ++same[moved[i]];
        isUndone = true;
      }
    }
    return isUndone;
  }

  const MeshTopology& mesh_;
  std::vector<int> minima_;
  std::vector<int> maxima_;
};

/// Undoes moves until keepExtrema() can keep all: as it could before any move.
ExtremalVertices withoutClashes(
  const MeshTopology& mesh, ExtremalVertices moved, const ExtremalVertices& before)
{
  Occupation occupation(mesh, moved);
  for (bool isUndone = true; isUndone;)
  {
    isUndone = occupation.undoMinima(moved.minima, before.minima);
    isUndone = occupation.undoMaxima(moved.maxima, before.maxima) || isUndone;
  }
  return moved;
}

ExtremalVertices movedFurther(const NoisyFunction& function, const ExtremalVertices& extrema,
  const Values& further, double tolerance)
{
  const ValueOrder isBelow{ further.data() };
  const auto isAbove = [&](Index a, Index b) { return isBelow(b, a); };
  const auto isNear = [&](Index a, Index b)
  { return std::abs(function.smooth[a] - function.smooth[b]) <= tolerance; };
  return withoutClashes(function.mesh,
    { movedAlong(function.mesh, extrema.minima, isBelow, isNear),
      movedAlong(function.mesh, extrema.maxima, isAbove, isNear) },
    extrema);
}

ExtremalVertices fitted(const NoisyFunction& function, const ExtremalVertices& extrema,
  double tolerance, const Execution& execution)
{
  ExtremalVertices result = extrema;
  const std::size_t minimaCount = extrema.minima.size();
  parallelForEach(minimaCount + extrema.maxima.size(), execution,
    [&](std::size_t i, const Poll& poll)
    {
      const bool isMinimum = i < minimaCount;
      Index& vertex = isMinimum ? result.minima[i] : result.maxima[i - minimaCount];
      vertex = fittedExtremum(function, vertex, tolerance, isMinimum ? -1.0 : 1.0, poll);
    });
  return withoutClashes(function.mesh, std::move(result), extrema);
}

} // namespace

ExtremalVertices placed(const NoisyFunction& function, const ExtremalVertices& extrema,
  const Values& further, double tolerance, const Execution& execution)
{
  ExtremalVertices result =
    fitted(function, movedFurther(function, extrema, further, tolerance), tolerance, execution);
  std::sort(result.minima.begin(), result.minima.end());
  std::sort(result.maxima.begin(), result.maxima.end());
  return result;
}

} // namespace SurfaceScalars
