#include "MeshCriticalPoints.h"
#include "MeshValues.h"
#include "NumberText.h"
#include "Require.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 65536;

/// Adds to each vertex in how many of these triangles it is in the middle. Sorted by index, two
/// corners are in order of value, ties by index, if the value does not fall: no case of its own.
void countMiddles(const MeshTopology& mesh, const double* value, Eigen::Index begin,
  Eigen::Index end, std::vector<Index>& counts)
{
  for (Eigen::Index t = begin; t < end; ++t)
  {
    const Index* corners = mesh.triangles().col(t).data();
    const Index low = std::min(corners[0], corners[1]);
    const Index high = std::max(corners[0], corners[1]);
    const Index a = std::min(low, corners[2]);
    const Index b = std::min(high, std::max(low, corners[2]));
    const Index c = std::max(high, corners[2]);
    const bool ab = value[a] <= value[b];
    const bool bc = value[b] <= value[c];
    const bool ac = value[a] <= value[c];
    const Index first = ab == ac ? c : a;
    ++counts[ab == bc ? b : first];
  }
}

/// In how many triangles each vertex is in the middle. Threads count in arrays of their own.
std::vector<Index> middleCounts(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution)
{
  const Eigen::Index triangleCount = mesh.triangles().cols();
  const Eigen::Index half = execution.threadCount == 1 ? triangleCount : triangleCount / 2;
  std::vector<Index> counts(mesh.vertexCount(), 0);
  std::vector<Index> others(half < triangleCount ? mesh.vertexCount() : 0, 0);
  parallelForEach(2, execution.part(0.0, 0.8),
    [&](std::size_t which, const Poll& poll)
    {
      const Eigen::Index last = which == 0 ? half : triangleCount;
      for (Eigen::Index begin = which == 0 ? 0 : half; begin < last; begin += Grain)
      {
        poll();
        countMiddles(mesh, values.data(), begin,
          std::min<Eigen::Index>(last, begin + static_cast<Eigen::Index>(Grain)),
          which == 0 ? counts : others);
      }
    });
  std::transform(others.begin(), others.end(), counts.begin(), counts.begin(), std::plus<>());
  return counts;
}

} // namespace

void checkMeshValues(const MeshTopology& mesh, const ValuesRef& values)
{
  require(values.size() == mesh.vertexCount(), "one value per vertex",
    std::to_string(values.size()) + " values for " + std::to_string(mesh.vertexCount()) +
      " vertices",
    "Choose another array.");
  if (!values.allFinite())
  {
    const double* bad = std::find_if_not(values.data(), values.data() + values.size(),
      [](double value) { return std::isfinite(value); });
    throw InvalidInput("finite values",
      textOf(*bad) + " at vertex " + std::to_string(bad - values.data()),
      "Fill in missing values or choose another array.");
  }
}

VertexTypes classifyVertices(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution)
{
  checkMeshValues(mesh, values);
  VertexTypes result;
  result.types.resize(mesh.vertexCount());
  result.multiplicities = middleCounts(mesh, values, execution.part(0.0, 0.8));
  const ValueOrder isBelow{ values.data() };
  std::mutex mutex; // for result.counts
  parallelFor(mesh.vertexCount(), Grain, execution.part(0.8, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      CriticalCounts counts;
      for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      {
        CriticalType& type = result.types[vertex];
        Index& multiplicity = result.multiplicities[vertex]; // as yet the changes of sign
        if (multiplicity == 0)
        {
          const bool isMinimum = isBelow(vertex, *mesh.linkPath(vertex).begin());
          type = isMinimum ? CriticalType::Minimum : CriticalType::Maximum;
          multiplicity = 1;
          ++(isMinimum ? counts.minima : counts.maxima);
          continue;
        }
        const bool isInside = mesh.isClosed() || !mesh.isBoundary(vertex);
        multiplicity = (isInside ? multiplicity / 2 : multiplicity) - 1;
        type = multiplicity > 0 ? CriticalType::Saddle : CriticalType::Regular;
        counts.saddles += multiplicity;
      }
      const std::lock_guard<std::mutex> lock(mutex);
      result.counts.minima += counts.minima;
      result.counts.saddles += counts.saddles;
      result.counts.maxima += counts.maxima;
    });
  return result;
}

} // namespace SurfaceScalars
