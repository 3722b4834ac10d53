#include "EvenChanges.h"

#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr double Margin = 0.05; // of the room between neighbors, left on each side
constexpr int Sweeps = 60;

/// The value of a vertex in the next sweep.
double movedValue(const MeshTopology& mesh, const ValuesRef& f, const Values& values, Index vertex)
{
  const ValueOrder isBelow{ values.data() };
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double change = 0.0;
  const VertexRange link = mesh.link(vertex);
  for (const Index neighbor : link)
  {
    if (isBelow(neighbor, vertex))
    {
      lower = std::max(lower, values[neighbor]);
    }
    else
    {
      upper = std::min(upper, values[neighbor]);
    }
    change += (values[neighbor] - f[neighbor]) / link.size();
  }
  const double room = Margin * (upper - lower);
  const bool hasRoom = std::isfinite(room) && lower + room > lower && upper - room < upper;
  return hasRoom ? std::clamp(f[vertex] + change, lower + room, upper - room) : values[vertex];
}

} // namespace

Values withEvenChanges(const MeshTopology& mesh, const ValuesRef& f, Values fitted,
  const ExtremumSigns& isKept, const Execution& execution)
{
  for (int sweep = 0; sweep < Sweeps; ++sweep)
  {
    execution.report(static_cast<double>(sweep) / Sweeps);
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    {
      if (isKept[vertex] == 0)
      {
        fitted[vertex] = movedValue(mesh, f, fitted, vertex);
      }
    }
  }
  return fitted;
}

} // namespace SurfaceScalars
