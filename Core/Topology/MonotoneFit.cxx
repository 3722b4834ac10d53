#include "MonotoneFit.h"

#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// What the vertices on ascending paths to a vertex say of it, itself included.
struct Bound
{
  double extreme = -Infinity; ///< the largest f
  double given = -Infinity;   ///< the largest f of vertices that keep it
};

/// @param sign -1 for -f in the reversed order: what the vertices above say
std::vector<Bound> boundsFromBelow(const MeshTopology& mesh, const VertexOrder& order,
  const ValuesRef& values, const ExtremumSigns& isKept, int sign, const Poll& poll)
{
  std::vector<Bound> bounds(order.size());
  for (Index count = 0; count < order.size(); ++count)
  {
    if (count % 65536 == 0)
    {
      poll();
    }
    const Index vertex = order.vertexAt(sign > 0 ? count : order.size() - 1 - count);
    Bound bound;
    bound.extreme = sign * values[vertex];
    if (isKept[vertex] != 0)
    {
      bound.given = bound.extreme;
    }
    for (const Index neighbor : mesh.link(vertex)) // no bounds yet if it is later
    {
      bound.extreme = std::max(bound.extreme, bounds[neighbor].extreme);
      bound.given = std::max(bound.given, bounds[neighbor].given);
    }
    bounds[vertex] = bound;
  }
  return bounds;
}

/// The numbers after a value, by the least step that the largest magnitude allows.
class NextNumber
{
public:
  explicit NextNumber(const Values& values)
  {
    const double largest = values.lpNorm<Eigen::Infinity>();
    this->step_ = largest > 0.0 ? largest * std::numeric_limits<double>::epsilon()
                                : std::numeric_limits<double>::min();
  }

  double operator()(double value) const
  {
    return std::max(value + this->step_, std::nextafter(value, Infinity));
  }

private:
  double step_;
};

/// Lifts each vertex above its neighbors that are before it in the order, if it is not already.
void separate(
  const MeshTopology& mesh, const VertexOrder& order, Values& values, const Execution& execution)
{
  const NextNumber nextNumber(values);
  const ValueOrder isBelow{ values.data() };
  std::vector<char> isDone(order.size(), 0);
  for (Index place = 0; place < order.size(); ++place)
  {
    if (place % 65536 == 0)
    {
      execution.report(static_cast<double>(place) / order.size());
    }
    const Index vertex = order.vertexAt(place);
    Index highest = vertex;
    for (const Index neighbor : mesh.link(vertex))
    {
      if (isDone[neighbor] != 0 && isBelow(highest, neighbor))
      {
        highest = neighbor;
      }
    }
    if (highest != vertex)
    {
      values[vertex] = nextNumber(values[highest]);
    }
    isDone[vertex] = 1;
  }
  execution.report(1.0);
}

} // namespace

Values fitMonotone(const MeshTopology& mesh, const VertexOrder& order, const ValuesRef& values,
  const ExtremumSigns& isKept, const Execution& execution)
{
  std::vector<Bound> below;
  std::vector<Bound> above;
  parallelForEach(2, execution.part(0.0, 0.6),
    [&](std::size_t which, const Poll& poll)
    {
      (which == 0 ? below : above) =
        boundsFromBelow(mesh, order, values, isKept, which == 0 ? 1 : -1, poll);
    });
  Values result(values.size());
  for (Index vertex = 0; vertex < order.size(); ++vertex)
  {
    const double most = below[vertex].extreme;
    const double least = -above[vertex].extreme;
    const double mean = most == least ? most : 0.5 * most + 0.5 * least;
    result[vertex] = std::min(std::max(mean, below[vertex].given), -above[vertex].given);
  }
  separate(mesh, order, result, execution.part(0.6, 1.0));
  return result;
}

} // namespace SurfaceScalars
