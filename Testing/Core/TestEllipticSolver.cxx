#include "EllipticSolver.h"
#include "Error.h"
#include "Laplacian.h"
#include "Queries.h"
#include "Sampling.h"

#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace SurfaceScalars
{
namespace
{

using Truth::nearest;
using Truth::randomSphere;

/// shift * mass + stiffness.
RowMatrix shifted(const Laplacian& laplacian, double shift)
{
  RowMatrix matrix = laplacian.stiffness;
  for (int i = 0; i < matrix.rows(); ++i)
  {
    matrix.coeffRef(i, i) += shift * laplacian.mass[i];
  }
  return matrix;
}

Laplacian sphereLaplacian(int count)
{
  return pointSetLaplacian(
    NeighborGraph(randomSphere(count, 1), nearest(16)), LaplacianWeights::LocalScale);
}

Values randomValues(Eigen::Index count)
{
  Values values = Values::Zero(count);
  Truth::addNoise(values, 1.0, 2);
  return values;
}

double relativeError(const Values& values, const Values& exact)
{
  return (values - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
}

/// Gives up a copy, as the solver takes what it is given.
RowMatrix copyOf(const RowMatrix& matrix)
{
  return matrix;
}

// Whether mass or stiffness prevails and whether the matrix is factored or iterated, the solution
// is that of a direct method.
TEST(EllipticSolver, solvesAsADirectMethod)
{
  for (const int count : { 50, 2000, 14000 })
  {
    const Laplacian laplacian = sphereLaplacian(count);
    const Values right = laplacian.mass.cwiseProduct(randomValues(count));
    for (const double shift : { 1e-3, 1.0, 1e8 })
    {
      const RowMatrix matrix = shifted(laplacian, shift);
      const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> direct(matrix);
      const Values exact = direct.solve(right);
      EXPECT_LT(relativeError(EllipticSolver(copyOf(matrix), true).solve(right), exact), 1e-8);
      EXPECT_LT(relativeError(EllipticSolver(copyOf(matrix), false).solve(right), exact), 1e-8);
    }
  }
}

// One solver serves any number of right-hand sides; 0 has the solution 0.
TEST(EllipticSolver, solvesForSeveralRightSides)
{
  const Laplacian laplacian = sphereLaplacian(15000);
  const RowMatrix matrix = shifted(laplacian, 1.0);
  const EllipticSolver solver(copyOf(matrix), true);
  for (const bool isZero : { false, true, false })
  {
    const Values exact = isZero ? Values::Zero(15000) : randomValues(15000);
    EXPECT_LE((solver.solve(matrix * exact) - exact).lpNorm<Eigen::Infinity>(), 1e-8);
  }
}

// A matrix that is not symmetric: diffusion with a drift.
TEST(EllipticSolver, solvesWhereTheMatrixIsNotSymmetric)
{
  const Laplacian laplacian = sphereLaplacian(10000);
  RowMatrix matrix = shifted(laplacian, 1.0);
  for (int i = 0; i < matrix.rows(); ++i)
  {
    for (RowMatrix::InnerIterator entry(matrix, i); entry; ++entry)
    {
      entry.valueRef() *= entry.col() > i ? 1.1 : 1.0;
    }
    matrix.coeffRef(i, i) -= (matrix.row(i).sum() - laplacian.mass[i]);
  }
  const Values exact = randomValues(10000);
  const Values right = matrix * exact;
  EXPECT_LT(relativeError(EllipticSolver(std::move(matrix), false).solve(right), exact), 1e-7);
}

// Rows without neighbors, of very different size, in a matrix too large to be factored.
TEST(EllipticSolver, solvesADiagonalMatrix)
{
  RowMatrix matrix(20000, 20000);
  const Values exact = randomValues(20000);
  for (int i = 0; i < matrix.rows(); ++i)
  {
    matrix.insert(i, i) = std::pow(10.0, -i % 30);
  }
  const Values right = matrix * exact;
  EXPECT_LT(relativeError(EllipticSolver(std::move(matrix), true).solve(right), exact), 1e-9);
}

// The stiffness alone is singular: a sum over a closed surface that is not 0 has no solution, and
// none is made up.
TEST(EllipticSolver, refusesASingularMatrix)
{
  for (const int count : { 500, 12000 })
  {
    const RowMatrix stiffness = shifted(sphereLaplacian(count), 0.0);
    EXPECT_THROW(
      EllipticSolver(copyOf(stiffness), true).solve(Values::Constant(count, 1.0)), Error);
  }
}

} // namespace
} // namespace SurfaceScalars
