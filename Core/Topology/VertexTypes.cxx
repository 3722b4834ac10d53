#include "MeshCriticalPoints.h"
#include "MeshValues.h"
#include "NumberText.h"
#include "Require.h"
#include "ValueOrder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 16384;

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
    const Index ab = value[a] <= value[b] ? 1 : 0;
    const Index bc = value[b] <= value[c] ? 1 : 0;
    const Index ac = value[a] <= value[c] ? 1 : 0;
    const Index chooseOuter = 0u - (ab ^ bc); // all bits or none: noise makes branches slow
    const Index chooseFirst = 0u - (ab ^ ac);
    ++counts[b ^ ((b ^ c ^ ((a ^ c) & chooseFirst)) & chooseOuter)];
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

/// From the changes of sign in place of the multiplicities. Extrema are looked at in a second pass:
/// where they are cannot be foreseen.
CriticalCounts concludeTypes(
  const MeshTopology& mesh, const ValuesRef& values, Index begin, Index end, VertexTypes& result)
{
  Index* const changes = result.multiplicities.data();
  for (Index vertex = begin; vertex < end && !mesh.isClosed(); ++vertex)
  {
    changes[vertex] *= mesh.isBoundary(vertex) ? 2 : 1; // as if the mesh met its mirror image
  }
  std::vector<Index> extrema(end - begin);
  std::size_t extremumCount = 0;
  for (Index vertex = begin; vertex < end; ++vertex)
  {
    extrema[extremumCount] = vertex;
    extremumCount += changes[vertex] == 0 ? 1 : 0;
  }
  CriticalCounts counts;
  for (Index vertex = begin; vertex < end; ++vertex)
  {
    const auto half = static_cast<std::int32_t>(changes[vertex]) / 2;
    const std::int32_t multiplicity = half - (half > 0 ? 1 : 0);
    result.multiplicities[vertex] = static_cast<Index>(multiplicity);
    result.types[vertex] = multiplicity > 0 ? CriticalType::Saddle : CriticalType::Regular;
    counts.saddles += static_cast<Index>(multiplicity);
  }
  const ValueOrder isBelow{ values.data() };
  for (std::size_t i = 0; i < extremumCount; ++i)
  {
    const Index vertex = extrema[i];
    const bool isMinimum = isBelow(vertex, *mesh.linkPath(vertex).begin());
    result.types[vertex] = isMinimum ? CriticalType::Minimum : CriticalType::Maximum;
    result.multiplicities[vertex] = 1;
    counts.minima += isMinimum ? 1 : 0;
    counts.maxima += isMinimum ? 0 : 1;
  }
  return counts;
}

} // namespace

void checkVertexValues(Index vertexCount, const ValuesRef& values, const VertexName& nameOf)
{
  require(values.size() == vertexCount, "one value per vertex",
    std::to_string(values.size()) + " values for " + std::to_string(vertexCount) + " vertices",
    "Choose another array.");
  if (!std::isfinite((0.0 * values).sum()))
  {
    const double* bad = std::find_if_not(values.data(), values.data() + values.size(),
      [](double value) { return std::isfinite(value); });
    throw InvalidInput("finite values",
      textOf(*bad) + " at vertex " +
        std::to_string(nameOfVertex(static_cast<Index>(bad - values.data()), nameOf)),
      "Fill in missing values or choose another array.");
  }
}

void checkVertexPlaces(Index vertexCount, const PointsRef& places, const std::string& of)
{
  require(places.cols() == vertexCount, "one place per vertex",
    std::to_string(places.cols()) + " places for " + std::to_string(vertexCount) + " vertices",
    "Choose the vertices of the " + of + ".");
}

void checkValueRange(const ValuesRef& values)
{
  require(std::isfinite(values.maxCoeff() - values.minCoeff()), "values of finite range",
    textOf(values.minCoeff()) + " to " + textOf(values.maxCoeff()), "Choose another unit.");
}

VertexTypes classifyVertices(
  const MeshTopology& mesh, const ValuesRef& values, const Execution& execution)
{
  checkVertexValues(mesh.vertexCount(), values);
  VertexTypes result;
  result.types.resize(mesh.vertexCount());
  result.multiplicities = middleCounts(mesh, values, execution.part(0.0, 0.8));
  std::mutex mutex; // for result.counts
  parallelFor(mesh.vertexCount(), Grain, execution.part(0.8, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      const CriticalCounts counts =
        concludeTypes(mesh, values, static_cast<Index>(begin), static_cast<Index>(end), result);
      const std::lock_guard<std::mutex> lock(mutex);
      result.counts.minima += counts.minima;
      result.counts.saddles += counts.saddles;
      result.counts.maxima += counts.maxima;
    });
  return result;
}

} // namespace SurfaceScalars
