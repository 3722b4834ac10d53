#include "ConstrainedVertices.h"

#include "NumberText.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

void readConstraints(ConstrainedVertices& result, const std::vector<ValueConstraint>& constraints,
  const VertexName& nameOf)
{
  const Eigen::Index vertexCount = result.given.size();
  require(!constraints.empty(), "at least 1 constraint", "none", "Choose points and their values.");
  for (const auto& [vertex, value] : constraints)
  {
    require(vertex < vertexCount,
      "constraints at the " + std::to_string(vertexCount) + " vertices, counted from 0",
      std::to_string(vertex), "Choose existing points.");
    const std::string place = " at point " + std::to_string(nameOfVertex(vertex, nameOf));
    require(std::isfinite(value), "finite values of constraints", textOf(value) + place,
      "Correct the value.");
    int& unknown = result.unknownOfVertex[vertex];
    require(unknown != ConstrainedVertices::Fixed || result.given[vertex] == value,
      "one value at each constrained point",
      textOf(result.given[vertex]) + " and " + textOf(value) + place, "Remove one of the two.");
    unknown = ConstrainedVertices::Fixed;
    result.given[vertex] = value;
  }
  for (Eigen::Index vertex = 0; vertex < vertexCount; ++vertex)
  {
    int& unknown = result.unknownOfVertex[static_cast<std::size_t>(vertex)];
    if (unknown != ConstrainedVertices::Fixed)
    {
      unknown = static_cast<int>(result.vertices.size());
      result.vertices.push_back(static_cast<int>(vertex));
    }
  }
}

/// Otherwise any constant could be added there.
void requireConstraintInEachComponent(
  const Laplacian& laplacian, const ConstrainedVertices& constrained, const VertexName& nameOf)
{
  const std::vector<int> components = connectedComponents(laplacian.stiffness);
  const int count = 1 + *std::max_element(components.begin(), components.end());
  std::vector<char> isConstrained(static_cast<std::size_t>(count), 0);
  for (std::size_t vertex = 0; vertex < components.size(); ++vertex)
  {
    if (constrained.isFixed(vertex))
    {
      isConstrained[static_cast<std::size_t>(components[vertex])] = 1;
    }
  }
  const auto free = std::count(isConstrained.begin(), isConstrained.end(), 0);
  if (free == 0)
  {
    return;
  }
  std::size_t first = std::numeric_limits<std::size_t>::max(); // name where no value arrives
  int component = 0;
  for (std::size_t vertex = 0; vertex < components.size(); ++vertex)
  {
    const std::size_t name = nameOfVertex(static_cast<Index>(vertex), nameOf);
    if (isConstrained[static_cast<std::size_t>(components[vertex])] == 0 && name < first)
    {
      first = name;
      component = components[vertex];
    }
  }
  const auto size = std::count(components.begin(), components.end(), component);
  throw InvalidInput(
    "a constraint in each of the " + std::to_string(count) + " connected components of the surface",
    std::to_string(free) + " without one, among them that of point " + std::to_string(first) +
      " (" + std::to_string(size) + (size == 1 ? " point)" : " points)"),
    "Constrain a point of each, or raise NeighborCount if the surface is in one piece.");
}

} // namespace

ConstrainedVertices::ConstrainedVertices(const Laplacian& laplacian,
  const std::vector<ValueConstraint>& constraints, const VertexName& nameOf)
  : unknownOfVertex(static_cast<std::size_t>(laplacian.stiffness.cols()), 0)
  , given(Values::Zero(laplacian.stiffness.cols()))
{
  readConstraints(*this, constraints, nameOf);
  requireConstraintInEachComponent(laplacian, *this, nameOf);
}

Values ConstrainedVertices::extend(const std::function<Values(const Values& given)>& solve) const
{
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (Eigen::Index vertex = 0; vertex < this->given.size(); ++vertex)
  {
    if (this->isFixed(static_cast<std::size_t>(vertex)))
    {
      from = std::min(from, this->given[vertex]);
      to = std::max(to, this->given[vertex]);
    }
  }
  const double half = 0.5 * to - 0.5 * from; // the whole may be infinite
  if (!(half > 0.0))
  {
    return Values::Constant(this->given.size(), from);
  }
  Values result = this->given;
  if (!this->vertices.empty())
  {
    Values relative = (0.5 * this->given.array() - 0.5 * from) / half;
    relative(this->vertices).setZero();
    const Values unknown = solve(relative);
    result(this->vertices) = (1.0 - unknown.array()) * from + unknown.array() * to;
  }
  return result;
}

} // namespace SurfaceScalars
