#include "ConstrainedVertices.h"
#include "EllipticSolver.h"

#include <vector>

namespace SurfaceScalars
{
namespace
{

/// The rows and columns of the unknowns.
RowMatrix reduced(const Laplacian& laplacian, const ConstrainedVertices& unknowns)
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
      const int column = unknowns.unknownOfVertex[static_cast<std::size_t>(entry.row())];
      if (column != ConstrainedVertices::Fixed)
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
Values solve(const Laplacian& laplacian, const ConstrainedVertices& unknowns, const Values& given,
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
  const ConstrainedVertices unknowns(laplacian, constraints, nameOf);
  return unknowns.extend(
    [&](const Values& given) { return solve(laplacian, unknowns, given, execution); });
}

} // namespace SurfaceScalars
