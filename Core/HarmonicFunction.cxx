#include "EllipticSolver.h"
#include "LaplacianFunctions.h"
#include "NumberText.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int Fixed = -1;

/// The vertices' values, given or not.
struct Unknowns
{
  std::vector<int> ofVertex; ///< Fixed where the value is given
  std::vector<int> vertices; ///< of the unknowns
  Values given;              ///< 0 where the value is not given
};

Unknowns unknownsOf(Eigen::Index vertexCount, const std::vector<ValueConstraint>& constraints,
  const VertexName& nameOf)
{
  require(!constraints.empty(), "at least 1 constraint", "none", "Choose points and their values.");
  Unknowns result{ std::vector<int>(static_cast<std::size_t>(vertexCount), 0), {},
    Values::Zero(vertexCount) };
  for (const auto& [vertex, value] : constraints)
  {
    require(vertex < vertexCount,
      "constraints at the " + std::to_string(vertexCount) + " vertices, counted from 0",
      std::to_string(vertex), "Choose existing points.");
    const std::string place = " at point " + std::to_string(nameOfVertex(vertex, nameOf));
    require(std::isfinite(value), "finite values of constraints", textOf(value) + place,
      "Correct the value.");
    int& unknown = result.ofVertex[vertex];
    require(unknown != Fixed || result.given[vertex] == value,
      "one value at each constrained point",
      textOf(result.given[vertex]) + " and " + textOf(value) + place, "Remove one of the two.");
    unknown = Fixed;
    result.given[vertex] = value;
  }
  for (Eigen::Index vertex = 0; vertex < vertexCount; ++vertex)
  {
    int& unknown = result.ofVertex[static_cast<std::size_t>(vertex)];
    if (unknown != Fixed)
    {
      unknown = static_cast<int>(result.vertices.size());
      result.vertices.push_back(static_cast<int>(vertex));
    }
  }
  return result;
}

/// Otherwise any constant could be added there.
void requireConstraintInEachComponent(
  const Laplacian& laplacian, const Unknowns& unknowns, const VertexName& nameOf)
{
  const std::vector<int> components = connectedComponents(laplacian.stiffness);
  const int count = 1 + *std::max_element(components.begin(), components.end());
  std::vector<char> isConstrained(static_cast<std::size_t>(count), 0);
  for (std::size_t vertex = 0; vertex < components.size(); ++vertex)
  {
    if (unknowns.ofVertex[vertex] == Fixed)
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

/// The rows and columns of the unknowns.
RowMatrix reduced(const Laplacian& laplacian, const Unknowns& unknowns)
{
  const auto count = static_cast<Eigen::Index>(unknowns.vertices.size());
  RowMatrix transposed(count, count);
  transposed.reserve(laplacian.stiffness.nonZeros());
  for (Eigen::Index row = 0; row < count; ++row)
  {
    transposed.startVec(row);
    const int vertex = unknowns.vertices[static_cast<std::size_t>(row)];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(laplacian.stiffness, vertex); entry;
         ++entry)
    {
      const int column = unknowns.ofVertex[static_cast<std::size_t>(entry.row())];
      if (column != Fixed)
      {
        transposed.insertBack(row, column) = entry.value();
      }
    }
  }
  transposed.finalize();
  if (!laplacian.symmetric)
  {
    transposed = RowMatrix(transposed.transpose());
  }
  return transposed;
}

/// The unknowns for these values at the others.
Values solve(const Laplacian& laplacian, const Unknowns& unknowns, const Values& given,
  const Execution& execution)
{
  const EllipticSolver solver(
    reduced(laplacian, unknowns), laplacian.symmetric, execution.part(0.1, 0.4));
  const Values image = laplacian.stiffness * given;
  return solver.solve(-image(unknowns.vertices), execution.part(0.4, 1.0));
}

} // namespace

Values harmonicFunction(const Laplacian& laplacian, const std::vector<ValueConstraint>& constraints,
  const Execution& execution, const VertexName& nameOf)
{
  const Unknowns unknowns = unknownsOf(laplacian.stiffness.cols(), constraints, nameOf);
  requireConstraintInEachComponent(laplacian, unknowns, nameOf);
  const auto [least, most] = std::minmax_element(constraints.begin(), constraints.end(),
    [](const ValueConstraint& a, const ValueConstraint& b) { return a.value < b.value; });
  const double from = least->value;
  const double to = most->value;
  const double half = 0.5 * to - 0.5 * from; // the whole may be infinite
  if (!(half > 0.0))
  {
    return Values::Constant(laplacian.stiffness.cols(), from);
  }
  Values result = unknowns.given;
  if (unknowns.vertices.empty())
  {
    return result;
  }
  // From 0 to 1, so that errors are small beside the difference of the values, however large those.
  Values relative = Values::Zero(result.size());
  for (const ValueConstraint& constraint : constraints)
  {
    relative[constraint.vertex] = (0.5 * constraint.value - 0.5 * from) / half;
  }
  const Values unknown = solve(laplacian, unknowns, relative, execution);
  result(unknowns.vertices) = (1.0 - unknown.array()) * from + unknown.array() * to;
  return result;
}

} // namespace SurfaceScalars
