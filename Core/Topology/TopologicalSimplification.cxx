#include "TopologicalSimplification.h"

#include "MeshValues.h"
#include "MonotoneFit.h"
#include "NumberText.h"
#include "Require.h"

#include <algorithm>
#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

std::string kindOf(int sign)
{
  return sign > 0 ? "minimum" : "maximum";
}

/// The extrema asked for, checked.
class AskedExtrema
{
public:
  AskedExtrema(const MeshTopology& mesh, const VertexName& nameOf)
    : mesh_(mesh)
    , nameOf_(nameOf)
    , signs_(mesh.vertexCount(), 0)
  {
  }

  /// @param sign 1 for minima, -1 for maxima
  void add(const std::vector<Index>& vertices, signed char sign)
  {
    std::vector<char> hasSome(this->mesh_.componentCount(), 0);
    for (const Index vertex : vertices)
    {
      this->requireVacant(vertex, sign);
      this->signs_[vertex] = sign;
      hasSome[this->mesh_.component(vertex)] = 1;
    }
    for (Index vertex = 0; vertex < this->mesh_.vertexCount(); ++vertex)
    {
      if (hasSome[this->mesh_.component(vertex)] == 0)
      {
        throw InvalidInput(
          "at least one " + kindOf(sign) + " to be kept in each connected component",
          "none in that of vertex " + this->nameOf(vertex),
          "Keep at least its global " + kindOf(sign) + ".");
      }
    }
  }

  const ExtremumSigns& signs() const { return this->signs_; }

private:
  std::string nameOf(Index vertex) const
  {
    return std::to_string(nameOfVertex(vertex, this->nameOf_));
  }

  void requireVacant(Index vertex, int sign) const
  {
    const Index count = this->mesh_.vertexCount();
    if (vertex >= count)
    {
      throw InvalidInput(
        "a " + kindOf(sign) + " to be kept among the " + std::to_string(count) + " vertices",
        "vertex " + std::to_string(vertex), "Leave it out.");
    }
    if (this->signs_[vertex] == -sign)
    {
      throw InvalidInput("a vertex to be kept either as minimum or as maximum",
        "vertex " + this->nameOf(vertex) + " for both", "Leave it out of one.");
    }
    for (const Index neighbor : this->mesh_.link(vertex))
    {
      if (this->signs_[neighbor] == sign)
      {
        throw InvalidInput("no two neighbors to be kept as " + kindOf(sign),
          "vertices " + this->nameOf(neighbor) + " and " + this->nameOf(vertex), "Leave one out.");
      }
    }
  }

  const MeshTopology& mesh_;
  const VertexName& nameOf_;
  ExtremumSigns signs_;
};

void checkValues(const MeshTopology& mesh, const ValuesRef& values)
{
  constexpr double Largest = 0.5 * std::numeric_limits<double>::max();
  checkVertexValues(mesh.vertexCount(), values);
  const double largest = values.lpNorm<Eigen::Infinity>();
  require(largest <= Largest, "values of at most " + textOf(Largest) + " in magnitude",
    textOf(largest), "Scale the values down.");
}

/// Lowers given minima to their lowest neighbors and lifts given maxima to their highest: in the
/// order of the result, ties by sign, they are extrema.
Values withExtrema(const MeshTopology& mesh, const ValuesRef& values, const ExtremumSigns& signs)
{
  Values result = values;
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    if (const double sign = signs[vertex]; sign != 0.0)
    {
      for (const Index neighbor : mesh.link(vertex))
      {
        result[vertex] = sign * std::min(sign * result[vertex], sign * values[neighbor]);
      }
    }
  }
  return result;
}

} // namespace

Values keepExtrema(const MeshTopology& mesh, const ValuesRef& values,
  const std::vector<Index>& minima, const std::vector<Index>& maxima, const Execution& execution,
  const VertexName& nameOf)
{
  checkValues(mesh, values);
  AskedExtrema asked(mesh, nameOf);
  asked.add(minima, 1);
  asked.add(maxima, -1);
  const ExtremumSigns& signs = asked.signs();
  const Values start = withExtrema(mesh, values, signs);
  const VertexOrder order = orderWithExtrema(
    mesh, orderByValue(start, signs, execution.part(0.0, 0.2)), signs, execution.part(0.2, 0.7));
  return fitMonotone(mesh, order, start, signs, execution.part(0.7, 1.0));
}

} // namespace SurfaceScalars
